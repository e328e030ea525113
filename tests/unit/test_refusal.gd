extends LabTest
## A refusal that nobody can act on is reported as an error.


func test_a_sentence_is_pushed_as_an_error() -> void:
	Refusal.push(Surroundings.new().set_bounciness(2.0))
	assert_push_error("The bounciness C must be within 0..1, not 2.0.")


func test_no_refusal_is_no_error() -> void:
	Refusal.push(Surroundings.new().set_bounciness(0.5))
	assert_push_error_count(0)
