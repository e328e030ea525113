class_name BankShotModel
extends LessonModel
## A ball that has to reach a target after some bounces off walls. Lengths are in pixels.

## How the drawing is built up: the task; the walls moved by r; the image of the target; the bounce
## and the way; all orders of walls; the shot.
enum Step { TASK, MOVED_WALL, IMAGE, BOUNCE, ORDERS, FIRE }

## No coordinate is larger than this.
const LARGEST := 1e6
## A radius is from here to [constant LARGEST_RADIUS].
const SMALLEST_RADIUS := 0.01
const LARGEST_RADIUS := 1e4
## No wall is shorter than this.
const SHORTEST := 0.01
## C is from here to 1: with C = 0 no image is far enough away.
const LEAST_BOUNCINESS := 0.05
## There are at most so many walls, and so many bounces.
const MOST_WALLS := 4
const MOST_BOUNCES := 3

# Along a wall the point of the moved one is here at which r can be dragged.
const _GRIP := 0.85

## Presets by their titles (source text): what each changes in the model's state.
const PRESETS: Dictionary[String, Dictionary] = {
	"One bounce":
	{
		start = [100, 100],
		target = [300, 160],
		radius = 20.0,
		bounciness = 1.0,
		bounces = 1,
		walls = [[20, 300, 440, 300], [200, 200, 200, 40]],
	},
	"C = 0.5":
	{
		start = [100, 100],
		target = [300, 160],
		radius = 20.0,
		bounciness = 0.5,
		bounces = 1,
		walls = [[20, 300, 440, 300], [200, 200, 200, 40]],
	},
	"Slanted pair":
	{
		start = [60, 60],
		target = [190, 60],
		radius = 10.0,
		bounciness = 1.0,
		bounces = 2,
		walls = [[0, 280, 320, 240], [350, 250, 310, 20], [110, 80, 110, 0]],
	},
	"Right angle":
	{
		start = [60, 60],
		target = [160, 60],
		radius = 10.0,
		bounciness = 1.0,
		bounces = 2,
		walls = [[0, 260, 320, 260], [340, 240, 340, 20], [110, 80, 110, 0]],
	},
	"Three bounces":
	{
		start = [40, 80],
		target = [360, 120],
		radius = 10.0,
		bounciness = 1.0,
		bounces = 3,
		walls = [[0, 0, 400, 20], [0, 240, 400, 230], [200, 170, 200, 60]],
	},
	"No way":
	{
		start = [100, 100],
		target = [300, 160],
		radius = 20.0,
		bounciness = 1.0,
		bounces = 1,
		walls = [[240, 300, 440, 300], [200, 200, 200, 40], [20, 20, 400, 0]],
	},
}

## Ball, target and walls: one to [constant MOST_WALLS].
var board := BankBoard.new()
## The order of walls that was picked, by their numbers on screen, such as `12`; "" for the one over
## which the ball arrives first.
var order := ""
## The number of the mistake that is switched on; 0 for none.
var mistake := 0

var _answer: BankShotAnswer
var _answered: Dictionary = {}


## What this board leads to; computed anew only after a change.
func answer() -> BankShotAnswer:
	var asked := to_dictionary()
	if _answer == null or asked != _answered:
		_answered = asked
		_answer = BankShotAnswer.new(board, order, mistake)
	return _answer


## The point at which r can be dragged: on the first wall of the way, moved by r. Null where no way
## has a side.
func radius_grip() -> Vec2:
	var way := answer().way
	if way.sides.is_empty():
		return null
	var wall := board.walls[way.walls[0]]
	var away := wall.normal().scaled(way.sides[0] * board.radius)
	return wall.start.lerped(wall.end, _GRIP).plus(away)


## Takes the distance of [param point] from the first wall of the way as r, in whole pixels.
func fit_radius(point: Vec2) -> String:
	var wall := board.walls[answer().way.walls[0]]
	var distance := absf(point.minus(wall.start).dot(wall.normal()))
	return take({"radius": maxf(roundf(distance), 1.0)})


## Takes the C with which the image of the target lies as deep behind the last wall as
## [param image], in steps of 0.05. Where the target touches the moved wall, every C will do.
func fit_bounciness(image: Vec2) -> String:
	var way := answer().way
	var wall := board.walls[way.walls[-1]]
	var normal := wall.normal().scaled(way.sides[-1])
	var before := board.target.minus(wall.start).dot(normal) - board.radius
	var behind := board.radius - image.minus(wall.start).dot(normal)
	if before <= 0.0 or behind <= 0.0:
		return ""
	var steps := roundf(20.0 * before / behind)
	return take({"bounciness": clampf(steps / 20.0, LEAST_BOUNCINESS, 1.0)})


## Puts the ball at [param point]. "" or a sentence; then it stays.
func move_start(point: Vec2) -> String:
	return take({"start": PackedFloat64Array([point.x, point.y])})


## The same for the target.
func move_target(point: Vec2) -> String:
	return take({"target": PackedFloat64Array([point.x, point.y])})


## Moves the wall at [param place]. "" if it could be moved; else a sentence, and it stays.
func move_wall(place: int, from: Vec2, to: Vec2) -> String:
	var moved: Array[PackedFloat64Array] = to_dictionary()["walls"]
	moved[place] = PackedFloat64Array([from.x, from.y, to.x, to.y])
	return take({"walls": moved})


## Takes a state's part; an order that does not fit to its bounces and walls is given up.
func take(changes: Dictionary) -> String:
	var wanted := changes.duplicate()
	if (changes.has("walls") or changes.has("bounces")) and not changes.has("order"):
		var changed := BankShotModel.new()
		changed.from_dictionary(to_dictionary().merged(changes, true))
		wanted["order"] = order if order in changed.board.orders() else ""
	return super(wanted)


## Switches a mistake on. Where it changes nothing, a preset is taken in which it does.
func show_mistake(number: int) -> void:
	mistake = number
	var telling: Dictionary[int, String] = {
		BankShotMistakes.PLAIN_MIRROR: "C = 0.5", BankShotMistakes.WRONG_ORDER: "Slanted pair"
	}
	if number != 0 and not answer().mistake_shows():
		Refusal.push(take(PRESETS[telling.get(number, "One bounce")]))


## The step at which a mistake is shown beside the right way, for who switches it on at
## [param step].
static func step_of_mistake(_mistake: int, step: int) -> int:
	return maxi(step, Step.BOUNCE)


## Where the ball bounces first on the right way; null where there is none.
func first_bounce() -> Vec2:
	return answer().way.bounces[0] if answer().way.hit else null


## The points that the board has to show at [param step]: the images of several bounces only where
## they are looked at, because they may be far away; where the board [param is_small], each image.
func points_to_show(step: Step, is_small: bool) -> Array[Vec2]:
	var found := board.points()
	if step in [Step.IMAGE, Step.BOUNCE] or board.bounces == 1 and not is_small:
		found.append_array(answer().way.images)
	return found


## Takes a typed number by its name in the formula: `sx`, `ty`, `r`, `C`, or x or y of the start or
## the end of a wall, such as `ax1` and `by2`. "" if it could be taken; else a sentence.
func enter(name_in_line: String, value: float) -> String:
	var state := to_dictionary()
	match name_in_line:
		"r":
			return take({"radius": value})
		"C":
			return take({"bounciness": value})
		"sx", "sy", "tx", "ty":
			var key := "start" if name_in_line[0] == "s" else "target"
			var point: PackedFloat64Array = state[key]
			point[0 if name_in_line[1] == "x" else 1] = value
			return take({key: point})
	var moved: Array[PackedFloat64Array] = state["walls"]
	var place := name_in_line[2].to_int() - 1
	moved[place][["ax", "ay", "bx", "by"].find(name_in_line.left(2))] = value
	return take({"walls": moved})


func to_dictionary() -> Dictionary:
	var ends: Array[PackedFloat64Array] = []
	for wall in board.walls:
		ends.append(PackedFloat64Array([wall.start.x, wall.start.y, wall.end.x, wall.end.y]))
	return {
		"start": PackedFloat64Array([board.start.x, board.start.y]),
		"target": PackedFloat64Array([board.target.x, board.target.y]),
		"walls": ends,
		"radius": board.radius,
		"bounciness": board.bounciness,
		"bounces": board.bounces,
		"order": order,
		"mistake": mistake,
	}


func problem_in(stored: Dictionary) -> String:
	var model := BankShotModel.new()
	model.from_dictionary(stored)
	var problems: PackedStringArray = [
		StateCheck.within("r", model.board.radius, SMALLEST_RADIUS, LARGEST_RADIUS),
		StateCheck.within("C", model.board.bounciness, LEAST_BOUNCINESS, 1.0),
		StateCheck.within("walls", model.board.walls.size(), 1.0, MOST_WALLS),
		model._problem_of_bounces(),
		StateCheck.mistake(model.mistake, BankShotMistakes.infos()),
	]
	for point in model.board.points():
		problems.append(_problem_of_point(point))
	for wall in model.board.walls:
		problems.append(_problem_of_wall(wall))
	var problem := StateCheck.first(problems)
	return problem if problem else model._problem_of_order()


func from_dictionary(stored: Dictionary) -> void:
	var of_start: PackedFloat64Array = stored["start"]
	var of_target: PackedFloat64Array = stored["target"]
	board.start = Vec2.new(of_start[0], of_start[1])
	board.target = Vec2.new(of_target[0], of_target[1])
	board.walls = []
	for of_wall: Variant in stored["walls"]:
		var ends: PackedFloat64Array = of_wall
		board.walls.append(LineSegment.new(Vec2.new(ends[0], ends[1]), Vec2.new(ends[2], ends[3])))
	board.radius = stored["radius"]
	board.bounciness = stored["bounciness"]
	board.bounces = stored["bounces"]
	order = stored["order"]
	mistake = stored["mistake"]


# Off one wall alone no ball bounces twice.
func _problem_of_bounces() -> String:
	return StateCheck.within(
		"bounces", board.bounces, 1.0, MOST_BOUNCES if board.walls.size() > 1 else 1
	)


func _problem_of_order() -> String:
	var all := board.orders()
	return "" if order == "" or order in all else StateCheck.word("order", order, all)


static func _problem_of_point(point: Vec2) -> String:
	if point.is_within(LARGEST):
		return ""
	var sentence := LabText.translate("%s is too far out: coordinates go from -1e6 to 1e6.")
	return sentence % NumberText.pair(point.x, point.y)


static func _problem_of_wall(wall: LineSegment) -> String:
	if wall.length() >= SHORTEST:
		return ""
	return LabText.translate("A wall must be at least 0.01 px long: its ends must differ.")
