extends RefCounted
## The course's rubric as a page of the web site and of the report: the same lines as the lab's own
## page, each with links to the lesson, the exercises and the tests that show it.

const WebPages := preload("web_pages.gd")

const FORM := "res://tools/web/rubric_page.html"

const _STARTERS := "workshop/starters"
const _LINK := '<a href="%s">%s</a>'
const _OWN_PROJECT := "<span>To be shown in your own project</span>"


## The page. [param lab] is the address of the lab, behind which `#` and a lesson come;
## [param source] makes an address of the path of a file in the project, in place of its `%s`.
static func page(lab: String, source: String) -> String:
	var form := FileAccess.get_file_as_string(FORM)
	var of_mark := WebPages.between(form, "mark")
	var of_line := WebPages.between(form, "line")
	var lines_of: Dictionary[WorkshopReport.Mark, String] = {}
	for line in Rubric.lines():
		var cells := {
			"text": line.text.xml_escape(), "links": " · ".join(_links(line, lab, source))
		}
		lines_of[line.mark] = lines_of.get(line.mark, "") + of_line.format(cells)
	var marks := ""
	for mark in lines_of:
		var heading := {"mark": WorkshopReport.name_of(mark).xml_escape()}
		marks += WebPages.fill(of_mark, "line", lines_of[mark]).format(heading)
	return WebPages.fill(form, "mark", marks)


## The files of the project that the page leads to, as paths below `res://`.
static func sources() -> PackedStringArray:
	var found: PackedStringArray = []
	for line in Rubric.lines():
		for file: String in _starters(line).values() + Array(line.tests):
			if not file in found:
				found.append(file)
	return found


static func _links(line: RubricLine, lab: String, source: String) -> PackedStringArray:
	var links: PackedStringArray = []
	var lesson := LessonIndex.find(line.lesson)
	if lesson:
		var words := "Lesson %d: %s" % [LessonIndex.number_of(lesson), lesson.title]
		links.append(_LINK % ["%s#%s" % [lab, lesson.id], words.xml_escape()])
	var starters := _starters(line)
	for words in starters:
		links.append(_LINK % [source % starters[words], words.xml_escape()])
	if line.proof == RubricLine.Proof.OWN_PROJECT:
		links.append(_OWN_PROJECT)
	for path in line.tests:
		links.append(_LINK % [source % path, "Test: %s" % path.get_file()])
	return links


# What the student writes in, by the words for it.
static func _starters(line: RubricLine) -> Dictionary[String, String]:
	var found: Dictionary[String, String] = {}
	for number in line.exercises:
		var exercise := WorkshopIndex.exercise(number)
		var file: String = WorkshopFiles.CLASSES.find_key(exercise.home())
		found["Exercise %d: %s" % [number, exercise.title]] = _STARTERS.path_join(file)
	if line.proof in [RubricLine.Proof.TESTS, RubricLine.Proof.ALL_TESTS]:
		var title := WorkshopIndex.exercise(WorkshopIndex.TESTS).title
		found["Exercise %d: %s" % [WorkshopIndex.TESTS, title]] = _STARTERS.path_join(
			WorkshopFiles.TEST_PREFIX + "vec2.gd"
		)
	return found
