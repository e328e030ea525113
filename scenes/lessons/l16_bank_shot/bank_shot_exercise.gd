class_name BankShotExercise
extends Exercise
## Asks where the image of a target is, where the ball bounces, what a loss changes, and in which
## order to mirror, with fresh whole numbers: walls are level, or slanted by 45°.

## What is asked for: the image, the x of the bounce, the image for C below 1, that in two walls.
enum Kind { IMAGE, BOUNCE, LOSS, ORDER }

# The heights of start and target above the moved wall, so that the bounce has a whole x.
const _HEIGHTS: Array[Vector2i] = [
	Vector2i(180, 120), Vector2i(60, 120), Vector2i(80, 120), Vector2i(120, 30), Vector2i(150, 50)
]
const _LOSSES: Array[float] = [0.5, 0.8, 0.4]
const _HALF_WALL := 260.0

## The board of the question.
var start: Vec2
var target: Vec2
var radius: float
var bounciness := 1.0
## The y of the level wall.
var floor_y: float

var _kind: Kind


## A question with numbers drawn from [param rng].
static func fresh(kind: Kind, rng: RandomNumberGenerator) -> BankShotExercise:
	var exercise := new()
	exercise._kind = kind
	exercise._draw_board(rng)
	match kind:
		Kind.IMAGE:
			exercise._ask_image()
		Kind.BOUNCE:
			exercise._ask_bounce()
		Kind.LOSS:
			exercise.bounciness = _LOSSES[rng.randi_range(0, _LOSSES.size() - 1)]
			exercise._ask_loss()
		Kind.ORDER:
			exercise._ask_order(rng)
	return exercise


func solution() -> String:
	var right := text_of(right_answer)
	match _kind:
		Kind.IMAGE, Kind.LOSS:
			var words := [
				_short(floor_y - radius), _short(_height(target)), _short(bounciness), right
			]
			return tr("The moved wall is at y = %s, d = %s: d / %s behind it lies %s.") % words
		Kind.BOUNCE:
			return tr("On the line from S to T′, where it crosses the moved wall: x = %s.") % right
	return tr("First in the slanted wall, then in the level one: %s.") % right


## The level wall of the question. Nothing for two walls: their ball is a point.
func board_state() -> Dictionary:
	if _kind == Kind.ORDER:
		return {}
	var middle := 0.5 * (start.x + target.x)
	var walls: Array[PackedFloat64Array] = [
		PackedFloat64Array([middle - _HALF_WALL, floor_y, middle + _HALF_WALL, floor_y])
	]
	return {
		"start": PackedFloat64Array([start.x, start.y]),
		"target": PackedFloat64Array([target.x, target.y]),
		"walls": walls,
		"radius": radius,
		"bounciness": bounciness,
		"bounces": 1,
		"order": "",
	}


func _draw_board(rng: RandomNumberGenerator) -> void:
	radius = 10.0 * rng.randi_range(1, 2)
	floor_y = 10.0 * rng.randi_range(20, 32)
	var heights := _HEIGHTS[rng.randi_range(0, _HEIGHTS.size() - 1)]
	var moved := floor_y - radius
	start = Vec2.new(10.0 * rng.randi_range(2, 12), moved - heights.x)
	var apart := heights.x + heights.y
	while apart < 150:
		apart += heights.x + heights.y
	target = Vec2.new(start.x + apart, moved - heights.y)


# How far this place of the centre is before the moved wall.
func _height(point: Vec2) -> float:
	return floor_y - radius - point.y


func _ask_image() -> void:
	var question := tr("A wall at y = %s, a ball with r = %s, T = %s, C = 1. Where is T′?")
	prompt = question % [_short(floor_y), _short(radius), _pair(target)]
	answer_titles = ["x =", "y ="]
	_expect(target.x, floor_y - radius + _height(target))
	_add(target.x, 2.0 * floor_y - target.y, tr("Mirrored in the wall itself: move it by r first."))
	_add(
		target.x,
		floor_y + radius + (floor_y + radius - target.y),
		tr("The wall was moved away from the ball: move it to the ball's side.")
	)
	_add(target.x, floor_y - radius, tr("That is on the moved wall: T′ is as far behind it again."))
	_add(
		target.x,
		floor_y + _height(target),
		tr("d was counted from the moved wall, and put behind the wall itself.")
	)


func _ask_bounce() -> void:
	var question := tr(
		"S = %s, T = %s, a wall at y = %s, r = %s, C = 1. What is the x of the bounce?"
	)
	prompt = question % [_pair(start), _pair(target), _short(floor_y), _short(radius)]
	answer_titles = ["x ="]
	right_answer = [_crossing(_height(start), _height(target))]
	add_mistake(
		[0.5 * (start.x + target.x)],
		tr("Halfway is right only where S and T are equally far from the wall.")
	)
	add_mistake(
		[_crossing(_height(start) + radius, _height(target) + radius)],
		tr("That is where a point bounces: move the wall by r first.")
	)
	add_mistake(
		[_crossing(_height(target), _height(start))],
		tr("The shares are swapped: the bounce is nearer to what is nearer to the wall.")
	)
	add_mistake(
		[right_answer[0] - start.x], tr("That is how far to the right of S it is: add the x of S.")
	)
	add_mistake([target.x], tr("That is the point nearest to T: from there the ball flies past T."))


# Where a line from so high above the wall at S to so deep below it at T crosses it.
func _crossing(before: float, behind: float) -> float:
	return lerpf(start.x, target.x, before / (before + behind))


func _ask_loss() -> void:
	var question := tr("A wall at y = %s, a ball with r = %s, T = %s, C = %s. Where is T′?")
	prompt = (question % [_short(floor_y), _short(radius), _pair(target), _short(bounciness)])
	answer_titles = ["x =", "y ="]
	var moved := floor_y - radius
	var height := _height(target)
	_expect(target.x, moved + height / bounciness)
	_add(target.x, moved + height, tr("That is for C = 1: with a loss T′ is 1/C times as deep."))
	_add(
		target.x,
		moved + height * bounciness,
		tr("C times as deep: it is 1/C times, because the ball leaves flatter.")
	)
	_add(
		target.x,
		floor_y + (floor_y - target.y) / bounciness,
		tr("Mirrored in the wall itself: move it by r first.")
	)
	_add(
		target.x,
		target.y + height / bounciness,
		tr("d / C was counted from T: it begins at the moved wall.")
	)


# The second wall is the line y = x: it swaps the coordinates.
func _ask_order(rng: RandomNumberGenerator) -> void:
	target = Vec2.new(10.0 * rng.randi_range(2, 9), 10.0 * rng.randi_range(11, 19))
	var question := tr(
		"A point bounces off the wall y = %s, then off the wall y = x, then reaches T = %s. C = 1."
	)
	prompt = question % [_short(floor_y), _pair(target)]
	prompt += " " + tr("At which image is it shot?")
	answer_titles = ["x =", "y ="]
	_expect(target.y, 2.0 * floor_y - target.x)
	_add(
		2.0 * floor_y - target.y,
		target.x,
		tr("Mirrored in the first wall first: begin with the last one.")
	)
	_add(target.y, target.x, tr("That is the image in the last wall only: mirror on in the first."))
	_add(
		target.x,
		2.0 * floor_y - target.y,
		tr("That is the image in the first wall only: begin with the last one.")
	)


func _expect(x: float, y: float) -> void:
	right_answer = [x, y]


func _add(x: float, y: float, sentence: String) -> void:
	add_mistake([x, y], sentence)


static func _short(number: float) -> String:
	return NumberText.short(number)


static func _pair(point: Vec2) -> String:
	return NumberText.pair(point.x, point.y)
