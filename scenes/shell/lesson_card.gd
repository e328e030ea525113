class_name LessonCard
extends ShelfCard
## A lesson on the start screen: picture, number, title, one line, and what has been done in it.

## The lesson that it opens.
var lesson: LessonInfo


## Shows what the index knows of [param its_lesson].
func show_lesson(its_lesson: LessonInfo) -> void:
	lesson = its_lesson
	_title.text = LessonIndex.heading_of(lesson)
	_summary.text = Conventions.in_unit(tr(lesson.summary))
	# A new lesson has none yet: ./lab pictures draws it.
	if ResourceLoader.exists(lesson.card_path()):
		(_picture as TextureRect).texture = load(lesson.card_path()) as Texture2D
	show_done(false)


## Shows what has been done in the lesson, or that the student can [param begin_here].
func show_done(begin_here: bool) -> void:
	var done: PackedStringArray = []
	if LessonsDone.has(LessonsDone.SEEN, lesson.id):
		done.append(tr("Seen"))
	if LessonsDone.has(LessonsDone.ANSWERED, lesson.id):
		done.append(tr("Question answered"))
	var words := done.duplicate()
	if begin_here:
		words.append(tr("Start here"))
	var told := "   ".join(PackedStringArray(Array(done).map(_checked)))
	if begin_here:
		told = ("→ %s   %s" % [tr("Start here"), told]).strip_edges()
	_tell_done(told, Palette.Role.PROJECTION if begin_here else Palette.Role.RIGHT)
	words.insert(0, _summary.text)
	words.insert(0, _title.text)
	accessibility_name = ". ".join(words)


static func _checked(words: String) -> String:
	return "✓ " + words
