class_name ProjectionByDotProduct
extends ScalarProjectionCase
## The scalar projection by the dot product: [method Vec2.scalar_projection].


## See [ScalarProjectionCase].
func _init(of_situation: String, is_quick: bool) -> void:
	super(of_situation, is_quick)
	method = "dot product"


func _calls(rounds: int) -> void:
	for i in rounds:
		for pair in _starts:
			_vectors[pair].scalar_projection(_vectors[pair + 1])


func _value(a: Vec2, b: Vec2) -> float:
	return a.scalar_projection(b)
