class_name WorkshopCard
extends ShelfCard
## A card of the workshop on the start screen: title and line are in its scene.


## Shows [param words], translated, in place of the line of its scene.
func summarize(words: String) -> void:
	_summary.auto_translate_mode = AUTO_TRANSLATE_MODE_DISABLED
	_summary.text = words


## Shows how far the student is; [param is_reached]: something is.
func show_progress(words: String, is_reached: bool) -> void:
	var role := Palette.Role.RIGHT if is_reached else Palette.Role.QUIET
	_tell_done(("✓ " if is_reached else "") + words, role)
	accessibility_name = ". ".join([tr(_title.text), _summary.atr(_summary.text), words])
