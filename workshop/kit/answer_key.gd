@tool
class_name WorkshopAnswerKey
extends RefCounted
## The lab's own right answers, by the checksums of their shapes: a method of these, written down
## again, tells nothing of the student. A pack holds the checksums and not the text.

## Where a pack holds them. In two parts, because it is no file of the project that an export would
## look for.
const PACKED := "res:/" + "/answer_key.txt"

# A body with this many tokens is not written the same way twice by chance.
const _LONG := 40
const _FILES: PackedStringArray = [
	"res://scripts/vec2.gd",
	"res://scripts/collision/segment_impact.gd",
	"res://scripts/collision/cap_impact.gd",
	"res://scripts/collision/point_of_impact.gd",
	"res://scripts/collision/straight_impact_finder.gd",
	"res://scripts/aiming/lead_aim.gd",
	"res://scripts/aiming/ballistic_aim.gd",
	"res://scripts/aiming/bank_aim.gd",
]

static var _sums: PackedStringArray = []


## Whether [param shape], from [method WorkshopCode.shape_of], is that of one of its methods.
static func has(shape: PackedStringArray) -> bool:
	return shape.size() >= _LONG and " ".join(shape).md5_text() in sums()


## The checksums of all methods that are long enough.
static func sums() -> PackedStringArray:
	if _sums.is_empty():
		if FileAccess.file_exists(PACKED):
			_sums = FileAccess.get_file_as_string(PACKED).split("\n")
		else:
			_sums = _sums_of_files()
	return _sums


static func _sums_of_files() -> PackedStringArray:
	var found: PackedStringArray = []
	for path in _FILES:
		var code := WorkshopCode.new(FileAccess.get_file_as_bytes(path))
		for function in code.functions():
			var shape := code.shape_of(function)
			if shape.size() >= _LONG:
				found.append(" ".join(shape).md5_text())
	return found
