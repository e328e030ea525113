class_name Exercise
extends RefCounted
## One question with its right answer and the answers that known mistakes lead to.
##
## An exercise fills the fields; [method check] compares an answer with them. Texts are translated
## already.


## A wrong answer that stems from a known mistake.
class Mistake:
	extends RefCounted
	## The numbers that the mistake leads to.
	var answer: PackedFloat64Array
	## One sentence that names the mistake.
	var sentence: String


## What became of an answer.
class Verdict:
	extends RefCounted
	## The answer is right.
	var is_right: bool
	## One or two sentences to the student.
	var sentence: String


## Two numbers count as the same when they differ by less than this: answers are short decimals.
const TOLERANCE := 0.005
## A question whose mistakes cannot be told apart is drawn again, so often at most.
const MOST_DRAWS := 100

## The question, in one or two sentences.
var prompt := ""
## A name for each number asked for, such as `x of p`.
var answer_titles: PackedStringArray = []
## The right numbers, as many as [member answer_titles].
var right_answer: PackedFloat64Array = []
## Known mistakes; one whose answer is right by accident is never named.
var mistakes: Array[Mistake] = []


## The values of the lesson's state that show this question on its board, by their names there; see
## [method LessonModel.take]. Empty where the board cannot show it.
func board_state() -> Dictionary:
	return {}


## The right answer in one translated sentence with the numbers put in, such as
## `n̂x = −0.3162, n̂y = 0.9487`. An exercise may say it better.
func solution() -> String:
	var parts: PackedStringArray = []
	for i in answer_titles.size():
		parts.append("%s %s" % [answer_titles[i], NumberText.short(right_answer[i])])
	return ", ".join(parts)


## Adds a known mistake with the numbers that it leads to.
func add_mistake(answer: PackedFloat64Array, sentence: String) -> void:
	var mistake := Mistake.new()
	mistake.answer = answer
	mistake.sentence = sentence
	mistakes.append(mistake)


## The same where students give these numbers either as they are or all with the opposite sign.
func add_mistake_of_either_sign(answer: PackedFloat64Array, sentence: String) -> void:
	add_mistake(answer, sentence)
	var opposite: PackedFloat64Array = []
	for number: float in answer:
		opposite.append(-number)
	add_mistake(opposite, sentence)


## Right, a known mistake, or simply not right; [param answer] has as many numbers as were asked
## for.
func check(answer: PackedFloat64Array) -> Verdict:
	var verdict := Verdict.new()
	verdict.is_right = _same(answer, right_answer)
	verdict.sentence = _sentence_for(answer)
	return verdict


## Whether each wrong answer tells which mistake led to it: no two known mistakes have the same
## answer, and none has the right one. A mistake that can lead to several answers has one sentence
## for all of them; these may be the same.
func tells_mistakes_apart() -> bool:
	for i in mistakes.size():
		if _same(mistakes[i].answer, right_answer):
			return false
		for j in i:
			var is_another := mistakes[i].sentence != mistakes[j].sentence
			if is_another and _same(mistakes[i].answer, mistakes[j].answer):
				return false
	return true


## A question that [param fresh] makes of a kind with [param rng], drawn again until it
## [method tells_mistakes_apart]. After [constant MOST_DRAWS] draws the last one.
static func drawn(fresh: Callable, kind: int, rng: RandomNumberGenerator) -> Exercise:
	var exercise: Exercise = fresh.call(kind, rng)
	for i in MOST_DRAWS - 1:
		if exercise.tells_mistakes_apart():
			break
		exercise = fresh.call(kind, rng)
	return exercise


func _sentence_for(answer: PackedFloat64Array) -> String:
	if _same(answer, right_answer):
		return TranslationServer.translate("Right: %s.") % text_of(answer)
	for mistake in mistakes:
		if _same(answer, mistake.answer):
			return mistake.sentence
	var sentence := TranslationServer.translate("%s is not it yet. Go through the steps once more.")
	return sentence % text_of(answer)


## The numbers of an answer as they are written: `5`, or `(4, -3)` for two.
static func text_of(answer: PackedFloat64Array) -> String:
	if answer.size() == 2:
		return NumberText.pair(answer[0], answer[1])
	return NumberText.short(answer[0])


static func _same(one: PackedFloat64Array, other: PackedFloat64Array) -> bool:
	for i in one.size():
		if not absf(one[i] - other[i]) < TOLERANCE:
			return false
	return true
