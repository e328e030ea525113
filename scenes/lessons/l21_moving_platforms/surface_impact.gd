class_name SurfaceImpact
extends RefCounted
## The impact of a ball with a surface that moves or turns: the velocities before it are seen from
## the touched point, which rests then, reflected there, and seen from the lab again.

## Within so many seconds an impact is looked for.
const LONGEST := 20.0

## Whether they meet. Without a hit only [member coming] has a meaning.
var hit := false
## Seconds until the impact.
var time := 0.0
## The ball's centre at that moment, in pixels.
var center := Vec2.new()
## From the surface to the ball's centre; length 1.
var normal := Vec2.new()
## From the pivot to the touched point, in pixels; for a surface that does not turn, too.
var arm := Vec2.new()
## v: the ball's velocity before the impact, in px/s.
var coming := Vec2.new()
## w: the velocity of the touched point.
var touched := Vec2.new()
## U: the ball's velocity before, as the touched point sees it.
var seen := Vec2.new()
## U′: the same after the impact.
var bounced := Vec2.new()
## v′: the ball's velocity after the impact, in the lab.
var leaving := Vec2.new()


## The first impact of [param ball] with [param moving] and the bounciness C, without friction.
static func of(ball: Ball, moving: TurningSegment, bounciness: float) -> SurfaceImpact:
	var found := SurfaceImpact.new()
	found.coming = ball.velocity.copy()
	var first: FrictionImpact
	if moving.turn == 0.0:
		first = FrictionImpact.with_segment(ball, moving.segment, bounciness, 0.0, moving.velocity)
	else:
		first = FrictionImpact.with_turning(ball, moving, bounciness, 0.0, LONGEST)
	found.hit = first.hit and first.time <= LONGEST
	if found.hit:
		found.time = first.time
		found.center = first.position
		found.normal = first.normal
		var point := found.center.minus(found.normal.scaled(ball.radius))
		found.arm = point.minus(moving.pivot_at(found.time))
		found._bounce(moving.velocity_at(found.arm), bounciness)
	return found


## One that is known already: the ball comes with [param velocity] to a point that moves with
## [param point_velocity].
static func known(
	at: float,
	ball_center: Vec2,
	with_normal: Vec2,
	velocity: Vec2,
	point_velocity: Vec2,
	bounciness: float
) -> SurfaceImpact:
	var found := SurfaceImpact.new()
	found.hit = true
	found.time = at
	found.center = ball_center
	found.normal = with_normal
	found.coming = velocity
	found._bounce(point_velocity, bounciness)
	return found


func _bounce(point_velocity: Vec2, bounciness: float) -> void:
	touched = point_velocity
	seen = coming.minus(touched)
	bounced = seen.reflected(normal, bounciness)
	leaving = bounced.plus(touched)
