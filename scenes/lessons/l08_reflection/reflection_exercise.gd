class_name ReflectionExercise
extends Exercise
## Asks what becomes of a velocity at a line, with fresh whole numbers.
##
## Lines lie along a Pythagorean triple, and the velocity is made of whole multiples of it, so that
## all answers are whole.

## What is asked for: C = 1, the part along the normal, another C, the frame after the bounce, or a
## ball that falls on a ramp.
enum Kind { MIRROR, PART, BOUNCE, AWAY, RAMP }

## Directions of lines; each has length 2 or 5. With 1 a normal that is not brought to length 1
## would be right.
const _LINES: Array[Vector2i] = [
	Vector2i(2, 0), Vector2i(0, 2), Vector2i(3, 4), Vector2i(4, 3), Vector2i(3, -4), Vector2i(4, -3)
]

## The part of the velocity along the line is one of these times the line.
const _STRETCHES: Array[int] = [1, -1, 3]

## Ramps run along one of these.
const _FIRST_RAMP := 2
## How fast the ball falls on a ramp, in pixels per frame: so that all answers are whole.
const _FALLS: Array[int] = [25, 50]

## The velocity with which the ball comes.
var velocity: Vec2
## A direction of the line: whole numbers, not of length 1.
var along: Vec2
## The bounciness C, 0..1.
var bounciness: float

var _kind: Kind


## A question with these numbers.
func _init(kind: Kind, coming: Vec2, line: Vec2, with_bounciness: float) -> void:
	_kind = kind
	velocity = coming
	along = line
	bounciness = with_bounciness
	match kind:
		Kind.MIRROR, Kind.BOUNCE:
			_ask_bounce()
		Kind.RAMP:
			_ask_ramp()
		Kind.PART:
			_ask_part()
		Kind.AWAY:
			_ask_away()


## A question with numbers drawn from [param rng]; the ball never flies along the line, nor straight
## at it.
static func fresh(kind: Kind, rng: RandomNumberGenerator) -> ReflectionExercise:
	if kind == Kind.RAMP:
		return _fresh_on_ramp(rng)
	var direction := _LINES[rng.randi_range(0, _LINES.size() - 1)]
	var line := Vec2.new(direction.x, direction.y)
	var across := Vec2.new(-line.y, line.x)
	# Even, so that half of it is whole; never as long as the part along the line.
	var coming := line.scaled(_STRETCHES[rng.randi_range(0, _STRETCHES.size() - 1)])
	coming.add(across.scaled(-2 if kind != Kind.AWAY else 2))
	return new(kind, coming, line, 0.5 if kind == Kind.BOUNCE else 1.0)


static func _fresh_on_ramp(rng: RandomNumberGenerator) -> ReflectionExercise:
	var ramp := _LINES[rng.randi_range(_FIRST_RAMP, _LINES.size() - 1)]
	var fall := _FALLS[rng.randi_range(0, _FALLS.size() - 1)]
	# Its normal points up, to the side from which the ball comes.
	return new(Kind.RAMP, Vec2.new(0.0, fall), Vec2.new(-ramp.x, -ramp.y), 1.0)


## The question with the lecture's own numbers, (3, 4) on a level line; null where it has none.
static func of_the_lecture(kind: Kind) -> ReflectionExercise:
	if not kind in [Kind.MIRROR, Kind.PART]:
		return null
	return new(kind, Vec2.new(3.0, 4.0), Vec2.new(-7.0, 0.0), 1.0)


func solution() -> String:
	var right := text_of(right_answer)
	var part := velocity.vector_projection(along.normal())
	if _kind == Kind.AWAY:
		return tr("v · n̂ is above 0: v stays %s.") % right
	if _kind == Kind.PART:
		var dot := NumberText.factor(velocity.dot(along.normal()))
		return "(v · n̂) n̂ = %s %s = %s" % [dot, _text(along.normal()), right]
	var times := NumberText.short(1.0 + bounciness)
	return "v − (1 + C)(v · n̂) n̂ = %s − %s %s = %s" % [_text(velocity), times, _text(part), right]


## The ball and the line of the question, with a normal of length 1. Nothing for a ball that moves
## away: on the board every ball comes.
func board_state() -> Dictionary:
	if right_answer == PackedFloat64Array([velocity.x, velocity.y]):
		return {}
	return {
		"velocity": PackedFloat64Array([velocity.x, velocity.y]),
		"along": PackedFloat64Array([along.x, along.y]),
		"bounciness": bounciness,
		"has_unit_normal": true,
	}


func _ask_bounce() -> void:
	var question := tr("v = %s meets a line with direction %s. C = %s. What is v afterwards?")
	prompt = question % [_text(velocity), _text(along), NumberText.short(bounciness)]
	_expect_bounce()


func _ask_ramp() -> void:
	var question := tr(
		"A ball falls at %s px a frame on a ramp with direction %s, fully elastic. What is v then?"
	)
	prompt = question % [NumberText.short(velocity.y), _text(along)]
	_expect_bounce()


func _expect_bounce() -> void:
	answer_titles = ["x =", "y ="]
	var normal := along.normal()
	var part := velocity.vector_projection(normal)
	var across := Vec2.new(-along.y, along.x)
	_expect(velocity.reflected(normal, bounciness))
	_add(
		ReflectionMistakes.with_normal_as_it_is(velocity, across, bounciness),
		tr("The normal was not brought to length 1.")
	)
	_add(
		velocity.minus(part.scaled((1.0 + bounciness) * along.length())),
		tr("Only one of the two uses of the normal was divided by its length.")
	)
	_add(
		ReflectionMistakes.off_the_normal_of_the_normal(velocity, normal, bounciness),
		tr("Reflected off the line's direction, not off its normal: the normal of the normal.")
	)
	_add(velocity.minus(part), tr("Subtracted once only: the ball slides along the line."))
	_add(velocity.plus(part), tr("Added instead of subtracted: faster into the line."))
	_add_turned()
	if bounciness < 1.0:
		_add_wrong_bounciness(normal, part)


# v turned in a way that does not look at the line. Straight at y, on a ramp, it can only turn back.
func _add_turned() -> void:
	if velocity.x == 0.0:
		_add(
			velocity.negated(),
			tr("Straight back it flies only off a line that it meets at a right angle.")
		)
		return
	_add(velocity.negated(), tr("All of v was turned. Only the part along n̂ turns."))
	# Off a level or upright line, a flip is right, or is the normal of the normal.
	if along.x != 0.0 and along.y != 0.0:
		_add(Vec2.new(velocity.x, -velocity.y), tr("Flipping y is right for a level line only."))
		_add(Vec2.new(-velocity.x, velocity.y), tr("Flipping x is right for an upright line only."))


# With C = 1 most of these would be right.
func _add_wrong_bounciness(normal: Vec2, part: Vec2) -> void:
	_add(
		ReflectionMistakes.bouncy_along_the_line(velocity, normal, bounciness),
		tr("C acts on the part along the normal only, not along the line.")
	)
	_add(velocity.reflected(normal).scaled(bounciness), tr("C acts on the whole v there."))
	_add(velocity.reflected(normal), tr("That is C = 1: subtract (1 + C) times, not twice."))
	_add(velocity.minus(part.scaled(bounciness)), tr("Subtracted C times, not (1 + C) times."))


func _ask_part() -> void:
	var question := tr(
		"v = %s meets a line with direction %s. What is (v · n̂) n̂, its part along the normal?"
	)
	prompt = question % [_text(velocity), _text(along)]
	answer_titles = ["x =", "y ="]
	var part := velocity.vector_projection(along.normal())
	_expect(part)
	_add(velocity.minus(part), tr("That is what is left: the part along the line."))
	_add(part.negated(), tr("The other way round. Both normals give the same: signs cancel."))
	_add(part.scaled(along.length_squared()), tr("The normal was not brought to length 1."))
	_add(
		part.scaled(along.length()),
		tr("Only one of the two uses of the normal was divided by its length.")
	)
	_add(velocity.reflected(along.normal()), tr("That is v after the bounce already."))


func _ask_away() -> void:
	var question := tr(
		"Last frame the ball bounced. Now v = %s, n̂ = %s; it still overlaps the line."
	)
	prompt = question % [_text(velocity), _text(along.normal())]
	prompt += " " + tr("What is v after this frame?")
	answer_titles = ["x =", "y ="]
	_expect(velocity)
	_add(
		velocity.reflected(along.normal()),
		tr("v · n̂ is above 0: it moves away already. Reflected again, it would stick.")
	)
	_add(Vec2.new(), tr("It is not stopped: it already moves away, so it is left alone."))


func _expect(answer: Vec2) -> void:
	right_answer = [answer.x, answer.y]


func _add(answer: Vec2, sentence: String) -> void:
	add_mistake([answer.x, answer.y], sentence)


func _text(vector: Vec2) -> String:
	return NumberText.pair(vector.x, vector.y)
