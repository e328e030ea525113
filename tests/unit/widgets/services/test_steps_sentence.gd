extends LabTest
## Where the sentence of a step breaks into lines.


func test_a_sign_stays_with_both_sides() -> void:
	var kept := Steps.kept_together(
		"Put them in: what comes out is a · b̂. No angle is left in it."
	)
	assert_string_contains(kept, "a\u00a0·\u00a0b̂.")
	kept = Steps.kept_together(
		"A line has a direction: v = end − start. Drag its ends, or all of it."
	)
	assert_string_contains(kept, "direction: v\u00a0=\u00a0end\u00a0−\u00a0start. Drag")


func test_no_short_word_is_left_alone() -> void:
	var kept := Steps.kept_together("How far a reaches along b.")
	assert_eq(kept, "How far a reaches\u00a0along\u00a0b.")
	var long := "C is the coefficient of restitution."
	assert_eq(Steps.kept_together(long), long, "the last word is not short")


func test_no_word_is_lost_in_a_short_sentence() -> void:
	assert_eq(Steps.kept_together("It stays."), "It\u00a0stays.")
	assert_eq(Steps.kept_together(""), "")


func test_the_shown_sentence_is_kept_together() -> void:
	var steps := (
		(load("res://scenes/widgets/services/steps.tscn") as PackedScene).instantiate() as Steps
	)
	add_child_autofree(steps)
	steps.tell(["How far a reaches along b."])
	var shown := (steps.get_node("%Sentence") as Label).text
	assert_eq(shown, "How far a reaches\u00a0along\u00a0b.")
