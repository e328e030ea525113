class_name OwnQuestion
extends RefCounted
## One of the student's methods, asked for the numbers that lie on the board, and what is drawn of
## its answer.

## The method, such as `dot`.
var method: String
## What is handed over, in the order of [member WorkshopTask.takes].
var numbers: PackedFloat64Array
## What the answer is called on the board, such as `a·b`.
var symbol: String
## Where words stand that have no shape, as for an answer that is not finite.
var place: Vec2
## Makes an [OwnMark] of a finite answer, a PackedFloat64Array.
var shape: Callable
## Words for an answer that has none as a number, from a PackedFloat64Array; "" for the number.
var words_of := Callable()
## Its number at the watcher, from 1; 0 before it was asked.
var number := 0
## The answer; empty where the method gives none.
var answer: PackedFloat64Array = []
## Whether the answer has come.
var is_answered := false
## Whether another file has been saved since it was answered.
var is_old := false

var _is_right := false


## A question without its answer yet.
func _init(
	its_method: String,
	its_numbers: PackedFloat64Array,
	its_symbol: String,
	its_place: Vec2,
	its_shape: Callable
) -> void:
	method = its_method
	numbers = its_numbers
	symbol = its_symbol
	place = its_place
	shape = its_shape


## The same question, whose answer is told by [param its_words]; see [member words_of].
func told_by(its_words: Callable) -> OwnQuestion:
	words_of = its_words
	return self


## Takes the student's answer, and finds out whether it is right.
func take(its_answer: PackedFloat64Array) -> void:
	answer = its_answer
	is_answered = true
	var right := WorkshopCall.of_lab(WorkshopIndex.task(method)).run(numbers).numbers
	_is_right = WorkshopProbe.new(symbol, []).agrees(answer, right)


## Whether the answer is the lab's own.
func is_right() -> bool:
	return _is_right


## Whether the answer of [param other] is the answer to this question, too.
func is_answered_by(other: OwnQuestion) -> bool:
	return other.is_answered and not other.is_old and other.numbers == numbers


## What is drawn of the answer; null where there is none.
func mark() -> OwnMark:
	if not is_answered or answer.is_empty():
		return null
	for part in answer:
		if not is_finite(part):
			return OwnMark.note(place)
	return shape.call(answer)


## What is written beside it, such as `yours: a·b = 50`, translated.
func words() -> String:
	var told: String = words_of.call(answer) if words_of else ""
	if not told:
		told = "%s = %s" % [symbol, WorkshopVerdict.text_of(answer)]
	return LabText.translate("yours: %s") % told
