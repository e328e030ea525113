extends LabTest
## The state of a lesson as a short text, and back.

const _BASE: Dictionary = {
	"on": true,
	"count": 3,
	"share": 0.5,
	"word": "one",
	"place": [7.0, 1.0],
	"lines": [[0.0, 0.0, 4.0, 3.0]],
}
const _REFUSED: Dictionary[String, String] = {
	"x=1": "There is no value “x” here. There are: on, count, share, word, place, lines.",
	"share": "“share” has no value: write share=… behind it.",
	"share=1&share=2": "“share” is there twice.",
	"on=maybe": "on must be true or false, not “maybe”.",
	"count=1.5": "count must be a whole number, not “1.5”.",
	"count=12345678901": "count must be a whole number, not “12345678901”.",
	"count=": "count must be a whole number, not “”.",
	"share=": "“” in share must be a number: 0, or from 1e-100 to 1e100 in size.",
	"share=half": "“half” in share must be a number: 0, or from 1e-100 to 1e100 in size.",
	"share=nan": "“nan” in share must be a number: 0, or from 1e-100 to 1e100 in size.",
	"share=1e999": "“1e999” in share must be a number: 0, or from 1e-100 to 1e100 in size.",
	"share=1,2,3": "“1,2,3” in share must be a number: 0, or from 1e-100 to 1e100 in size.",
	"place=1": "place must have 2 numbers, not 1: “1”.",
	"place=1,2,3": "place must have 2 numbers, not 3: “1,2,3”.",
	"lines=1,2,3,4;5": "lines must have 4 numbers, not 1: “5”.",
	"place=1,%s" % "999999999999999999999999999999x999":
	"“999999999999999999999999999999…” in place must be a number: 0, or from 1e-100 to 1e100 in size.",
}


func test_a_state_as_it_was_needs_no_text() -> void:
	assert_eq(LessonLink.text_of(_base(), _base()), "")
	assert_eq(LessonLink.read("", _base()).state, _base())


func test_only_what_differs_is_named() -> void:
	var state := _base()
	state["place"] = PackedFloat64Array([8.0, -6.0])
	assert_eq(LessonLink.text_of(state, _base()), "place=8,-6")
	state["on"] = false
	state["share"] = 0.25
	assert_eq(LessonLink.text_of(state, _base()), "on=false&share=0.25&place=8,-6")


func test_every_kind_of_value_comes_back() -> void:
	var state := _changed()
	var text := LessonLink.text_of(state, _base())
	var wanted := "on=false&count=-4&share=1e-7&word=two&place=-0,0.1&lines=1,2,3,4;5,6,7,8.5"
	assert_eq(text, wanted)
	var link := LessonLink.read(text, _base())
	assert_eq(link.problem, "")
	assert_eq(link.state, state)
	assert_eq(LessonLink.text_of(link.state, _base()), text)


func test_numbers_are_read_as_people_write_them() -> void:
	var link := LessonLink.read("count=+4&share=0,25&place=−1, +2.5", _base())
	assert_eq(link.problem, "")
	assert_eq(LessonLink.text_of(link.state, _base()), "count=4&share=0.25&place=-1,2.5")
	link = LessonLink.read("count=−4", _base())
	assert_eq(LessonLink.text_of(link.state, _base()), "count=-4")


func test_what_only_tracks_the_reader_is_passed_over() -> void:
	for tracker: String in [
		"fbclid=IwAR0x_-y",
		"gclid=1",
		"msclkid=1",
		"utm_source=mail",
		"utm_medium",
		"igshid=1",
		"mc_cid=1&mc_eid=2",
		"_hsenc=1",
		"ref=share",
		"sa=D&source=editors&ust=17&usg=AOv",
		"si=Ab_1",
		"mibextid=1",
		"__cft__[0]=AZ&__tn__=R",
		"gbraid=1&gad_source=1",
		"li_fat_id=1",
		"_ga=2.1&_gl=1",
	]:
		var link := LessonLink.read("count=4&%s&share=0.25" % tracker, _base())
		assert_eq(link.problem, "", tracker)
		assert_eq(LessonLink.text_of(link.state, _base()), "count=4&share=0.25", tracker)


func test_a_misspelt_name_is_no_tracker() -> void:
	for word: String in ["cuont", "utm", "clip", "shares", "grid", "id", "fbid", "_place", "ust_"]:
		var sentence := "There is no value “%s” here." % word
		assert_string_starts_with(LessonLink.read(word + "=1", _base()).problem, sentence)


func test_an_array_may_be_empty() -> void:
	var state := _base()
	state["lines"] = [] as Array[PackedFloat64Array]
	assert_eq(LessonLink.text_of(state, _base()), "lines=")
	assert_eq(LessonLink.read("lines=", _base()).state, state)


func test_a_text_needs_no_escape_in_an_address() -> void:
	var safe := RegEx.create_from_string("^[A-Za-z0-9_=&,;.-]*$")
	assert_not_null(safe.search(LessonLink.text_of(_changed(), _base())))


func test_what_cannot_be_read_is_named_with_what_is_allowed() -> void:
	for text: String in _REFUSED:
		assert_eq(LessonLink.read(text, _base()).problem, _REFUSED[text], text)


func test_a_long_text_is_not_read() -> void:
	var text := "word=" + "a".repeat(LessonLink.LONGEST)
	var sentence := "The link has 16005 characters; there may be at most 16000."
	assert_eq(LessonLink.read(text, _base()).problem, sentence)


func test_an_array_has_at_most_a_hundred_lists() -> void:
	var text := "lines=" + ";".join(PackedStringArray(range(101).map(str)))
	var sentence := "lines has 101 parts; there may be at most 100."
	assert_eq(LessonLink.read(text, _base()).problem, sentence)


func test_reading_does_not_change_the_base() -> void:
	var base := _base()
	LessonLink.read("place=1,2&lines=1,2,3,4", base)
	assert_eq(base, _base())


func test_a_value_out_of_its_range_is_named_with_the_range() -> void:
	assert_eq(StateCheck.within("C", 1.0, 0.0, 1.0), "")
	assert_eq(StateCheck.within("C", 1.5, 0.0, 1.0), "C must be within 0..1, not 1.5.")
	assert_eq(StateCheck.within("C", NAN, 0.0, 1.0), "C must be within 0..1, not NaN.")
	assert_eq(StateCheck.word("w", "a", ["a", "b"]), "")
	assert_eq(StateCheck.word("w", "c", ["a", "b"]), "w must be one of a, b, not “c”.")
	assert_eq(StateCheck.mistake(0, []), "")
	assert_eq(StateCheck.mistake(5, []), "mistake must be one of 0, not “5”.")
	assert_eq(StateCheck.first(["", "one", "two"]), "one")


func _base() -> Dictionary:
	var base := _BASE.duplicate(true)
	var numbers: Array = base["place"]
	base["place"] = PackedFloat64Array(numbers)
	base["lines"] = [PackedFloat64Array([0, 0, 4, 3])] as Array[PackedFloat64Array]
	return base


func _changed() -> Dictionary:
	return {
		"on": false,
		"count": -4,
		"share": 1e-7,
		"word": "two",
		"place": PackedFloat64Array([negative_zero(), 0.1]),
		"lines":
		(
			[PackedFloat64Array([1, 2, 3, 4]), PackedFloat64Array([5, 6, 7, 8.5])]
			as Array[PackedFloat64Array]
		),
	}
