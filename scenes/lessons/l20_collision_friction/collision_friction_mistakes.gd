class_name CollisionFrictionMistakes
extends RefCounted
## The wrong bounces of the bug gallery. The right ones are those of [FrictionBounce] and
## [BallFrictionBounce].

## µ brakes the part along the surface as a factor.
const AS_FACTOR := 101
## Friction brakes the flight only: the spin is forgotten.
const WITHOUT_SPIN := 102
## Friction is always µ jn, also where less is enough to end the slip.
const NO_STICK := 103
## The part along the surface is set to 0.
const NO_TANGENT := 104
## Two balls push each other along n only.
const SMOOTH_BALLS := 105

# Two velocities or rim speeds that differ by less than this share of all speeds are one.
const _ROUNDING := 1e-9


## How the balls of [param contact] leave by the mistake with this number; the right way for 0 and
## where the mistake is not about such a contact.
static func balls_after(number: int, contact: FrictionContact) -> Array[Ball]:
	var along := contact.along_speed()
	var limit := contact.limit()
	match number:
		AS_FACTOR:
			return contact.after_with(-contact.friction * along, 0.0)
		WITHOUT_SPIN:
			return contact.after_with(-clampf(along, -limit, limit), 0.0)
		NO_STICK:
			var grip := -signf(contact.slip()) * limit
			return contact.after_with(grip, grip)
		NO_TANGENT:
			return contact.after_with(-along, 0.0)
		SMOOTH_BALLS when contact.other:
			return contact.after_with(0.0, 0.0)
	return contact.after()


## Whether the balls leave otherwise by this mistake than they do.
static func is_seen(number: int, contact: FrictionContact) -> bool:
	var right := contact.after()
	var wrong := balls_after(number, contact)
	var off := 0.0
	for place: int in right.size():
		off = maxf(off, right[place].velocity.distance_to(wrong[place].velocity))
		off = maxf(off, absf(right[place].spin - wrong[place].spin) * right[place].radius)
	return off > _ROUNDING * contact.speed_scale()


## What the gallery shows.
static func infos() -> Array[MistakeInfo]:
	return [
		_info(
			AS_FACTOR,
			LabText.translate("speed along the line times 1 − µ"),
			(
				LabText
				. translate(
					"µ is no brake on the speed: friction is at most µ times the push, and it turns the ball, too."
				)
			),
			"mu_as_a_factor_leaves_225",
			LabText.translate("The test wants 200 px/s along the line, not 225.")
		),
		_info(
			WITHOUT_SPIN,
			LabText.translate("the spin is forgotten"),
			(
				LabText
				. translate(
					"Friction turns the ball, too: of the slip it takes one third by the flight, two by the spin."
				)
			),
			"without_the_spin_100_are_left",
			LabText.translate("The test wants 200 px/s and a spin of 10, not 100 px/s and none.")
		),
		_info(
			NO_STICK,
			LabText.translate("friction is always µ jn"),
			LabText.translate(
				"Friction ends the slip, and never turns it round: more than |u| / 3 is too much."
			),
			"without_a_limit_friction_turns_the_ball_back",
			LabText.translate("The test has a large µ and wants the ball to go on forwards.")
		),
		_info(
			NO_TANGENT,
			LabText.translate("no speed along the line is left"),
			(
				LabText
				. translate(
					"A ball that sticks does not stop: without a spin it keeps two thirds of this speed."
				)
			),
			"a_tangent_set_to_0_stops_the_ball",
			LabText.translate("The test wants a ball that sticks to keep two thirds of its speed.")
		),
		_info(
			SMOOTH_BALLS,
			LabText.translate("no friction between balls"),
			LabText.translate(
				"The ball that is hit does not leave along n: friction throws it to the side."
			),
			"smooth_balls_leave_along_n",
			LabText.translate("The test wants v₂′ = (175, 100), not (160, 120).")
		),
	]


static func _info(
	number: int, title: String, sentence: String, test: String, checks: String
) -> MistakeInfo:
	return MistakeInfo.new(
		number, title, sentence, "test_collision_friction_model.test_" + test, checks
	)
