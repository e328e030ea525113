extends LabTest
## Where a lesson's files lie: beside its `lesson.tres`.


func test_scene_and_card_lie_in_the_lessons_folder() -> void:
	var lesson := load("res://tests/support/lessons/clock.tres") as LessonInfo
	assert_eq(lesson.scene_path(), "res://tests/support/lessons/clock.tscn")
	assert_eq(lesson.card_path(), "res://tests/support/lessons/card.png")
