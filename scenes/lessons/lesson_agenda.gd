class_name LessonAgenda
extends RefCounted
## The headings under which the start screen shows the lessons, in the order of the lecture. It is
## also the order in which one lesson leads to the next. The numbers of the lessons are their places
## in the [LessonIndex]: the lecture has the proof behind.


## A heading with its lessons.
class Part:
	extends RefCounted
	## The heading, translated.
	var title: String
	## What the lessons below it are about, translated.
	var line: String
	## In the order in which they are shown.
	var lessons: Array[LessonInfo] = []

	func _init(its_title: String, its_line: String, ids: PackedStringArray) -> void:
		title = its_title
		line = its_line
		for id in ids:
			var lesson := LessonIndex.find(id)
			if lesson:
				lessons.append(lesson)


## All headings that have a lesson here. A lesson that no heading names is under the last one.
static func parts() -> Array[Part]:
	var found := _lecture()
	var others := LessonIndex.lessons()
	for part in found:
		others = others.filter(
			func(lesson: LessonInfo) -> bool: return not part.lessons.has(lesson)
		)
	var last := Part.new(
		LabText.translate("More lessons"), LabText.translate("What the lecture does not have."), []
	)
	last.lessons = others
	found.append(last)
	return found.filter(func(part: Part) -> bool: return not part.lessons.is_empty())


## All lessons in this order.
static func lessons() -> Array[LessonInfo]:
	var found: Array[LessonInfo] = []
	for part in parts():
		found.append_array(part.lessons)
	return found


static func _lecture() -> Array[Part]:
	return [
		Part.new(
			LabText.translate("Before the lecture"),
			LabText.translate(
				"What a vector is in code, and a bounce that is right on level lines only."
			),
			["class_or_value", "easy_bounce"]
		),
		Part.new(
			LabText.translate("Normals and the dot product"),
			LabText.translate("Where a line faces, and how far one vector reaches along another."),
			["normals", "dot_product"]
		),
		Part.new(
			LabText.translate("A ball and an angled line"),
			LabText.translate("How far away it is, when it touches, and where it goes then."),
			["line_distance", "point_of_impact", "reflection"]
		),
		Part.new(
			LabText.translate("The assignment"),
			LabText.translate("Many balls among many lines."),
			["angled_lines"]
		),
		Part.new(
			LabText.translate("Next time"),
			LabText.translate("Lines that end, and vectors with more components."),
			["line_ends", "more_dimensions"]
		),
		Part.new(
			LabText.translate("Smart aiming"),
			LabText.translate("Where to shoot, and when, so that the shot hits."),
			["aim_at", "lead_target", "ballistic_aim", "bank_shot", "timed_shot", "aiming_game"]
		),
		Part.new(
			LabText.translate("Moving objects"),
			LabText.translate("What balls do to each other and on a slope."),
			["newton_balls", "collision_friction", "slide_and_roll", "moving_platforms"]
		),
		Part.new(
			LabText.translate("Appendix"),
			LabText.translate("Why the projection is right."),
			["projection_proof"]
		),
		Part.new(
			LabText.translate("Beyond the lecture"),
			LabText.translate("Which is closer, which is faster?"),
			["error_and_time"]
		),
	]
