@abstract class_name ScalarProjectionCase
extends MeasuredCase
## A way to compute the scalar projection, measured over many pairs of vectors.

const _ROUNDS := 50
const _QUICK_ROUNDS := 20

var _rounds: int
var _vectors: Array[Vec2]
# The index at which each pair begins in _vectors.
var _starts: PackedInt32Array = []


## The case for one of [constant ProjectionPairs.SITUATIONS].
func _init(of_situation: String, is_quick: bool) -> void:
	problem = "scalar_projection"
	error_unit = "share of |a|"
	situation = of_situation
	_rounds = _QUICK_ROUNDS if is_quick else _ROUNDS
	_vectors = ProjectionPairs.of(situation)
	_starts = range(0, _vectors.size(), 2)


## See [method MeasuredCase.run_once]: the run time of the loop without the call is subtracted.
func run_once() -> void:
	if runs() == 0:
		_find_error()
	var start := Time.get_ticks_usec()
	_calls(_rounds)
	var middle := Time.get_ticks_usec()
	_no_calls(_rounds)
	var loop := Time.get_ticks_usec() - middle
	keep_run(maxf(middle - start - loop, 0.0) / (_rounds * _starts.size()))


## Calls the function for all pairs.
@abstract func _calls(rounds: int) -> void

## The result of the function for one pair.
@abstract func _value(a: Vec2, b: Vec2) -> float


# The same loop: it reads the vectors and does nothing with them.
func _no_calls(rounds: int) -> void:
	for i in rounds:
		for pair in _starts:
			@warning_ignore("unused_variable")
			var a := _vectors[pair]
			@warning_ignore("unused_variable")
			var b := _vectors[pair + 1]


func _find_error() -> void:
	var lost := 0
	for pair in _starts:
		var a := _vectors[pair]
		var b := _vectors[pair + 1]
		var value := _value(a, b)
		if is_finite(value):
			var wrong := ExactProjection.error_of_scalar_projection(value, a, b)
			error = maxf(error, absf(wrong) / a.length())
		else:
			lost += 1
	if lost > 0:
		error = Measurement.NO_ANSWER
		note = "no finite answer for %d of %d pairs" % [lost, _starts.size()]
