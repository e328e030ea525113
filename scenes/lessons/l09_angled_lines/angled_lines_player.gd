class_name AngledLinesPlayer
extends Node
## The time of the lesson on angled lines: whole frames of 1/60 s, forward and back, whatever the
## length of the screen's own frames.

## The model has made a frame, or gone one back.
signal stepped(is_forward: bool)
## All frames that belong to one frame of the screen are made; or playing has begun or ended.
signal changed
## A frame of the screen has passed in which time stood still.
signal rested
## The meter has a new result.
signal measured
## A ball could not be moved to the end of the frame; the sentence says why.
signal refused(problem: String)

# At most this many frames are made at once: on a slow machine time runs slower.
const _MOST_AT_ONCE := 4

## Measures how much of a frame's time the script takes.
var meter := FrameMeter.new()

var _model: AngledLinesModel
var _transport: Transport
var _seconds := 0.0
var _was_playing := false


## Plays [param model] when [param transport] says so.
func play(model: AngledLinesModel, transport: Transport) -> void:
	_model = model
	_transport = transport
	transport.advanced.connect(_advance)


## Time runs by itself.
func is_playing() -> bool:
	return _transport.is_playing


## Makes the frames that are over [param seconds] after the start.
func fly_to(seconds: float) -> void:
	while (_model.world.frames + 0.999) * AngledLinesModel.FRAME <= seconds:
		_step(true)


## Time stands still from now on.
func pause() -> void:
	_transport.is_playing = false


## One frame on or back, and time stands still.
func step(is_forward: bool) -> void:
	pause()
	_step(is_forward)
	changed.emit()


func _process(_delta: float) -> void:
	# Before start() of the lesson.
	if not _transport:
		return
	if _was_playing != is_playing():
		_was_playing = is_playing()
		_seconds = 0.0
		changed.emit()
	if not is_playing():
		rested.emit()
	if meter.end_frame():
		measured.emit()


func _advance(seconds: float) -> void:
	if not is_playing():
		step(seconds > 0.0)
		return
	meter.start()
	_seconds = minf(_seconds + seconds, _MOST_AT_ONCE * AngledLinesModel.FRAME)
	# A hair less than a frame counts as one: the screen's frames are not exact.
	while _seconds > 0.999 * AngledLinesModel.FRAME:
		_seconds -= AngledLinesModel.FRAME
		_step(true)
	changed.emit()
	meter.stop()


func _step(is_forward: bool) -> void:
	if is_forward:
		_model.step()
		stepped.emit(true)
	elif _model.step_back():
		stepped.emit(false)
	if _model.refusal:
		refused.emit(_model.refusal)
