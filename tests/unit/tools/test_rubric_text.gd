extends LabTest
## The page of the site and of the report with the rubric: every line of the lab's own page is on
## it, and each of its links leads to something that is there.

const RubricText := preload("res://tools/web/rubric_text.gd")
const WebPages := preload("res://tools/web/web_pages.gd")

const _LAB := "lab/index.html"
const _HREF := 'href="([^"]*)"'


func test_every_line_is_on_the_page_under_its_mark() -> void:
	var sections := _page().split("<section>")
	assert_eq(sections.size(), 4, "three marks")
	for line in Rubric.lines():
		var heading := "For “%s”" % WorkshopReport.name_of(line.mark)
		for section in sections:
			var is_there := section.contains("<h3>%s</h3>" % line.text.xml_escape())
			assert_eq(is_there, section.contains(heading), line.text)


func test_every_link_leads_to_a_lesson_or_a_file_that_is_there() -> void:
	var files: PackedStringArray = []
	for found in RegEx.create_from_string(_HREF).search_all(_page()):
		var address := found.get_string(1)
		if address.begins_with(_LAB + "#"):
			assert_not_null(LessonIndex.find(address.get_slice("#", 1)), address)
		else:
			assert_true(FileAccess.file_exists("res://" + address), address)
			if not address in files:
				files.append(address)
	assert_eq(files, RubricText.sources(), "what is copied beside the page")


func test_each_line_leads_to_its_lesson_its_exercises_and_its_tests() -> void:
	var articles := _page().split("<article>").slice(1)
	assert_eq(articles.size(), Rubric.lines().size())
	for i in articles.size():
		var line := Rubric.lines()[i]
		assert_eq(articles[i].contains('href="%s#%s"' % [_LAB, line.lesson]), line.lesson != "")
		for number in line.exercises:
			assert_string_contains(articles[i], ">Exercise %d: " % number)
		for path in line.tests:
			assert_string_contains(articles[i], 'href="%s">Test: ' % path)
		var is_own := line.proof == RubricLine.Proof.OWN_PROJECT
		assert_true(is_own or not line.tests.is_empty(), "what shows it: %s" % line.text)
		assert_eq(articles[i].contains("To be shown in your own project"), is_own)


func test_exercises_are_in_the_files_that_have_their_methods() -> void:
	for line in Rubric.lines():
		for number in line.exercises:
			for task in WorkshopIndex.exercise(number).tasks:
				var file: String = WorkshopFiles.CLASSES.find_key(task.home)
				assert_string_contains(WorkshopFiles.starter(file), "func %s(" % task.method)
				assert_has(RubricText.sources(), "workshop/starters/" + file)


func _page() -> String:
	return RubricText.page(_LAB, "%s")
