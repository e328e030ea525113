class_name ProjectionByAngles
extends ScalarProjectionCase
## The scalar projection by the lecture's long way: atan2 twice, then the cosine.


## See [ScalarProjectionCase].
func _init(of_situation: String, is_quick: bool) -> void:
	super(of_situation, is_quick)
	method = "atan2 and cos"


func _calls(rounds: int) -> void:
	for i in rounds:
		for pair in _starts:
			PrimitiveProjection.scalar(_vectors[pair], _vectors[pair + 1])


func _value(a: Vec2, b: Vec2) -> float:
	return PrimitiveProjection.scalar(a, b)
