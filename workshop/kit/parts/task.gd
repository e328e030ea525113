class_name WorkshopTask
extends RefCounted
## One method that the student writes: how it is called, on what it is tried, the ways in which it
## goes wrong.

## The method's name.
var method: String
## The class that it belongs to; one of [constant WorkshopFiles.CLASSES].
var home: String
## What it takes, a letter each: `v` a vector, `f` a number, `B` a ball, `L` any number of lines,
## behind which only numbers may come. A method of MyVec2 begins with the vector itself.
var takes: String
## What comes out: `v` a vector, `f` a number, `b` yes or no, `s` the changed vector itself, `B` the
## changed ball.
var gives: String
## The class and the method of the lab's own that answer right. For a method of MyVec2 the class is
## that of all vectors in the call.
var reference_home: GDScript
## See [member reference_home].
var reference_method: String
## The mistake that is named where the method changes what it must leave alone.
var spoiling_number := 8
## The sentence for that, translated.
var spoiling_sentence: String
## On what it is tried.
var probes: Array[WorkshopProbe] = []
## How it goes wrong.
var ways: Array[WorkshopWay] = []


## A method of the class [param its_home], such as `MyVec2`.
func _init(its_home: String, its_method: String, it_takes: String, it_gives: String) -> void:
	home = its_home
	method = its_method
	takes = it_takes
	gives = it_gives
	spoiling_sentence = LabText.translate("%s changes what it was given: it must stay as it was.")
	spoiling_sentence = spoiling_sentence % method


## Says by which method of the lab's own the right answers are found.
func by(its_home: GDScript, its_method: String) -> void:
	reference_home = its_home
	reference_method = its_method


## Adds a call with these numbers.
func probe(title: String, numbers: Array[float]) -> WorkshopProbe:
	var added := WorkshopProbe.new(title, numbers)
	probes.append(added)
	return added


## Adds a wrong way.
func way(number: int, sentence: String, answer: Callable) -> WorkshopWay:
	var added := WorkshopWay.new(number, sentence, answer)
	ways.append(added)
	return added


## Adds the way that is right but for what it spoils.
func add_spoiling_way() -> void:
	way(spoiling_number, spoiling_sentence, Callable()).spoiling()


## Whether the method belongs to the vector.
func is_of_vector() -> bool:
	return home == "MyVec2"


## Whether the method changes its first input and gives nothing back.
func is_in_place() -> bool:
	return gives == "s" or gives == "B"


## The parameters, a letter each, without the vector itself.
func parameters() -> String:
	return takes.substr(1) if is_of_vector() else takes
