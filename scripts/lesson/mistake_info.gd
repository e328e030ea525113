class_name MistakeInfo
extends RefCounted
## A mistake found in real student code, which a lesson can switch on beside the right way.

## The first number of mistakes that are not in the course's list: they are shown without a number.
const BEYOND_THE_COURSE := 101

## Its number in the course's list of mistakes; for one that only the lecture names, minus the part
## of the lecture; for any other one [constant BEYOND_THE_COURSE] or more.
var number: int
## A few words for the list that one picks from, translated.
var title: String
## One or two sentences that name the mistake and what it does, translated.
var sentence: String
## The test that catches it, for people who read the code: `<test script>.<test method>`, without
## folder and ending.
var test: String
## What this test checks, in words that a student understands: one translated sentence.
var checks := ""


## A mistake with all that a lesson shows of it.
func _init(
	its_number: int,
	its_title: String,
	its_sentence: String,
	its_test: String,
	its_checks: String = ""
) -> void:
	number = its_number
	title = its_title
	sentence = its_sentence
	test = its_test
	checks = its_checks


## What the list that one picks from shows: number and title, translated.
func heading() -> String:
	if number >= BEYOND_THE_COURSE:
		return title.left(1).to_upper() + title.substr(1)
	if number < 0:
		return TranslationServer.translate("Part %d: %s") % [-number, title]
	return TranslationServer.translate("Mistake %d: %s") % [number, title]
