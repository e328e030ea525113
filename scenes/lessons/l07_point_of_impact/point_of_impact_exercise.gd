class_name PointOfImpactExercise
extends Exercise
## Asks for the fraction t of a frame, or for the point of impact, with fresh numbers.
##
## The line lies along a Pythagorean triple, and t is a whole number of tenths, so that answers are
## short.

## What is asked for.
enum Kind { FRACTION, POINT }

## Ways along the normal of a whole frame, in pixels.
const _WAYS: Array[int] = [40, 50, 80, 100]
## Tenths of the frame until the contact: in the middle, what is left of the frame would be as long.
const _TENTHS: Array[int] = [2, 3, 4, 6, 7]

## The line, through the origin; its normal is (0.6, -0.8).
var line := LineSegment.new(Vec2.new(60.0, 45.0), Vec2.new(-60.0, -45.0))
## The ball's centre before and after the frame.
var old_position: Vec2
var new_position: Vec2
## The ball's radius.
var radius: float

var _old_distance: float
var _new_distance: float


## A frame that begins [param old_distance] and ends [param new_distance] pixels from the line, and
## moves the ball by [param sideways] pixels along it.
func _init(
	kind: Kind, old_distance: float, new_distance: float, its_radius: float, sideways: float
) -> void:
	_old_distance = old_distance
	_new_distance = new_distance
	radius = its_radius
	old_position = line.normal().scaled(old_distance)
	var along := line.along().normalized().scaled(sideways)
	new_position = line.normal().scaled(new_distance).plus(along)
	if kind == Kind.FRACTION:
		_ask_fraction()
	else:
		_ask_point()


## A question with numbers drawn from [param rng]; the ball touches within the frame, and its centre
## ends behind the line. Two mistakes may have the same answer: [method Exercise.drawn] draws again.
static func fresh(kind: Kind, rng: RandomNumberGenerator) -> PointOfImpactExercise:
	var its_radius := 5.0 * rng.randi_range(1, 2)
	var way := _WAYS[rng.randi_range(0, _WAYS.size() - 1)]
	var tenths := _TENTHS[rng.randi_range(0, _TENTHS.size() - 1)]
	var old_distance := its_radius + way * tenths / 10.0
	var sideways := 10.0 * rng.randi_range(-4, 4)
	return new(kind, old_distance, old_distance - way, its_radius, sideways)


## The frame of the question.
func board_state() -> Dictionary:
	return {
		"old": _components(old_position),
		"new": _components(new_position),
		"radius": radius,
		"line": PackedFloat64Array([line.start.x, line.start.y, line.end.x, line.end.y]),
	}


func _ask_fraction() -> void:
	var sentence := tr("In one frame the distance goes from %s to %s; the radius is %s. What is t?")
	prompt = sentence % [_short(_old_distance), _short(_new_distance), _short(radius)]
	answer_titles = ["t ="]
	right_answer = [PointOfImpact.fraction(_old_distance, _new_distance, radius)]
	for number in _sentences():
		for fraction in _fractions_with(number):
			_add([fraction], _sentences()[number])
	var way := _old_distance - _new_distance
	_add([-right_answer[0]], tr("The sign is wrong: b is old − new, not new − old."))
	_add([_old_distance / way], tr("The radius is missing: a = old − r."))
	_add([(_old_distance + radius) / way], tr("The radius is subtracted: a = old − r."))
	_add([way / (_old_distance - radius)], tr("That is b / a: above 1, so not in this frame."))
	_add([(_old_distance - radius) * way], tr("a is divided by b, not multiplied."))
	_add([_old_distance - radius], tr("That is a, the way to the contact: divide it by b."))


func _ask_point() -> void:
	var motion := new_position.minus(old_position)
	var sentence := tr(
		"old = %s, v = %s. The distance goes from %s to %s, r = %s. Where is the POI?"
	)
	prompt = (
		sentence
		% [
			NumberText.pair(old_position.x, old_position.y),
			NumberText.pair(motion.x, motion.y),
			_short(_old_distance),
			_short(_new_distance),
			_short(radius)
		]
	)
	answer_titles = ["x =", "y ="]
	var fraction := PointOfImpact.fraction(_old_distance, _new_distance, radius)
	right_answer = _components(old_position.plus(motion.scaled(fraction)))
	for number in _sentences():
		for wrong in _fractions_with(number):
			_add(_components(old_position.plus(motion.scaled(wrong))), _sentences()[number])
	_add(
		_components(old_position.minus(motion.scaled(fraction))),
		tr("t v is added to old, not subtracted.")
	)
	_add(
		_components(new_position.plus(motion.scaled(fraction))),
		tr("t v is added to old, not to new.")
	)
	_add(_components(motion.scaled(fraction)), tr("That is t v alone: old is missing."))
	_add(_components(new_position), tr("That is new: it is behind the line already."))
	var reset := Ball.new(new_position, radius)
	PositionReset.reset(reset, line)
	_add(_components(reset.position), tr("That is the position reset: it is not on the path."))


# Those below 0 without their sign, too: a student who expects a share of the frame leaves it out.
func _fractions_with(number: int) -> PackedFloat64Array:
	var wrong := PointOfImpactMistakes.fraction(number, _old_distance, _new_distance, radius)
	return [wrong, absf(wrong)]


func _sentences() -> Dictionary[int, String]:
	return {
		PointOfImpactMistakes.OVER_NEW: tr("Divided by the new distance: b is old − new."),
		PointOfImpactMistakes.UNSIGNED: tr("The new distance is negative behind the line."),
		PointOfImpactMistakes.FROM_NEW: tr("a is old − r, not new − r: t counts from old."),
	}


func _add(answer: PackedFloat64Array, sentence: String) -> void:
	add_mistake(answer, sentence)


static func _components(point: Vec2) -> PackedFloat64Array:
	return [point.x, point.y]


static func _short(number: float) -> String:
	return NumberText.short(number)
