class_name EasyBounceVerdict
extends VerdictCard
## Says whether the shown step of the easy program is right for the ball as it is, and how far
## off it is. It comes with the first step that can be wrong.

# A difference of velocities of at most this share of the velocity is rounding.
const _ROUNDING := 1e-14

var _model: EasyBounceModel
var _moved: Ball


## Shows the words for the ball [param moved] of [param model] at [param step] of
## [EasyBounceTexts].
func show_model(model: EasyBounceModel, moved: Ball, step: int) -> void:
	_model = model
	_moved = moved
	visible = step != EasyBounceTexts.Step.MOVE
	match step:
		EasyBounceTexts.Step.DETECT:
			_judge_distance()
		EasyBounceTexts.Step.PUT_BACK:
			_judge_place()
		EasyBounceTexts.Step.FLIP:
			_judge_velocity()
		EasyBounceTexts.Step.BOUNCE:
			_judge_bounce()
	_keep_from_line()


# Moves to the corner into which neither the line nor the balls reach.
func _keep_from_line() -> void:
	var corner := Control.PRESET_BOTTOM_RIGHT
	if _model.is_wall and _model.tilt_degrees < 0.0:
		corner = Control.PRESET_TOP_RIGHT
	elif not _model.is_wall and _model.tilt_degrees > 0.0:
		corner = Control.PRESET_BOTTOM_LEFT
	stand_in(corner)


func _judge_distance() -> void:
	var error := absf(_model.distance_error(_moved))
	if _model.is_level():
		_say_right(tr("straight is the shortest way"))
	elif _model.is_rounding(error, _moved):
		_say("=", [tr("Here both distances"), tr("are the same")])
	elif _model.right_detects(_moved) and not _model.easy_detects(_moved):
		_say_wrong(_missed(), tr("its distance is %s px too long"), error)
	else:
		_say_wrong(tr("Straight is not shortest:"), tr("%s px too far"), error)


func _judge_place() -> void:
	var error := _model.position_error(_moved)
	if not _model.right_detects(_moved):
		_say("0", [tr("No hit:"), tr("nothing to put back")])
	elif _model.is_level():
		_say_right(tr("straight is along the normal"))
	elif _model.is_rounding(error, _moved):
		_say("=", [tr("Here both places"), tr("are the same")])
	elif not _model.easy_detects(_moved):
		_say_wrong(_missed(), tr("the ball stays %s px deep"), _model.depth(_moved))
	else:
		_say_wrong_place(error)


func _say_wrong_place(error: float) -> void:
	var first := tr("Put back %s px off") % NumberText.short(error, 3)
	var depth := _model.depth(_model.easy_result(_moved))
	if _model.is_rounding(depth, _moved):
		_say("✗", [first], Palette.Role.WRONG)
	else:
		_say_wrong(first, tr("and still %s px deep"), depth)


func _judge_velocity() -> void:
	var error := _model.velocity_error(_moved)
	if not _model.right_detects(_moved):
		_say("0", [tr("No hit:"), tr("v stays")])
	elif not _model.right_reflects(_moved) and not _model.easy_flips(_moved):
		_say("0", [tr("v stays:"), tr("it does not point into the line")])
	elif _model.is_level():
		_say_right(
			tr("only the sign of x changes") if _model.is_wall else tr("only the sign of y changes")
		)
	elif error <= _ROUNDING * _moved.velocity.length():
		_say("=", [tr("Here flipped and reflected"), tr("are the same")])
	else:
		_say_wrong(_wrong_flip(), tr("%s px per frame off"), error)


# Why the velocity is wrong, where exactly one program changes it, or both do.
func _wrong_flip() -> String:
	if not _model.easy_detects(_moved):
		return _missed()
	if not _model.easy_flips(_moved):
		return tr("v points into the line, yet it stays:")
	if not _model.right_reflects(_moved):
		return tr("v does not point into the line, yet it flips:")
	return tr("Flipped is not reflected:")


func _judge_bounce() -> void:
	var apart := _model.distance_apart(_model.frame())
	var in_frame := tr("Frame %s:") % NumberText.short(_model.frame())
	if _model.is_level():
		_say("✓", [tr("The easy way is right"), tr("in all three steps")], Palette.Role.RIGHT)
	elif _model.is_rounding(apart, _moved):
		_say("=", [in_frame, tr("both balls are in one place")])
	else:
		_say_wrong(in_frame, tr("the easy ball is %s px off"), apart)


func _missed() -> String:
	return tr("The easy way misses the hit:")


func _say_right(why: String) -> void:
	var where := tr("Right on an upright line:") if _model.is_wall else tr("Right on a level line:")
	_say("✓", [where, why], Palette.Role.RIGHT)


func _say_wrong(first: String, second: String, number: float) -> void:
	_say("✗", [first, second % NumberText.short(number, 3)], Palette.Role.WRONG)


func _say(
	sign_text: String, words: PackedStringArray, role: Palette.Role = Palette.Role.QUIET
) -> void:
	show_verdict(sign_text, role, words)
