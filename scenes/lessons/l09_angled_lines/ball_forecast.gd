class_name BallForecast
extends RefCounted
## What one ball will do in the next moments: worked out by stepping a copy of its world.

# Further bounces would only make a tangle.
const _MOST_BOUNCES := 2

## The centre's places, frame by frame, with the points of impact between them.
var path: Array[Vec2] = []
## The first bounce to come; null if there is none within the time looked at.
var next_bounce: BounceRecord


## Looks [param frames] frames of [param seconds] ahead for the ball at the place [param index];
## less far where it bounces twice before that, or where its world refuses to go on.
static func of(world: SteppedWorld, index: int, seconds: float, frames: int) -> BallForecast:
	var forecast := BallForecast.new()
	var copy := world.copy(index)
	forecast.path.append(copy.balls[0].position.copy())
	for frame in frames:
		var problem := copy.step(seconds)
		forecast._add(copy)
		if problem or copy.lost_count() or copy.bounces >= _MOST_BOUNCES:
			break
	return forecast


func _add(world: SteppedWorld) -> void:
	for record in world.latest_bounces:
		path.append(record.position)
		if not next_bounce:
			next_bounce = record
	path.append(world.balls[0].position.copy())
