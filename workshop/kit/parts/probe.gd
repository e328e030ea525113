class_name WorkshopProbe
extends RefCounted
## One call of a student's method, with plain numbers, and how the student is told which one it is.

## Such as `(3, 1)` or `(7, 1) on (8, -6)`, translated.
var title: String
## What is handed over, one number after the other, in the order of [member WorkshopTask.takes].
var numbers: PackedFloat64Array
## How far an answer may be from the right one, as a part of it (of 1 for smaller ones).
var tolerance := 1e-6
## Whether most mistakes say nothing about it, such as the zero vector; see [WorkshopWay].
var is_special := false
## Whether it counts for the mark "excellent" only.
var is_extra := false
## Whether the last parameter is left out, so that its default counts.
var leaves_out_last := false
## How many times the method is called in a row; what is compared then is the energy at the end as a
## part of that at the start.
var repeats := 1


## A probe of its own numbers.
func _init(its_title: String, its_numbers: Array[float]) -> void:
	title = its_title
	numbers = PackedFloat64Array(its_numbers)


## The same probe, as a special one.
func special() -> WorkshopProbe:
	is_special = true
	return self


## The same probe, for the mark "excellent" only.
func extra() -> WorkshopProbe:
	is_extra = true
	return self


## The same probe, with the last parameter left out.
func by_default() -> WorkshopProbe:
	leaves_out_last = true
	return self


## The same probe with another tolerance.
func to_within(its_tolerance: float) -> WorkshopProbe:
	tolerance = its_tolerance
	return self


## The same probe, called [param times] times in a row.
func repeated(times: int) -> WorkshopProbe:
	repeats = times
	return self


## Whether [param got] is the answer [param wanted] to this probe.
func agrees(got: PackedFloat64Array, wanted: PackedFloat64Array) -> bool:
	if got.size() != wanted.size():
		return false
	for i in got.size():
		if not _is_same(got[i], wanted[i]):
			return false
	return true


func _is_same(got: float, wanted: float) -> bool:
	if is_nan(got) or is_nan(wanted):
		return is_nan(got) and is_nan(wanted)
	if is_inf(got) or is_inf(wanted):
		return got == wanted
	return absf(got - wanted) <= tolerance * maxf(1.0, absf(wanted))
