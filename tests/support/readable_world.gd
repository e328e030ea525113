class_name ReadableWorld
extends EventWorld
## An [EventWorld] in which every part that is written out for speed is replaced by the readable
## steps. Both must give the same bits.


func _bounce_off_segment_fast(index: int, place: int) -> void:
	_find_contact(index, place)
	var approach := -(_velocity_x[index] * _normal_x + _velocity_y[index] * _normal_y)
	_bounce_off(index, place, maxf(approach, 0.0), null)


func _bounce_between_walls(index: int, _target: float, _target_low: float) -> void:
	_happen(index)


func _choose_event_fast(index: int, is_new: bool) -> void:
	if is_new:
		_forecast_meeting(index)
		return
	_ask(index)
	_choose_event(index)


func _cross_fast(index: int) -> void:
	_cross(index)


func _collide_fast(one: int, other: int) -> void:
	_collide_by_laws(one, other)


func _write_places_fast(into: PackedFloat64Array) -> void:
	for index in ball_count():
		into[2 * index] = position_x(index)
		into[2 * index + 1] = position_y(index)
