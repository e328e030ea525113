extends LabTest
## What every lesson's model does with a change of a part of its state.


class TwoNumbers:
	extends LessonModel
	var first := 1.0
	var second := 2.0

	func to_dictionary() -> Dictionary:
		return {"first": first, "second": second}

	func from_dictionary(stored: Dictionary) -> void:
		first = stored["first"]
		second = stored["second"]

	func problem_in(stored: Dictionary) -> String:
		var wanted: float = stored["first"]
		return "" if wanted < 10.0 else "first must be below 10"


class WithMistake:
	extends TwoNumbers
	var mistake := 0

	func to_dictionary() -> Dictionary:
		return {"first": first, "second": second, "mistake": mistake}

	func from_dictionary(stored: Dictionary) -> void:
		super(stored)
		mistake = stored["mistake"]

	func show_mistake(number: int) -> void:
		second = 10.0 * number


func test_what_a_change_does_not_name_stays() -> void:
	var model := TwoNumbers.new()
	assert_eq(model.take({"first": 5.0}), "")
	assert_eq(model.to_dictionary(), {"first": 5.0, "second": 2.0})


func test_a_change_that_is_refused_changes_nothing() -> void:
	var model := TwoNumbers.new()
	assert_eq(model.take({"first": 50.0, "second": 7.0}), "first must be below 10")
	assert_eq(model.to_dictionary(), {"first": 1.0, "second": 2.0})


func test_a_mistake_that_is_taken_is_shown_and_one_that_is_refused_is_not() -> void:
	var model := WithMistake.new()
	assert_eq(model.take({"first": 3.0}), "")
	assert_eq(model.second, 2.0, "no mistake was named")
	assert_eq(model.take({"mistake": 4}), "")
	assert_eq(model.second, 40.0)
	assert_ne(model.take({"mistake": 5, "first": 50.0}), "")
	assert_eq(model.second, 40.0)
