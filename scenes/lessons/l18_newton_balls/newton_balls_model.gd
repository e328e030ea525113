class_name NewtonBallsModel
extends LessonModel
## Balls that meet: where they are, how they move, and how heavy they are. What becomes of them is
## told by [BallRun] and [BallMeeting].
##
## Lengths in units of the plane, velocities in units per second. All balls are discs of the same
## material: the radius is the root of the mass.

## How the explanation is built up. At FRAME two balls are seen from their centre of mass.
enum Step { MEET, NORMAL, CENTER, FRAME, IMPULSE, AFTER, MOMENTUM, ENERGY }

## There are so many balls.
const FEWEST := 2
const MOST := 50
## No place and no velocity has a component larger than this.
const LARGEST := 100.0
## The masses of balls, in any unit.
const LIGHTEST := 0.01
const HEAVIEST := 100.0
# Balls that touch may overlap by rounding, in units.
const _OVERLAP := 1e-6
# Bouncinesses that the key goes through.
const _USUAL: Array[float] = [1.0, 0.5, 0.0]

## Each ball as x and y of its centre, x and y of its velocity, and its mass.
var balls: Array[PackedFloat64Array] = [[-6.0, -2.0, 6.0, 0.0, 1.0], [2.0, -2.0, 0.0, 0.0, 2.0]]
## The bounciness C, 0..1.
var bounciness := 1.0
## Whether walls are around the balls.
var has_box := false
## False: each ball bounces off another one as off a wall.
var has_newton := true
## The mistake that is switched on, by its number in [NewtonBallsMistakes]; 0 for none.
var mistake := 0


## The radius of a ball of this mass.
static func radius_of(mass: float) -> float:
	return sqrt(mass)


## The balls at the start, for the event world.
func world_balls() -> Array[Ball]:
	var found: Array[Ball] = []
	for one in balls:
		var velocity := Vec2.new(one[2], one[3])
		found.append(Ball.new(Vec2.new(one[0], one[1]), radius_of(one[4]), velocity, one[4]))
	return found


## How these balls fly from now on.
func run() -> BallRun:
	return BallRun.new(world_balls(), bounciness, has_box, has_newton)


## Whether two balls fly alone, so that they can be seen from their centre of mass.
func is_pair() -> bool:
	return balls.size() == 2 and not has_box


## The mistake that is compared with the right way: that of the balls themselves where Newton is off
## and no other one is switched on.
func shown_mistake() -> int:
	if mistake == 0 and not has_newton:
		return NewtonBallsMistakes.AS_OFF_A_WALL
	return mistake


## Whether that mistake leads to other velocities than the right ones at [param meeting].
func mistake_shows(meeting: BallMeeting) -> bool:
	if shown_mistake() == 0 or not meeting:
		return false
	var right := meeting.velocities_after()
	var wrong := NewtonBallsMistakes.velocities_after(shown_mistake(), meeting)
	var off := maxf(right[0].distance_to(wrong[0]), right[1].distance_to(wrong[1]))
	return off > 1e-9 * meeting.speed_scale()


## Switches a mistake on. Where it changes nothing, a preset is shown in which it does.
func show_mistake(number: int) -> void:
	mistake = number
	for preset: String in ["1:2", "C = 0.5", "Oblique"]:
		if number != 0 and not mistake_shows(run().meeting):
			Refusal.push(take(NewtonBallsPresets.all()[preset]))


## Takes these balls, as they fly now, as the new start.
func start_from(flying: Array[Ball]) -> void:
	balls.clear()
	for ball in flying:
		balls.append(list_of(ball))


## A ball as the state has it.
static func list_of(ball: Ball) -> PackedFloat64Array:
	return [ball.position.x, ball.position.y, ball.velocity.x, ball.velocity.y, ball.mass]


## Puts ball [param index] at [param place], as near as the others and the walls leave it.
func move_ball(index: int, place: Vec2) -> String:
	var from := Vec2.new(balls[index][0], balls[index][1])
	var wanted := _kept_in_box(place, radius_of(balls[index][4]))
	var problem := _put_place(index, wanted)
	if not problem:
		return ""
	# Half of the way again and again: it comes to where it touches.
	var share := 0.0
	for halving: int in range(1, 20):
		var farther := share + 0.5 ** halving
		if not _put_place(index, from.lerped(wanted, farther)):
			share = farther
	return ""


## Gives ball [param index] this velocity.
func set_velocity(index: int, velocity: Vec2) -> String:
	var ball := balls[index].duplicate()
	ball[2] = velocity.x
	ball[3] = velocity.y
	return _put(index, ball)


## Gives ball [param index] this mass, and the radius that goes with it.
func set_mass(index: int, mass: float) -> String:
	var ball := balls[index].duplicate()
	ball[4] = mass
	return _put(index, ball)


## Takes the next of the usual bouncinesses.
func take_next_bounciness() -> void:
	bounciness = _USUAL[(_USUAL.find(bounciness) + 1) % _USUAL.size()]


## Takes a typed number by its name in the formula, for a meeting of the balls [param first] and
## [param second]. "" if it could be taken; else one sentence, and nothing changes.
func enter_of_pair(name_in_line: String, value: float, first: int, second: int) -> String:
	if name_in_line == "C":
		return take({"bounciness": value})
	var index := second if name_in_line.ends_with("2") else first
	var ball := balls[index].duplicate()
	ball[{"m": 4, "vx": 2, "vy": 3}[name_in_line.left(-1)]] = value
	return _put(index, ball)


func to_dictionary() -> Dictionary:
	return {
		"balls": balls.duplicate(),
		"bounciness": bounciness,
		"has_box": has_box,
		"has_newton": has_newton,
		"mistake": mistake,
	}


func problem_in(stored: Dictionary) -> String:
	var wanted_bounciness: float = stored["bounciness"]
	var wanted_mistake: int = stored["mistake"]
	var problem := (
		StateCheck
		. first(
			[
				StateCheck.within("C", wanted_bounciness, 0.0, 1.0),
				StateCheck.mistake(wanted_mistake, NewtonBallsMistakes.infos()),
			]
		)
	)
	var lists: Array[PackedFloat64Array] = []
	var wanted_balls: Array = stored["balls"]
	lists.assign(wanted_balls)
	var in_box: bool = stored["has_box"]
	if not problem:
		problem = _problem_of_numbers(lists)
	if not problem:
		problem = _problem_of_places(lists, in_box)
	return problem


func from_dictionary(stored: Dictionary) -> void:
	var wanted: Array = stored["balls"]
	balls.assign(wanted)
	bounciness = stored["bounciness"]
	has_box = stored["has_box"]
	has_newton = stored["has_newton"]
	mistake = stored["mistake"]


static func _problem_of_numbers(lists: Array[PackedFloat64Array]) -> String:
	if lists.size() < FEWEST or lists.size() > MOST:
		var sentence := LabText.translate("There must be %d to %d balls, not %d.")
		return sentence % [FEWEST, MOST, lists.size()]
	for index: int in lists.size():
		var title := LabText.translate("m of ball %d") % (index + 1)
		var problem := StateCheck.within(title, lists[index][4], LIGHTEST, HEAVIEST)
		for number in lists[index].slice(0, 4):
			if not problem:
				title = LabText.translate("place and velocity of ball %d") % (index + 1)
				problem = StateCheck.within(title, number, -LARGEST, LARGEST)
		if problem:
			return problem
	return ""


static func _problem_of_places(lists: Array[PackedFloat64Array], in_box: bool) -> String:
	for index: int in lists.size():
		var radius := radius_of(lists[index][4])
		var place := Vec2.new(lists[index][0], lists[index][1])
		if in_box and not _is_in_box(place, radius):
			return LabText.translate("Ball %d must be in the box.") % (index + 1)
		for before: int in index:
			var other := Vec2.new(lists[before][0], lists[before][1])
			var reach := radius + radius_of(lists[before][4])
			if place.distance_to(other) < reach - _OVERLAP:
				var sentence := LabText.translate("Ball %d and ball %d must not overlap.")
				return sentence % [before + 1, index + 1]
	return ""


static func _is_in_box(place: Vec2, radius: float) -> bool:
	var room_x := BallRun.HALF_BOX[0] - radius + _OVERLAP
	var room_y := BallRun.HALF_BOX[1] - radius + _OVERLAP
	return absf(place.x) <= room_x and absf(place.y) <= room_y


func _kept_in_box(place: Vec2, radius: float) -> Vec2:
	if not has_box:
		return place
	var room_x := maxf(BallRun.HALF_BOX[0] - radius, 0.0)
	var room_y := maxf(BallRun.HALF_BOX[1] - radius, 0.0)
	return Vec2.new(clampf(place.x, -room_x, room_x), clampf(place.y, -room_y, room_y))


func _put_place(index: int, place: Vec2) -> String:
	var ball := balls[index].duplicate()
	ball[0] = place.x
	ball[1] = place.y
	return _put(index, ball)


func _put(index: int, ball: PackedFloat64Array) -> String:
	var wanted := balls.duplicate()
	wanted[index] = ball
	return take({"balls": wanted})
