class_name WorkshopReferenceReflect
extends Vec2
## A right answer to the exercise about reflection, by the lab's own code. The lab's own method
## refuses a normal that is not unit; here it is normalized, which is the other right answer.


## See exercise 9.
func reflect(unit_normal: Vec2, bounciness: float = 1.0) -> void:
	super.reflect(unit_normal.normalized(), bounciness)
