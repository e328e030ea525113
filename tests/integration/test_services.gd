extends ScreenTest
## What the services of the panel do for every lesson.

const _FOLDER := "res://scenes/widgets/services/"


## A question whose numbers the board can show.
class ShownExercise:
	extends Exercise

	func board_state() -> Dictionary:
		return {"a": 3.0}


## Questions of two kinds.
class TwoKinds:
	extends Exercise

	enum Kind { ONE, OTHER }

	static func fresh(kind: Kind, _rng: RandomNumberGenerator) -> Exercise:
		var exercise := Exercise.new()
		exercise.prompt = "kind %d" % kind
		return exercise


func test_steps_open_at_the_first_one() -> void:
	var steps := _added("steps") as Steps
	steps.tell(["one", "two", "three"])
	assert_eq(steps.step, 0)
	steps.go_to(1)
	steps.tell(["one", "two", "three", "four"])
	assert_eq(steps.step, 1, "new sentences keep the step")


func test_a_preset_is_picked_with_what_it_changes() -> void:
	var options := _added("options") as LessonOptions
	options.offer_presets({"Near": {"a": 1.0}, "Far": {"a": 9.0}})
	watch_signals(options)
	(options.get_node("%Presets").get_child(1) as Button).pressed.emit()
	assert_signal_emitted_with_parameters(options, "picked", [{"a": 9.0}])
	assert_signal_emit_count(options, "picked", 1)


func test_a_switch_is_picked_by_its_key_and_shows_the_state() -> void:
	var options := _added("options") as LessonOptions
	options.add_switch("is_on", "On")
	var button := options.get_node("%Switches").get_child(0) as CheckButton
	options.show_picked({"is_on": true, "other": 1.0})
	assert_true(button.button_pressed)
	watch_signals(options)
	button.button_pressed = false
	assert_signal_emitted_with_parameters(options, "picked", [{"is_on": false}])


func test_a_mistake_is_picked_by_its_number_and_shows_the_state() -> void:
	var mistakes := _added("mistakes") as Mistakes
	mistakes.add_all([MistakeInfo.new(9, "a title", "a sentence", "test_a.test_b")])
	var list := mistakes.get_node("%List") as OptionButton
	mistakes.show_picked({"mistake": 9})
	assert_eq(list.selected, 1)
	mistakes.show_picked({})
	assert_eq(list.selected, 1, "a state without a mistake says nothing")
	watch_signals(mistakes)
	list.item_selected.emit(0)
	assert_signal_emitted_with_parameters(mistakes, "picked", [{"mistake": 0}])


func test_a_mistake_is_told_with_what_its_test_checks_not_with_the_name_of_the_test() -> void:
	var mistakes := _added("mistakes") as Mistakes
	mistakes.add_all([MistakeInfo.new(9, "a title", "It is wrong.", "test_a.test_b", "It checks.")])
	mistakes.show_picked({"mistake": 9})
	var sentence := mistakes.get_node("%Sentence") as Label
	assert_eq(sentence.text, "It is wrong.\nIt checks.")


func test_a_question_is_shown_where_its_numbers_are_taken() -> void:
	var question := _added("question") as Question
	var shown := question.get_node("%Show") as Button
	_offer(question, ShownExercise.new())
	await student.settle()
	assert_false(shown.visible, "nobody takes them")
	question.picked.connect(func(_changes: Dictionary) -> void: pass)
	_offer(question, ShownExercise.new())
	await student.settle()
	assert_true(shown.visible)
	_offer(question, Exercise.new())
	await student.settle()
	assert_false(shown.visible, "an exercise without a state of the board")


func test_a_question_is_picked_with_the_state_that_shows_it() -> void:
	var question := _added("question") as Question
	_offer(question, ShownExercise.new())
	watch_signals(question)
	(question.get_node("%Show") as Button).pressed.emit()
	assert_signal_emitted_with_parameters(question, "picked", [{"a": 3.0}])


func test_the_questions_of_the_lecture_come_first_each_once() -> void:
	var question := _added("question") as Question
	var fresh := func(kind: int, _rng: RandomNumberGenerator) -> Exercise:
		return _named("fresh %d" % kind)
	var of_the_lecture := func(kind: int) -> Exercise:
		return _named("lecture %d" % kind) if kind != 1 else null
	question.offer(fresh, 3, 2, of_the_lecture)
	for wanted: String in ["lecture 2", "lecture 0", "fresh 2", "fresh 0", "fresh 1", "fresh 2"]:
		assert_eq((question.get_node("%Prompt") as Label).text, wanted)
		(question.get_node("%New") as Button).pressed.emit()


func test_the_kinds_of_a_class_of_exercises_take_turns() -> void:
	var question := _added("question") as Question
	question.offer_kinds(TwoKinds, 1, Callable())
	for wanted: String in ["kind 1", "kind 0", "kind 1"]:
		assert_eq((question.get_node("%Prompt") as Label).text, wanted)
		(question.get_node("%New") as Button).pressed.emit()


func test_the_solution_is_shown_to_who_asks_for_it_and_goes_with_its_question() -> void:
	var question := _added("question") as Question
	var exercise := _named("one")
	exercise.answer_titles = ["x ="]
	exercise.right_answer = [7.0]
	_offer(question, exercise)
	var solution := question.get_node("%Solution") as Label
	assert_false(solution.visible)
	(question.get_node("%ShowSolution") as Button).pressed.emit()
	assert_true(solution.visible)
	assert_eq(solution.text, "x = 7")
	assert_true(solution.is_in_group(FrameView.ANSWERS), "the key that hides answers hides it")
	assert_false((question.get_node("%Show") as Button).disabled)
	(question.get_node("%New") as Button).pressed.emit()
	assert_false(solution.visible)


func _named(prompt: String) -> Exercise:
	var exercise := Exercise.new()
	exercise.prompt = prompt
	return exercise


func _added(service: String) -> Control:
	var added := (load(_FOLDER + service + ".tscn") as PackedScene).instantiate() as Control
	add_child_autofree(added)
	return added


func _offer(question: Question, exercise: Exercise) -> void:
	question.offer(func(_kind: int, _rng: RandomNumberGenerator) -> Exercise: return exercise, 1)
