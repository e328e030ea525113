class_name LessonJudge
extends RefCounted
## Judges what a lesson says in words: one for each lesson, beside its tests. This one, for a lesson
## without a judge of its own, finds nothing.
##
## A judge knows the state and what is seen, and works out the rest by plain formulas of its own. It
## asks neither the lesson's model nor the core of the lab.

const _PLACE := "res://tests/integration/lessons/%s/%s_judge.gd"


## The judge of the lesson with this id.
static func of(id: StringName) -> LessonJudge:
	var path := _PLACE % [id, id]
	if not ResourceLoader.exists(path):
		return LessonJudge.new()
	var script := load(path) as GDScript
	return script.new() if script.get_base_script() == LessonJudge else LessonJudge.new()


## "" or what of [param _seen] is false, in one sentence that quotes it.
func problem(_seen: SeenLesson) -> String:
	return ""


## The first of [param problems] that is one; "" if none is.
static func first_of(problems: PackedStringArray) -> String:
	for found in problems:
		if found:
			return found
	return ""


## The first claim in [param texts] that does not hold: [param claims] says for words whether what
## they claim is so. The longest words that a text holds count. A text without any of them is told,
## too, so that a new sentence gets its claim.
static func false_claim(texts: PackedStringArray, claims: Dictionary[String, bool]) -> String:
	for shown in texts:
		var text := in_degrees(shown)
		var found := ""
		for words in claims:
			if text.contains(words) and words.length() > found.length():
				found = words
		if not found:
			return "no claim is known for “%s”" % text
		if not claims[found]:
			return "it is not so: “%s”" % text
	return ""


## [param text] with its right angles in degrees, as claims have them, where the lab uses radians.
static func in_degrees(text: String) -> String:
	return text.replace("π/2", "90°") if Conventions.uses_radians() else text


## The first of [param labels] that is not one of [param claims], or should not be there. The claims
## say for whole labels whether they may be on the board.
static func false_label(labels: PackedStringArray, claims: Dictionary[String, bool]) -> String:
	for shown in labels:
		var label := in_degrees(shown)
		if not claims.has(label):
			return "no claim is known for the label “%s”" % label
		if not claims[label]:
			return "it should not be on the board: “%s”" % label
	return ""


## The first number in [param texts] that does not stand for the right one: [param wanted] holds the
## right one by the words before it. [param rounding] is what double numbers may be off by.
static func false_number(
	texts: PackedStringArray, wanted: Dictionary[String, float], rounding: float
) -> String:
	for text in texts:
		for words in wanted:
			var shown := SeenLesson.number_behind(words, text)
			if not is_nan(shown) and not SeenLesson.is_close(shown, wanted[words], rounding):
				return "it is %s: “%s”" % [wanted[words], text]
	return ""


## The two numbers of [param text], such as `(3, −4)`; two NAN where there are none.
static func pair(text: String) -> PackedFloat64Array:
	var parts := text.strip_edges().trim_prefix("(").get_slice(")", 0).split(", ")
	if not text.contains("(") or parts.size() != 2:
		return [NAN, NAN]
	return [SeenLesson.first_number(parts[0]), SeenLesson.first_number(parts[1])]


## Whether [param text] is the pair [param x], [param y], as [method SeenLesson.is_close] has it.
static func is_pair(text: String, x: float, y: float, rounding: float) -> bool:
	var numbers := pair(text)
	return (
		SeenLesson.is_close(numbers[0], x, rounding)
		and SeenLesson.is_close(numbers[1], y, rounding)
	)
