class_name EmptyCall
extends FlightCase
## What an interface costs that is called each frame and does nothing: a call with one argument that
## does nothing, and two reads of a packed array. No method in GDScript that is called each frame
## and tells a place can be faster, so the ratio of a baseline to it is the ceiling of their ratios.

## The name of the method in tables.
const METHOD := "an empty call"

# The place that is read.
var _places: PackedFloat64Array = [0.0, 0.0]
var _x := 0.0
var _y := 0.0
var _called := Called.new()


## Frames of this shot, [param at_rate] a second.
func _init(shot: Shot, at_rate: int) -> void:
	super(shot.seconds, at_rate)
	problem = shot.problem
	situation = shot.situation
	method = METHOD


func _prepare() -> void:
	pass


func _fly(count: int) -> void:
	var called := _called
	var places := _places
	var start := Time.get_ticks_usec()
	for i in count:
		called.do_nothing((i + 1) * step_seconds)
		_x = places[0]
		_y = places[1]
	_spent = Time.get_ticks_usec() - start


func _find_error() -> void:
	error = Measurement.NO_ANSWER
	note = "it does nothing, and shows what the call alone takes"


## The object that is called.
class Called:
	extends RefCounted

	## Does nothing.
	func do_nothing(_moment: float) -> void:
		pass
