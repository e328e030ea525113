class_name ReflectionMistakes
extends RefCounted
## Four ways in which students get the reflection wrong, by their numbers in the course's list.
##
## None of this is used outside the bug gallery; the right way is in `scripts/collision/bounce.gd`.

const NOT_UNIT := 11
const NORMAL_OF_NORMAL := 12
const BOUNCY_TANGENT := 13
const REFLECTED_AGAIN := 14

## The course's frame, in seconds: how often the ball that is reflected again and again meets the
## line.
const FRAME_SECONDS := 1.0 / 60.0


## Mistake 11: the formula with a normal that is not of length 1.
static func with_normal_as_it_is(velocity: Vec2, normal: Vec2, bounciness: float) -> Vec2:
	return velocity.minus(normal.scaled((1.0 + bounciness) * velocity.dot(normal)))


## Mistake 12: reflected off the normal of the normal, which lies along the line.
static func off_the_normal_of_the_normal(velocity: Vec2, normal: Vec2, bounciness: float) -> Vec2:
	return velocity.reflected(normal.normal(), bounciness)


## Mistake 13: the bounciness takes speed along the line, and none along the normal.
static func bouncy_along_the_line(velocity: Vec2, normal: Vec2, bounciness: float) -> Vec2:
	var part := velocity.vector_projection(normal)
	return velocity.minus(part).scaled(bounciness).minus(part)


## The wrong velocity that the mistake switched on in [param model] leads to.
static func velocity_after(model: ReflectionModel) -> Vec2:
	var velocity := model.velocity
	var normal := model.unit_normal()
	match model.mistake:
		NOT_UNIT:
			var long_normal := normal.scaled(model.normal_length)
			return with_normal_as_it_is(velocity, long_normal, model.bounciness)
		NORMAL_OF_NORMAL:
			return off_the_normal_of_the_normal(velocity, normal, model.bounciness)
		BOUNCY_TANGENT:
			return bouncy_along_the_line(velocity, normal, model.bounciness)
		REFLECTED_AGAIN:
			var once := velocity.reflected(normal, model.bounciness)
			return once.reflected(normal, model.bounciness)
	return velocity.copy()


## The centre of the wrong ball of [param radius] at the time of [param model].
static func ball_centre(model: ReflectionModel, radius: float) -> Vec2:
	if model.mistake == REFLECTED_AGAIN and model.time > 0.0:
		return _sticking_centre(model, radius)
	return model.ball_centre(radius, velocity_after(model))


# Mistake 14: each frame finds the ball still at the line and reflects it once more.
static func _sticking_centre(model: ReflectionModel, radius: float) -> Vec2:
	var normal := model.unit_normal()
	var centre := model.facing_normal().scaled(radius)
	var leaving := model.velocity.copy()
	var left := model.time
	while left > 0.0:
		leaving.reflect(normal, model.bounciness)
		centre.add(leaving.scaled(minf(left, FRAME_SECONDS)))
		left -= FRAME_SECONDS
	return centre


## What the bug gallery says of each, translated.
static func infos() -> Array[MistakeInfo]:
	return [
		(
			MistakeInfo
			. new(
				NOT_UNIT,
				_translate("normal not of length 1"),
				_translate(
					"With n twice too long, v · n and n are both doubled: 4 times too much is subtracted."
				),
				"test_bounce.test_mistake_11_a_normal_that_is_not_unit_is_refused"
			)
		),
		MistakeInfo.new(
			NORMAL_OF_NORMAL,
			_translate("normal of the normal"),
			_translate("That lies along the line: the ball turns back on its way, into the line."),
			"test_bounce.test_mistake_12_the_normal_of_the_normal_is_not_used"
		),
		MistakeInfo.new(
			BOUNCY_TANGENT,
			_translate("bounciness on the tangent"),
			_translate("C must act along the normal. Here it brakes the ball along the line."),
			"test_bounce.test_mistake_13_bounciness_leaves_the_tangent_alone"
		),
		(
			MistakeInfo
			. new(
				REFLECTED_AGAIN,
				_translate("reflected while moving away"),
				_translate(
					"Next frame the ball still overlaps the line, and is sent back in: it sticks, jittering."
				),
				"test_bounce.test_mistake_14_a_ball_that_moves_away_is_left_alone"
			)
		),
	]


static func _translate(sentence: String) -> String:
	return TranslationServer.translate(sentence)
