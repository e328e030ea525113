class_name CollideFlight
extends ShotFlight
## A ball's flight by move_and_collide, as in Godot's documentation: with the default margin, and
## with the rest of the motion bounced and used until nothing is left.
##
## The call moves the body at once, so that many steps fit into one physics frame.

var _host: Node
var _is_one_shape: bool
var _space: EngineSpace
var _body: CharacterBody2D
var _velocity: Vector2


func _init(host: Node, is_one_shape: bool, of_shot: Shot, at_rate: int) -> void:
	super(of_shot, at_rate)
	_host = host
	_is_one_shape = is_one_shape
	method = "move_and_collide, " + ("concave shape" if is_one_shape else "segments")
	is_baseline = true


func _prepare() -> void:
	_space = EngineSpace.new(_host)
	_space.add_walls(shot.segments(), _is_one_shape)
	_body = CharacterBody2D.new()
	_space.add_ball(_body, shot.ball)
	_velocity = shot.ball.velocity.to_vector2()


func _fly(count: int) -> void:
	var body := _body
	var velocity := _velocity
	var start := Time.get_ticks_usec()
	for i in count:
		var collision := body.move_and_collide(velocity * step_seconds)
		var contacts := 0
		while collision and contacts < EngineSpace.MOST_CONTACTS:
			var normal := collision.get_normal()
			velocity = velocity.bounce(normal)
			contacts += 1
			collision = body.move_and_collide(collision.get_remainder().bounce(normal))
		var place := body.position
		_x = place.x
		_y = place.y
	_spent = Time.get_ticks_usec() - start
	_velocity = velocity


func _clear() -> void:
	_space.free()
