class_name AngledLinesMistakes
extends RefCounted
## The known mistakes of stepping balls among lines, each as a mover that makes it.


## Mistake 14: a ball that overlaps is reflected even if it already moves away, and is not put back.
class AlwaysReflectMover:
	extends BallMover

	func move(ball: Ball, seconds: float, surroundings: Surroundings) -> Array[BounceRecord]:
		fly(ball, seconds, surroundings.gravity)
		for segment in surroundings.segments:
			var overlap := SegmentOverlap.with_segment(ball.position, ball.radius, segment)
			if overlap.hit:
				ball.velocity.reflect(overlap.normal, surroundings.bounciness)
		return []


## Mistake 21: of the impacts with all lines, the last in the list is taken, not the earliest.
class LastHitMover:
	extends WholeFrameMover

	func find_impact(
		ball: Ball, motion: Vec2, surroundings: Surroundings, _skipped: PackedInt32Array
	) -> Impact:
		var found := Impact.miss(Impact.Outcome.TOO_FAR)
		for segment in surroundings.segments:
			var impact := SegmentImpact.with_segment(ball.position, motion, ball.radius, segment)
			if impact.hit:
				found = impact
		return found


## Mistake 26: the gravity of the whole frame acts before the bounce.
class FullGravityMover:
	extends WholeFrameMover

	func move(ball: Ball, seconds: float, surroundings: Surroundings) -> Array[BounceRecord]:
		var bounces: Array[BounceRecord] = []
		var gravity := surroundings.gravity
		var motion := FreeFlight.motion(ball.velocity, gravity, seconds)
		var impact := surroundings.first_impact(ball, motion)
		if not impact.hit:
			fly(ball, seconds, gravity)
			return bounces
		ball.position = impact.position
		ball.velocity.add(gravity.scaled(seconds))
		bounce(ball, impact, surroundings.bounciness, bounces)
		move_under(Vec2.new(), ball, seconds * (1.0 - impact.fraction), surroundings, bounces)
		return bounces


## The preset that shows a mistake at once, by the number of the mistake.
const PRESETS: Dictionary[int, int] = {14: 3, 21: 5, 24: 9, 26: 9}


## The mover that makes the mistake [param number]; the right one for 0.
static func mover(number: int) -> BallMover:
	match number:
		14:
			return AlwaysReflectMover.new()
		21:
			return LastHitMover.new()
		24:
			return PointOfImpactMover.new()
		26:
			return FullGravityMover.new()
	return WholeFrameMover.new()


## Whether the mistake [param number] is shown beside the way of stepping [param method]: not beside
## the event world, which makes none of them, nor beside the way that makes this very mistake.
static func can_be_beside(number: int, method: SteppingMethods.Method) -> bool:
	match method:
		SteppingMethods.Method.EVENT_WORLD:
			return false
		SteppingMethods.Method.POINT_OF_IMPACT:
			return number != 24
	return true


## All of them, as the gallery shows them.
static func all() -> Array[MistakeInfo]:
	return [
		MistakeInfo.new(
			14,
			LabText.translate("reflected while moving away"),
			LabText.translate(
				"The ball overlaps, so it is reflected, frame after frame: it sinks in and jitters."
			),
			"test_known_stepping_mistakes.test_a_ball_that_moves_away_is_not_reflected_again",
			LabText.translate("The test has a ball overlap and move away: its velocity must stay.")
		),
		MistakeInfo.new(
			21,
			LabText.translate("last hit instead of the earliest"),
			LabText.translate(
				"Of two walls in one frame the last in the list wins: the ball passes the first."
			),
			"test_known_stepping_mistakes.test_the_earliest_of_two_walls_is_hit",
			LabText.translate(
				"The test lists two walls in both orders: the ball must hit the nearer."
			)
		),
		MistakeInfo.new(
			24,
			LabText.translate("rest of the frame lost"),
			LabText.translate(
				"After a bounce the ball waits for the next frame, while gravity still changes v."
			),
			"test_known_stepping_mistakes.test_the_rest_of_the_frame_is_used",
			LabText.translate(
				"The test lets a ball bounce: it must fly on for the rest of the frame."
			)
		),
		(
			MistakeInfo
			. new(
				26,
				LabText.translate("full gravity before the bounce"),
				(
					LabText
					. translate(
						"The whole frame's gravity acts before the bounce: each bounce off the floor adds energy."
					)
				),
				"test_known_stepping_mistakes.test_gravity_before_the_bounce_lasts_until_the_bounce",
				LabText.translate(
					"The test drops a ball: at the bounce v² = v₀² + 2 g s must hold."
				)
			)
		),
	]
