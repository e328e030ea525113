class_name WordWidth
extends RefCounted
## How wide texts are in a label, and what keeps its words in one piece where they wrap. All widths
## are in pixels.


## How wide [param text] is in one line of [param label].
static func of_text(label: Label, text: String) -> float:
	var font := label.get_theme_font(&"font")
	var font_size := label.get_theme_font_size(&"font_size")
	return font.get_string_size(text, HORIZONTAL_ALIGNMENT_LEFT, -1, font_size).x


## How wide the longest word of [param label] is.
static func of_longest(label: Label) -> float:
	var widest := 0.0
	for word in label.text.split(" "):
		widest = maxf(widest, ceilf(of_text(label, word)))
	return widest


## Lets [param label] wrap between its words, and gives it the width of the longest of them.
static func keep_whole(label: Label) -> void:
	label.autowrap_mode = TextServer.AUTOWRAP_WORD
	label.custom_minimum_size.x = of_longest(label)
