class_name SharingExercise
extends Exercise
## Asks what one name holds after the other was changed: objects are shared, values are not.

## What is given a second name.
enum Kind { VEC2, VECTOR2, COPY, NEW_OBJECT }

const _ASSIGNMENTS: Dictionary[Kind, String] = {
	Kind.VEC2: "old = Vec2.new(%d, %d)\nnow = old\nnow.x = %d",
	Kind.VECTOR2: "old = Vector2(%d, %d)\nnow = old\nnow.x = %d",
	Kind.COPY: "old = Vec2.new(%d, %d)\nnow = old.copy()\nnow.x = %d",
	Kind.NEW_OBJECT: "old = Vec2.new(%d, %d)\nnow = old\nnow = Vec2.new(%d, 0)",
}

var _kind: Kind


## A question with x and y at first, and another x later.
func _init(kind: Kind, first_x: int, y: int, later_x: int) -> void:
	_kind = kind
	var code := _ASSIGNMENTS[kind] % [first_x, y, later_x]
	prompt = code + "\n" + tr("What is old.x now?")
	answer_titles = ["old.x ="]
	right_answer = [float(later_x if kind == Kind.VEC2 else first_x)]
	add_mistake([float(first_x if kind == Kind.VEC2 else later_x)], _sentence(kind))
	add_mistake([float(y)], tr("That is y."))


## A question with numbers drawn from [param rng].
static func fresh(kind: Kind, rng: RandomNumberGenerator) -> SharingExercise:
	var first_x := rng.randi_range(1, 9)
	return new(kind, first_x, rng.randi_range(10, 19), first_x + rng.randi_range(1, 9))


func solution() -> String:
	return "%s %s" % [super() + ".", _sentence(_kind)]


func _sentence(kind: Kind) -> String:
	match kind:
		Kind.VEC2:
			return tr("A Vec2 is an object: now = old gives it a second name, not a copy.")
		Kind.VECTOR2:
			return tr("A Vector2 is a value: now = old copies it, and old stays.")
		Kind.NEW_OBJECT:
			return tr("now = Vec2.new(…) gives the name now another object: old keeps its own.")
	return tr("copy() makes a new Vec2: old stays as it was.")
