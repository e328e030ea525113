class_name AngledLinesReadout
extends RefCounted
## The readout of the lesson on angled lines: what becomes of the energy in each way of stepping.

# Microseconds of a paused frame that the comparison may take.
const _SLICE := 4000

var _readout: Readout
var _comparison := MethodComparison.new()
var _is_comparing := false


## Writes into [param readout].
func _init(readout: Readout) -> void:
	_readout = readout
	_readout.is_the_point = true


## Begins to compare the ways of stepping from [param world] on.
func begin(world: SteppedWorld) -> void:
	_comparison.begin(world)
	_is_comparing = true
	_show()


## Goes on comparing for a moment; does nothing at the end of the comparison.
func advance() -> void:
	if _is_comparing:
		_is_comparing = _comparison.advance(_SLICE, AngledLinesModel.FRAME)
		_show()


func _show() -> void:
	_readout.show_headings(AngledLinesTexts.headings(_comparison.frames()))
	for method: int in SteppingMethods.Method.size():
		var row := AngledLinesTexts.comparison(_comparison, method as SteppingMethods.Method)
		_readout.show_texts(str(method), row)
