class_name StabilityMark
extends Control
## The outcome of a case, by sign and colour: a tick, a cross, an empty ring before it is tried, a
## dash if it is left out.

## What a case can come to.
enum Outcome { WAITING, PASSED, FAILED, LEFT_OUT }

const _RADIUS := 15.0

## The outcome that is shown.
var outcome := Outcome.WAITING:
	set(value):
		outcome = value
		accessibility_name = _words(value)
		queue_redraw()


func _init() -> void:
	custom_minimum_size = Vector2(_RADIUS, _RADIUS) * 2.4
	mouse_filter = Control.MOUSE_FILTER_PASS


static func _words(of: Outcome) -> String:
	match of:
		Outcome.PASSED:
			return LabText.translate("holds")
		Outcome.FAILED:
			return LabText.translate("does not hold")
		Outcome.LEFT_OUT:
			return LabText.translate("not tried here")
	return LabText.translate("not tried yet")


func _draw() -> void:
	var middle := size / 2.0
	match outcome:
		Outcome.WAITING:
			draw_circle(middle, _RADIUS - 4.0, Palette.drawn(Palette.BORDER), false, 2.0, true)
		Outcome.PASSED:
			draw_circle(middle, _RADIUS, Palette.color(Palette.Role.RIGHT), true, -1.0, true)
			_draw_stroke(middle, Vector2(-7.0, 0.0), Vector2(-2.0, 6.0))
			_draw_stroke(middle, Vector2(-2.0, 6.0), Vector2(7.0, -6.0))
		Outcome.FAILED:
			draw_circle(middle, _RADIUS, Palette.color(Palette.Role.WRONG), true, -1.0, true)
			_draw_stroke(middle, Vector2(-6.0, -6.0), Vector2(6.0, 6.0))
			_draw_stroke(middle, Vector2(-6.0, 6.0), Vector2(6.0, -6.0))
		Outcome.LEFT_OUT:
			var half := Vector2(8.0, 0.0)
			draw_line(middle - half, middle + half, Palette.drawn(Palette.BORDER), 3.0)


func _draw_stroke(middle: Vector2, from: Vector2, to: Vector2) -> void:
	draw_line(middle + from, middle + to, Palette.drawn(Palette.PAPER), 3.5, true)
