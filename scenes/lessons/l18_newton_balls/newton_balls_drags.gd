class_name NewtonBallsDrags
extends RefCounted
## What the student drags in the lesson on balls: a ball by its handle or its disc, its velocity,
## its mass, and the bounciness. The balls as they fly then are the new start.

## The balls as they fly.
var run: BallRun
## So long they have flown.
var seconds := 0.0

var _lesson: Lesson
var _model: NewtonBallsModel
var _drawing: NewtonBallsDrawing
# The ball that is dragged by its disc, -1 for none, and from the pointer to its centre.
var _held := -1
var _grip := Vec2.new()


func _init(lesson: Lesson, model: NewtonBallsModel, drawing: NewtonBallsDrawing) -> void:
	_lesson = lesson
	_model = model
	_drawing = drawing
	for place: int in _drawing.vectors().size():
		var vector := _drawing.vectors()[place]
		lesson.on_drag(vector.moved, vector.released, _drag_vector.bind(place))
	for number: int in 2:
		var handle := lesson.get_node("%%Mass%d" % (number + 1)) as Handle
		lesson.on_drag(handle.moved, handle.released, _drag_mass.bind(number))
	var bounciness := lesson.get_node("%Bounciness") as Handle
	lesson.on_drag(bounciness.moved, bounciness.released, _drag_bounciness)
	lesson.on_point(MOUSE_BUTTON_LEFT, _drag_disc)
	lesson.board.released.connect(func() -> void: _held = -1)


func _drag_vector(tail: Vec2, head: Vec2, place: int) -> String:
	_stop_balls()
	var index := _drawing.ball_of(place)
	var ball := _model.world_balls()[index]
	if tail.distance_to(ball.position) > 0.0:
		return _model.move_ball(index, tail)
	return _model.set_velocity(index, head.minus(tail))


func _drag_mass(knob: Vec2, number: int) -> String:
	_stop_balls()
	return _model.set_mass(number, _drawing.mass_for(_model.world_balls()[number].position, knob))


func _drag_bounciness(knob: Vec2) -> void:
	_stop_balls()
	_model.bounciness = _drawing.bounciness_for(knob)


# A ball is dragged by any point of its disc.
func _drag_disc(at: Vec2) -> String:
	if _held < 0:
		_held = _ball_at(at)
		if _held < 0:
			return ""
		_grip = run.balls()[_held].position.minus(at)
	_stop_balls()
	return _model.move_ball(_held, _lesson.board.snapped_to_step(at.plus(_grip)))


func _ball_at(at: Vec2) -> int:
	var balls := run.balls()
	for index: int in balls.size():
		if at.distance_to(balls[index].position) <= balls[index].radius:
			return index
	return -1


func _stop_balls() -> void:
	if seconds > 0.0:
		_model.start_from(run.balls())
		seconds = 0.0
