@tool
class_name OwnAnswer
extends OwnDrawing
## What the student's own code answers for the numbers on the board, beside the lab's own. It asks
## the watcher and waits for nothing: until an answer has come, the one before it is faint.

var _picture: OwnPicture
var _state: Dictionary = {}
# By the methods: the questions for the board as it is now, and what is drawn.
var _questions: Dictionary[String, OwnQuestion] = {}
var _shown: Dictionary[String, OwnQuestion] = {}
# What is not answered yet: one question of each method at a time, because a worker that hangs reads
# none, and would keep the lab waiting once its pipe is full.
var _asked: Dictionary[String, OwnQuestion] = {}


## For the board of [param lesson], as [param picture] has it, from what [param watcher] hears.
func _init(lesson: Lesson, picture: OwnPicture, watcher: WorkshopWatcher) -> void:
	super(lesson, watcher)
	_picture = picture
	watcher.began.connect(_grow_old)
	watcher.judged.connect(_follow_verdict)
	watcher.answered.connect(_take)


func _process(seconds: float) -> void:
	super(seconds)
	if _lesson.link_state() != _state:
		_look_at_board()


## What is drawn of the answer of [param method]; null for nothing.
func shown(method: String) -> OwnQuestion:
	return _shown.get(method)


## Whether what is drawn of [param method] is the answer of this file to this board.
func is_current(method: String) -> bool:
	return _shown.has(method) and _shown[method] == _questions.get(method)


func _look_at_board() -> void:
	_state = _lesson.link_state()
	_questions.clear()
	for question in _picture.questions(_state):
		_questions[question.method] = question
		var before := shown(question.method)
		if before and question.is_answered_by(before):
			question.take(before.answer)
			_shown[question.method] = question
	for method: String in _shown.keys():
		if not _questions.has(method):
			_shown.erase(method)
	_ask()
	queue_redraw()


# Another file is there: what was answered before says nothing of it.
func _grow_old() -> void:
	for method in _shown:
		_shown[method].is_old = true
	_look_at_board()


# What was asked of a child that has ended is lost.
func _follow_verdict(report: WorkshopReport) -> void:
	_asked.clear()
	for method: String in _shown.keys():
		if report.is_complete and not report.can_ask(method):
			_shown.erase(method)
	_ask()
	queue_redraw()


func _ask() -> void:
	if not _watcher.report or not _watcher.report.is_complete:
		return
	for method in _questions:
		var question := _questions[method]
		if not question.is_answered and not _asked.has(method) and _watcher.report.can_ask(method):
			_asked[method] = question
			question.number = _watcher.ask(method, question.numbers)


func _take(number: int, numbers: PackedFloat64Array) -> void:
	for method: String in _asked.keys():
		if _asked[method].number == number:
			_asked[method].take(numbers)
			_shown[method] = _asked[method]
			_asked.erase(method)
			# A child that was ended answers nothing; what else was asked of it is lost.
			if numbers.is_empty():
				_asked.clear()
			_ask()
			queue_redraw()
			return


func _draw() -> void:
	var places := OwnPlaces.new(board)
	for method in _shown:
		var mark := _shown[method].mark()
		if mark:
			draw_mark(mark, ink(not is_current(method)))
	for method in _shown:
		var mark := _shown[method].mark()
		if mark:
			var sign_text := "✓" if _shown[method].is_right() else "✗"
			var color := ink(not is_current(method))
			write(_shown[method].words(), sign_text, mark, places, color)
