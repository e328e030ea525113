class_name NewtonBallsCode
extends RefCounted
## The lines of GDScript that compute what each step of the lesson on balls that meet shows.

const _LINES: Dictionary[NewtonBallsModel.Step, Array] = {
	NewtonBallsModel.Step.MEET: ["var gap := c2.minus(c1).length() - r1 - r2"],
	NewtonBallsModel.Step.NORMAL:
	["var n := c2.minus(c1).normalized()", "var w := v1.minus(v2).dot(n)"],
	NewtonBallsModel.Step.CENTER:
	["var center := v1.scaled(m1).plus(v2.scaled(m2)).divided(m1 + m2)"],
	NewtonBallsModel.Step.FRAME:
	[
		"var u1 := v1.minus(center)",
		"var u2 := v2.minus(center)",
		"var u1_after := u1.reflected(n, bounciness)",
	],
	NewtonBallsModel.Step.IMPULSE:
	[
		"var w := v1.minus(v2).dot(n)",
		"var impulse := (1.0 + bounciness) * m1 * m2 / (m1 + m2) * w",
	],
	NewtonBallsModel.Step.AFTER:
	["v1.subtract(n.scaled(impulse / m1))", "v2.add(n.scaled(impulse / m2))"],
	NewtonBallsModel.Step.MOMENTUM: ["var p := v1.scaled(m1).plus(v2.scaled(m2))"],
	NewtonBallsModel.Step.ENERGY:
	["var energy := (m1 * v1.length_squared() + m2 * v2.length_squared()) / 2.0"],
}


## The lines of [param step]; none where the balls do not meet.
static func lines(meeting: BallMeeting, step: int) -> PackedStringArray:
	return PackedStringArray(_LINES[step]) if meeting else PackedStringArray()


## The values of the names in the lines.
static func inputs(meeting: BallMeeting) -> Dictionary[String, Variant]:
	if not meeting:
		return {}
	return {
		"c1": meeting.one.position,
		"c2": meeting.two.position,
		"r1": meeting.one.radius,
		"r2": meeting.two.radius,
		"v1": meeting.one.velocity,
		"v2": meeting.two.velocity,
		"m1": meeting.one.mass,
		"m2": meeting.two.mass,
		"bounciness": meeting.bounciness,
		"n": meeting.normal,
		"center": meeting.center_velocity(),
		"impulse": meeting.impulse(),
	}
