class_name StateCheck
extends RefCounted
## What can be wrong with a value of a stored state that came from outside, such as in a link: each
## method returns "" or one sentence with the value and what is allowed, translated.


## The first of [param problems] that is one; "" where none is.
static func first(problems: PackedStringArray) -> String:
	for problem in problems:
		if problem:
			return problem
	return ""


## Whether [param value] is a number from [param least] to [param most].
static func within(name: String, value: float, least: float, most: float) -> String:
	if value >= least and value <= most:
		return ""
	var sentence := TranslationServer.translate("%s must be within %s..%s, not %s.")
	var numbers := [least, most, value].map(NumberText.short)
	return sentence % [name, numbers[0], numbers[1], numbers[2]]


## Whether [param value] is one of [param words].
static func word(name: String, value: String, words: PackedStringArray) -> String:
	if value in words:
		return ""
	var sentence := TranslationServer.translate("%s must be one of %s, not “%s”.")
	return sentence % [name, ", ".join(words), LessonLink.quoted(value)]


## Whether [param number] is 0 or that of a mistake that can be switched on.
static func mistake(number: int, mistakes: Array[MistakeInfo]) -> String:
	var numbers: PackedStringArray = ["0"]
	for info in mistakes:
		numbers.append(str(info.number))
	return word("mistake", str(number), numbers)
