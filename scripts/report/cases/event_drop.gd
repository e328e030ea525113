class_name EventDrop
extends DropCase
## The dropped ball in the event world: exact between the bounces, however long a step is.

## The name of the method in tables.
const METHOD := "event world"

var _world: EventWorld


## A ball with this bounciness, which is read [param at_rate] times a second.
func _init(with_bounciness: float, at_rate: int) -> void:
	super(with_bounciness, at_rate)
	method = METHOD


func _prepare() -> void:
	_world = EventWorld.new()
	keep_refusal(_world.set_gravity(Vec2.new(0.0, DroppedBall.GRAVITY)))
	keep_refusal(_world.set_bounciness(bounciness))
	keep_refusal(_world.set_segments(DroppedBall.floors()))
	keep_refusal(_world.set_balls([DroppedBall.ball()]))


func _fly(count: int) -> void:
	var world := _world
	var start := Time.get_ticks_usec()
	for i in count:
		var refused := world.advance(step_seconds)
		if refused:
			keep_refusal(refused)
			break
		_height = -world.position_y(0) - DroppedBall.RADIUS
	_spent = Time.get_ticks_usec() - start
	_speed = world.velocity(0).y
