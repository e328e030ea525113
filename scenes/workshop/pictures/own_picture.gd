@abstract class_name OwnPicture
extends RefCounted
## What the board of one lesson asks of the student's methods, and what is drawn of the answers.

## The board in the lesson's scene on which it is drawn.
var board_path := ^"%Board"

## The questions for [param state], a link state of the lesson.
@abstract func questions(state: Dictionary) -> Array[OwnQuestion]


## A vector as plain numbers.
static func pair(of: Vec2) -> PackedFloat64Array:
	return [of.x, of.y]


## The first two numbers of an answer as a vector.
static func vector(answer: PackedFloat64Array) -> Vec2:
	return Vec2.new(answer[0], answer[1])


## Says of an answer that is a time and not finite what that means; "" for a time.
static func no_impact(answer: PackedFloat64Array) -> String:
	return LabText.translate("no impact") if is_inf(answer[0]) else ""


## Says of an answer about a shot that there is none: a time that is not finite, or the direction
## (0, 0); "" for a shot.
static func no_shot(answer: PackedFloat64Array) -> String:
	var is_none := is_inf(answer[0])
	if answer.size() == 2:
		is_none = vector(answer).length() == 0.0
	return LabText.translate("no shot hits") if is_none else ""
