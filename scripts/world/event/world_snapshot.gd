class_name WorldSnapshot
extends RefCounted
## Everything that moves in an [EventWorld] at one moment, to the last bit: made by
## [method EventWorld.snapshot], put back by [method EventWorld.restore].

## When it was taken, in seconds of the world.
var time := 0.0
## The second part of the time: see [EventState].
var time_low := 0.0
## Impacts until then.
var impacts := 0
## Which state of the segments, walls, gravity and bounciness it belongs to.
var contents := 0
## When the count of impacts within a second began.
var count_from := 0.0
## How many impacts there were before.
var counted_impacts := 0
## Whether the balls were in cells.
var uses_cells := false
## The edge of a cell then, in pixels.
var cell_size := 1.0
## How many columns the table of cells had.
var cell_columns := 0
## The ways of the balls over caps; they never change.
var slides: Array[CapSlide] = []
## Copies of the world's arrays, in the world's own order.
var arrays: Array = []


## Keeps copies of these packed arrays.
func keep(packed_arrays: Array) -> void:
	for numbers: Variant in packed_arrays:
		if numbers is PackedFloat64Array:
			var floats: PackedFloat64Array = numbers
			arrays.append(floats.duplicate())
		elif numbers is PackedInt64Array:
			var longs: PackedInt64Array = numbers
			arrays.append(longs.duplicate())
		elif numbers is PackedInt32Array:
			var ints: PackedInt32Array = numbers
			arrays.append(ints.duplicate())
		else:
			var bytes: PackedByteArray = numbers
			arrays.append(bytes.duplicate())


## Fills these packed arrays, in the order in which they were kept, with what they held.
func put_into(packed_arrays: Array) -> void:
	for place in arrays.size():
		var numbers: Variant = packed_arrays[place]
		if numbers is PackedFloat64Array:
			var floats: PackedFloat64Array = numbers
			var kept: PackedFloat64Array = arrays[place]
			floats.clear()
			floats.append_array(kept)
		elif numbers is PackedInt64Array:
			var longs: PackedInt64Array = numbers
			var kept: PackedInt64Array = arrays[place]
			longs.clear()
			longs.append_array(kept)
		elif numbers is PackedInt32Array:
			var ints: PackedInt32Array = numbers
			var kept: PackedInt32Array = arrays[place]
			ints.clear()
			ints.append_array(kept)
		else:
			var bytes: PackedByteArray = numbers
			var kept: PackedByteArray = arrays[place]
			bytes.clear()
			bytes.append_array(kept)
