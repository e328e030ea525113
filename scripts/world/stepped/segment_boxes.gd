class_name SegmentBoxes
extends RefCounted
## Finds the segments that a moving ball may touch, so that only these are examined.
##
## All numbers are in packed arrays, because this runs for every ball and segment in every frame. No
## touched segment is ever left out: [constant SLACK] is far larger than any rounding error.

## Pixels by which the ball may miss a segment that is still examined. A larger value costs time.
## One below the rounding of coordinates (1e-9 at a million pixels) could lose an impact.
const SLACK := 1e-6

var _left: PackedFloat64Array = []
var _right: PackedFloat64Array = []
var _top: PackedFloat64Array = []
var _bottom: PackedFloat64Array = []
var _normal_x: PackedFloat64Array = []
var _normal_y: PackedFloat64Array = []
var _offset: PackedFloat64Array = []


## Searches among these segments, which must not be changed in place.
func _init(segments: Array[LineSegment]) -> void:
	for segment in segments:
		var normal := segment.normal()
		_left.append(minf(segment.start.x, segment.end.x))
		_right.append(maxf(segment.start.x, segment.end.x))
		_top.append(minf(segment.start.y, segment.end.y))
		_bottom.append(maxf(segment.start.y, segment.end.y))
		_normal_x.append(normal.x)
		_normal_y.append(normal.y)
		_offset.append(segment.start.dot(normal))


## The indices of the segments that a ball may touch while it moves by [param motion], in order:
## those whose bounding box meets that of the motion, and whose infinite line the ball reaches.
func near(position: Vec2, motion: Vec2, radius: float) -> PackedInt32Array:
	var found: PackedInt32Array = []
	var x := position.x
	var y := position.y
	var across := motion.x
	var down := motion.y
	var reach := radius + SLACK
	var left := minf(x, x + across) - reach
	var right := maxf(x, x + across) + reach
	var top := minf(y, y + down) - reach
	var bottom := maxf(y, y + down) + reach
	for i in _left.size():
		if _left[i] <= right:
			if _right[i] >= left:
				if _top[i] <= bottom:
					if _bottom[i] >= top:
						var old := _normal_x[i] * x + _normal_y[i] * y - _offset[i]
						var new := old + _normal_x[i] * across + _normal_y[i] * down
						if minf(old, new) <= reach and maxf(old, new) >= -reach:
							found.append(i)
	return found
