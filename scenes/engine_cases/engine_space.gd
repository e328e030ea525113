class_name EngineSpace
extends SubViewport
## A physics space for the engine's bodies that are measured, so that they meet nothing else. It is
## not drawn.

## The most contacts in one step; then the rest of the motion is dropped.
const MOST_CONTACTS := 8


## An empty space below [param host], without gravity.
func _init(host: Node) -> void:
	world_2d = World2D.new()
	size = Vector2i(2, 2)
	render_target_update_mode = SubViewport.UPDATE_DISABLED
	host.add_child(self)
	set_gravity(0.0)


## Sets gravity: downwards, in pixels per second squared.
func set_gravity(gravity: float) -> void:
	PhysicsServer2D.area_set_param(world_2d.space, PhysicsServer2D.AREA_PARAM_GRAVITY, gravity)
	PhysicsServer2D.area_set_param(
		world_2d.space, PhysicsServer2D.AREA_PARAM_GRAVITY_VECTOR, Vector2.DOWN
	)


## Adds the segments as one static body: each as a shape of its own, or all as one concave shape.
func add_walls(segments: Array[LineSegment], as_one_shape: bool) -> StaticBody2D:
	var wall := StaticBody2D.new()
	if as_one_shape:
		_add_shape(wall, _concave(segments))
	else:
		for segment in segments:
			var shape := SegmentShape2D.new()
			shape.a = segment.start.to_vector2()
			shape.b = segment.end.to_vector2()
			_add_shape(wall, shape)
	add_child(wall)
	return wall


## Adds a body with the radius and position of [param ball].
func add_ball(body: CollisionObject2D, ball: Ball) -> void:
	var circle := CircleShape2D.new()
	circle.radius = ball.radius
	_add_shape(body, circle)
	body.position = ball.position.to_vector2()
	add_child(body)


## Adds a rigid body that bounces elastically, without friction, damping or rotation.
func add_rigid_ball(ball: Ball, mode: RigidBody2D.CCDMode) -> RigidBody2D:
	var body := RigidBody2D.new()
	body.physics_material_override = PhysicsMaterial.new()
	body.physics_material_override.friction = 0.0
	# The engine adds the bounciness of both bodies and clamps the sum: so the walls have none.
	body.physics_material_override.bounce = 1.0
	body.linear_damp_mode = RigidBody2D.DAMP_MODE_REPLACE
	body.linear_damp = 0.0
	body.can_sleep = false
	body.lock_rotation = true
	body.mass = ball.mass
	body.continuous_cd = mode
	add_ball(body, ball)
	body.linear_velocity = ball.velocity.to_vector2()
	return body


func _add_shape(body: CollisionObject2D, shape: Shape2D) -> void:
	var holder := CollisionShape2D.new()
	holder.shape = shape
	body.add_child(holder)


func _concave(segments: Array[LineSegment]) -> ConcavePolygonShape2D:
	var points: PackedVector2Array = []
	for segment in segments:
		points.append(segment.start.to_vector2())
		points.append(segment.end.to_vector2())
	var shape := ConcavePolygonShape2D.new()
	shape.segments = points
	return shape
