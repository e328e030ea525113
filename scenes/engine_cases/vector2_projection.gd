class_name Vector2Projection
extends ScalarProjectionCase
## The scalar projection by the engine's own Vector2, whose components have 32 bits.

var _engine_vectors: PackedVector2Array = []


func _init(of_situation: String, is_quick: bool) -> void:
	super(of_situation, is_quick)
	method = "Vector2"
	is_baseline = true
	for vector in _vectors:
		_engine_vectors.append(vector.to_vector2())


func _calls(rounds: int) -> void:
	for i in rounds:
		for pair in _starts:
			_engine_vectors[pair].dot(_engine_vectors[pair + 1].normalized())


func _no_calls(rounds: int) -> void:
	for i in rounds:
		for pair in _starts:
			@warning_ignore("unused_variable")
			var a := _engine_vectors[pair]
			@warning_ignore("unused_variable")
			var b := _engine_vectors[pair + 1]


func _value(a: Vec2, b: Vec2) -> float:
	return a.to_vector2().dot(b.to_vector2().normalized())
