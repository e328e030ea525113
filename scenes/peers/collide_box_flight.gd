class_name CollideBoxFlight
extends BoxFlight
## The ball in the box by move_and_collide, as its documentation has it: with the default margin,
## and the rest of the motion bounced and used until it is used up.
##
## The body moves by itself, so many steps fit into one physics frame.

var _host: Node
var _is_one_shape: bool
var _space: PeerSpace
var _body: CharacterBody2D


func _init(
	host: Node, is_one_shape: bool, at_speed: float, for_seconds: float, at_rate: int
) -> void:
	super(at_speed, for_seconds, at_rate)
	_host = host
	_is_one_shape = is_one_shape
	method = "move_and_collide, " + ("concave shape" if is_one_shape else "segments")
	is_peer = true


func _prepare() -> void:
	_space = PeerSpace.new(_host)
	_space.add_walls(BallInBox.walls(), _is_one_shape)
	_body = CharacterBody2D.new()
	_space.add_ball(_body, BallInBox.ball(speed))


func _fly(count: int) -> void:
	var body := _body
	var velocity := BallInBox.ball(speed).velocity.to_vector2()
	var seconds_a_step := step_seconds
	var start := Time.get_ticks_usec()
	for i in count:
		var collision := body.move_and_collide(velocity * seconds_a_step)
		var contacts := 0
		while collision and contacts < PeerSpace.MOST_CONTACTS:
			var normal := collision.get_normal()
			velocity = velocity.bounce(normal)
			contacts += 1
			collision = body.move_and_collide(collision.get_remainder().bounce(normal))
		var place := body.position
		_x = place.x
		_y = place.y
	_spent = Time.get_ticks_usec() - start


func _clear() -> void:
	_space.free()
