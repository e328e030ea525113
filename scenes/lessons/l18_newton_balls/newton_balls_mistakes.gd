class_name NewtonBallsMistakes
extends RefCounted
## The wrong bounces of the bug gallery. The right one is that of [BallBounce].

## The masses are ignored: each ball bounces off the other one as off a wall.
const AS_OFF_A_WALL := 25
## The velocities are exchanged, whatever the masses are.
const SWAPPED := 101
## C makes the whole velocities smaller, and not the part of the approach that comes back.
const C_ON_ALL := 102
## The law along the normal is used for whole velocities.
const WHOLE_VELOCITY := 103
## Each ball takes its own share of the masses and not that of the other one.
const OWN_SHARE := 104
## Ball 2 is computed with the velocity of ball 1 that has changed already.
const ALREADY_CHANGED := 105


## The velocities of ball 1 and ball 2 after the bounce with the mistake of this number; the right
## ones for 0.
static func velocities_after(number: int, meeting: BallMeeting) -> Array[Vec2]:
	var v1 := meeting.one.velocity
	var v2 := meeting.two.velocity
	var right := meeting.velocities_after()
	match number:
		AS_OFF_A_WALL:
			var normal := meeting.normal
			return [
				v1.reflected(normal, meeting.bounciness), v2.reflected(normal, meeting.bounciness)
			]
		SWAPPED:
			return [v2.copy(), v1.copy()]
		C_ON_ALL:
			return _with_c_on_all(meeting)
		WHOLE_VELOCITY:
			return [_about_center(v1, meeting), _about_center(v2, meeting)]
		OWN_SHARE:
			return _with_shares(meeting, meeting.one.mass, meeting.two.mass)
		ALREADY_CHANGED:
			return [right[0], _second_by_changed_first(meeting, right[0])]
	return right


static func _with_c_on_all(meeting: BallMeeting) -> Array[Vec2]:
	var elastic := BallMeeting.new(meeting.one, meeting.two, 1.0).velocities_after()
	return [elastic[0].scaled(meeting.bounciness), elastic[1].scaled(meeting.bounciness)]


# V - C (v - V), as for balls that meet head-on.
static func _about_center(velocity: Vec2, meeting: BallMeeting) -> Vec2:
	var center := meeting.center_velocity()
	return center.minus(velocity.minus(center).scaled(meeting.bounciness))


static func _with_shares(meeting: BallMeeting, mass_one: float, mass_two: float) -> Array[Vec2]:
	var change := (1.0 + meeting.bounciness) * meeting.closing_speed() / meeting.total_mass()
	var along := meeting.normal.scaled(change)
	return [
		meeting.one.velocity.minus(along.scaled(mass_one)),
		meeting.two.velocity.plus(along.scaled(mass_two))
	]


static func _second_by_changed_first(meeting: BallMeeting, changed: Vec2) -> Vec2:
	var closing := changed.minus(meeting.two.velocity).dot(meeting.normal)
	var share := meeting.one.mass / meeting.total_mass()
	var change := (1.0 + meeting.bounciness) * share * closing
	return meeting.two.velocity.plus(meeting.normal.scaled(change))


## What the gallery shows.
static func infos() -> Array[MistakeInfo]:
	return [
		_info(
			AS_OFF_A_WALL,
			LabText.translate("masses ignored"),
			LabText.translate(
				"Each ball bounces as off a wall. A wall takes any momentum, a ball does not."
			),
			"test_masses_ignored_gives_minus_6"
		),
		_info(
			SWAPPED,
			LabText.translate("velocities exchanged"),
			(
				LabText
				. translate(
					"Balls exchange their velocities only if the masses are equal, C is 1 and they meet head-on."
				)
			),
			"test_exchanged_velocities_need_equal_masses"
		),
		_info(
			C_ON_ALL,
			LabText.translate("C on the whole velocity"),
			LabText.translate(
				"C is the part of the closing speed that comes back, and not a brake on both balls."
			),
			"test_c_on_all_loses_momentum"
		),
		MistakeInfo.new(
			WHOLE_VELOCITY,
			LabText.translate("whole velocity instead of the part along n"),
			LabText.translate(
				"Smooth balls push each other along n only: the part across n stays."
			),
			"test_newton_balls_model.test_the_whole_velocity_turns_the_part_across",
			LabText.translate("The test wants the part across n to stay.")
		),
		_info(
			OWN_SHARE,
			LabText.translate("shares of the masses mixed up"),
			(
				LabText
				. translate(
					"The heavy ball changes its velocity little: its share is the mass of the other one."
				)
			),
			"test_own_shares_give_2_and_8"
		),
		_info(
			ALREADY_CHANGED,
			LabText.translate("v₁ changed before v₂ is computed"),
			LabText.translate(
				"Compute J first, from both old velocities. Then change both balls with the same J."
			),
			"test_already_changed_gives_minus_4_thirds"
		),
	]


static func _info(number: int, title: String, sentence: String, test: String) -> MistakeInfo:
	var checks := LabText.translate("The test wants the sum of the momenta to stay.")
	return MistakeInfo.new(number, title, sentence, "test_newton_balls_model." + test, checks)
