class_name LessonCard
extends Button
## A lesson on the start screen: picture, number, title and one line.


## Shows what the index knows of [param lesson].
func show_lesson(lesson: LessonInfo) -> void:
	(%Title as Label).text = "%d  %s" % [LessonIndex.number_of(lesson), tr(lesson.title)]
	(%Summary as Label).text = lesson.summary
	(%Picture as TextureRect).texture = load(lesson.card_path()) as Texture2D
	accessibility_name = "%s. %s" % [(%Title as Label).text, tr(lesson.summary)]
