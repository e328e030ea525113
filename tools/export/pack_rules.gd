extends RefCounted
## What a demo's pack must not hold, and how large it may be. Each broken rule is one sentence.

const Demos := preload("demos.gd")
const Pack := preload("pack.gd")
const PackUse := preload("pack_use.gd")

## Lessons in which nothing collides.
const VECTOR_LESSONS: PackedStringArray = [
	"class_or_value",
	"normals",
	"dot_product",
	"projection_proof",
	"reflection",
	"more_dimensions",
]
## In bytes.
const VECTOR_LESSON_LIMIT := 230_000
const LESSON_LIMIT := 400_000
## It measures every method of the lab, so it holds the whole event world: friction too, and what
## the world asks of segments that might move.
const LARGER: Dictionary[String, int] = {"error_and_time": 425_000}

const _IN_NO_PACK: PackedStringArray = ["addons", "benchmarks", "docs", "tests", "tools"]
# What judges and shows a student's code is in the lab and in the workshop's own demo.
const _IN_NO_LESSON: PackedStringArray = ["scenes/workshop", "workshop"]
const _IN_NO_VECTOR_LESSON: PackedStringArray = [
	"scripts/collision", "scripts/world", "scripts/report", "scenes/engine_cases"
]


## The rules that the pack of [param demo] breaks; none when all is well.
static func broken_by(demo: String, pack: Pack) -> PackedStringArray:
	if pack.problem:
		return [pack.problem]
	var broken: PackedStringArray = []
	var use := PackUse.new(pack, Demos.opened_by_engine(demo))
	for file: String in use.unused:
		broken.append("%s holds %s, which nothing in it uses" % [demo, file])
	for path: String in use.missing_classes:
		broken.append("%s lists the class of %s, which it does not hold" % [demo, path])
	for path: String in use.unreadable:
		broken.append("%s holds %s in a form that cannot be read" % [demo, path])
	return broken + _misplaced(demo, use) + _too_large(demo, pack)


static func _misplaced(demo: String, use: PackUse) -> PackedStringArray:
	var misplaced: PackedStringArray = []
	var forbidden := _IN_NO_PACK.duplicate()
	if not Demos.FEATURES.has(demo):
		forbidden.append_array(_IN_NO_LESSON)
	if demo in VECTOR_LESSONS:
		forbidden.append_array(_IN_NO_VECTOR_LESSON)
	for path: String in use.resources:
		for folder: String in forbidden:
			if path.begins_with("res://%s/" % folder):
				misplaced.append("%s holds %s: it has no business there" % [demo, path])
	return misplaced


static func _too_large(demo: String, pack: Pack) -> PackedStringArray:
	var limit: int = LARGER.get(demo, LESSON_LIMIT)
	if demo in VECTOR_LESSONS:
		limit = VECTOR_LESSON_LIMIT
	if demo == Demos.LAB or pack.total_size <= limit:
		return []
	return ["%s has %d bytes, more than %d" % [demo, pack.total_size, limit]]
