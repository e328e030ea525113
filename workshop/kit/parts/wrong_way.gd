class_name WorkshopWay
extends RefCounted
## A way in which students write a method wrongly. It names the mistake where the student's answers
## are those of this way, and it breaks his tests where it takes the place of the right method.

## The mistake's number in the course's list; 0 for one that is not in it.
var number: int
## One sentence to the student that names the mistake, translated.
var sentence: String
## What this way answers to the numbers of a probe. Empty for one that spoils its inputs.
var answer: Callable
## Whether it is about special probes, such as the zero vector. Others are compared on ordinary
## probes only, because a guard against zero can stand beside any mistake.
var is_about_special := false
## Whether it differs from the right way on probes for the mark "excellent" only.
var is_extra := false
## Whether it changes what it must leave alone, see [WorkshopChameleon]. Such a way answers right
## otherwise.
var spoils_inputs := false
## Whether his tests have to find it. Off for a second form of another way.
var is_in_tests := true


## A way with what it answers, and how the student is told.
func _init(its_number: int, its_sentence: String, its_answer: Callable) -> void:
	number = its_number
	sentence = its_sentence
	answer = its_answer


## The same way, about special probes.
func about_special() -> WorkshopWay:
	is_about_special = true
	return self


## The same way, seen on probes for the mark "excellent" only.
func extra() -> WorkshopWay:
	is_extra = true
	is_in_tests = false
	return self


## The same way, as one that spoils its inputs.
func spoiling() -> WorkshopWay:
	spoils_inputs = true
	return self


## The same way, as a second form of another one.
func only_named() -> WorkshopWay:
	is_in_tests = false
	return self
