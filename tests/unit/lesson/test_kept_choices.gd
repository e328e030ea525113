extends LabTest
## What is chosen for the whole lab is there the next time.

const _FILE := "user://kept_choices_in_test.cfg"

var _file_before := ""


func before_each() -> void:
	_file_before = KeptChoices.file
	KeptChoices.file = _FILE
	KeptChoices.read_again()


func after_each() -> void:
	DirAccess.remove_absolute(_FILE)
	KeptChoices.file = _file_before
	KeptChoices.read_again()


func test_a_choice_is_there_the_next_time() -> void:
	assert_eq(_language(), "en")
	KeptChoices.keep("language", "nl")
	KeptChoices.read_again()
	assert_eq(_language(), "nl")


func test_a_choice_can_be_forgotten() -> void:
	KeptChoices.keep("language", "nl")
	KeptChoices.forget("language")
	KeptChoices.forget("never_chosen")
	KeptChoices.read_again()
	assert_eq(_language(), "en")


func test_a_file_that_cannot_be_read_is_as_none() -> void:
	FileAccess.open(_FILE, FileAccess.WRITE).store_string("not [a file = of choices")
	KeptChoices.read_again()
	assert_eq(_language(), "en")
	assert_engine_error("parse error")


func _language() -> String:
	return KeptChoices.value("language", "en")
