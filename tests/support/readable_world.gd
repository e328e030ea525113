class_name ReadableWorld
extends EventWorld
## An [EventWorld] in which every part that is written out for speed is replaced by the readable
## steps. Both must give the same bits.


func _bounce_off_wall_fast(index: int) -> void:
	impacts += 1
	_restart(index)
	_left_surface[index] = NOTHING
	var wall := _touched[index]
	_move_to_wall(index, wall)
	if wall == LEFT_WALL or wall == RIGHT_WALL:
		_velocity_x[index] *= -_bounciness
	else:
		_velocity_y[index] *= -_bounciness
	_forecast(index)


func _bounce_off_segment_fast(index: int, place: int) -> void:
	_find_contact(index, place)
	var approach := -(_velocity_x[index] * _normal_x + _velocity_y[index] * _normal_y)
	_bounce_off(index, place, maxf(approach, 0.0), null)


func _try_cells(around: int, cells: PackedInt32Array) -> void:
	for place in cells:
		var other := _cells.first[_cells.neighbors[around + place]]
		while other >= 0:
			_try_partner(other)
			other = _cells.next[other]
