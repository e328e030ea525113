class_name EventCrowd
extends CrowdFlight
## Many balls in the event world.

## The name of the method in tables.
const METHOD := "event world"

var _world: EventWorld


## A flight of these balls, which are read [param at_rate] times a second.
func _init(of_crowd: Crowd, at_rate: int) -> void:
	super(of_crowd, at_rate)
	method = METHOD


func _prepare() -> void:
	_world = EventWorld.new()
	keep_refusal(_world.set_walls(Vec2.new(), Vec2.new(crowd.side, crowd.side)))
	keep_refusal(_world.set_balls(crowd.balls()))


func _fly(count: int) -> void:
	var world := _world
	_places = world.places
	var begin := world.time
	var start := Time.get_ticks_usec()
	for i in count:
		world.moment = begin + (i + 1) * step_seconds
	_spent = Time.get_ticks_usec() - start
	# A world that has stopped on the way says so again.
	keep_refusal(world.advance_to(begin + count * step_seconds))


func _velocities() -> PackedFloat64Array:
	var found: PackedFloat64Array = []
	for index in crowd.count:
		var velocity := _world.velocity(index)
		found.append(velocity.x)
		found.append(velocity.y)
	return found


func _turn_round() -> void:
	var turned: Array[Ball] = []
	for index in crowd.count:
		var ball := _world.ball(index)
		ball.velocity.scale(-1.0)
		turned.append(ball)
	keep_refusal(_world.set_balls(turned))


func _remark() -> String:
	return "; %d collisions a second" % roundi(_world.impacts / seconds)
