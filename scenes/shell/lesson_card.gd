class_name LessonCard
extends Button
## A lesson on the start screen: picture, number, title and one line.

const _LOWEST := 336.0

@onready var _margin: MarginContainer = $Margin


func _ready() -> void:
	_margin.minimum_size_changed.connect(_fit, CONNECT_DEFERRED)


## Shows what the index knows of [param lesson].
func show_lesson(lesson: LessonInfo) -> void:
	(%Title as Label).text = "%d  %s" % [LessonIndex.number_of(lesson), tr(lesson.title)]
	(%Summary as Label).text = lesson.summary
	# A new lesson has none yet: ./lab pictures draws it.
	if ResourceLoader.exists(lesson.card_path()):
		(%Picture as TextureRect).texture = load(lesson.card_path()) as Texture2D
	accessibility_name = "%s. %s" % [(%Title as Label).text, tr(lesson.summary)]


# A button does not grow by itself with what lies in it.
func _fit() -> void:
	custom_minimum_size.y = maxf(_LOWEST, _margin.get_combined_minimum_size().y)
