class_name CodeField
extends CodeEdit
## The field in which a student writes code: keywords in colors, numbers before the lines, the line
## that is meant by a verdict marked. Tab indents; Esc leaves the field, so that the keyboard is
## not caught in it.

## The student wants to know whether it is right: Ctrl+Enter, or Ctrl+S as in an editor.
signal check_wanted

const _KEYWORDS := (
	"if elif else for while match when break continue pass return func static var const class "
	+ "extends in is as and or not self super void int float bool String Array true false null "
	+ "PI TAU INF NAN"
)
const _MARK_OPACITY := 0.16


func _ready() -> void:
	syntax_highlighter = CodeHighlighter.new()
	for pair: String in ["()", "[]", "{}", '""']:
		if not has_auto_brace_completion_open_key(pair[0]):
			add_auto_brace_completion_pair(pair[0], pair[1])
	for opener: String in [":", "(", "[", "{"]:
		if not opener in indent_automatic_prefixes:
			indent_automatic_prefixes.append(opener)
	add_comment_delimiter("#", "", true)
	text_changed.connect(unmark)
	focus_entered.connect(WebPage.follow_pasting.bind(_take_in))
	focus_exited.connect(WebPage.follow_pasting.bind(Callable()))
	paint()


func _gui_input(event: InputEvent) -> void:
	var key := event as InputEventKey
	if not key or not key.pressed or key.echo:
		return
	var is_wanted := key.keycode in [KEY_S, KEY_ENTER, KEY_KP_ENTER]
	if is_wanted and key.is_command_or_control_pressed():
		check_wanted.emit()
		accept_event()
	elif key.keycode == KEY_ESCAPE:
		find_next_valid_focus().grab_focus()
		accept_event()


# What is marked is replaced, in one step that can be undone.
func _take_in(content: String) -> void:
	begin_complex_operation()
	insert_text_at_caret(content.replace("\r\n", "\n"))
	end_complex_operation()


## Takes the colors of the palette as they are now.
func paint() -> void:
	var ink := Palette.color(Palette.Role.INK)
	var quiet := Palette.color(Palette.Role.QUIET)
	for style: StringName in [&"normal", &"focus"]:
		add_theme_stylebox_override(style, get_theme_stylebox(style, &"LineEdit"))
	for part: StringName in [&"font_color", &"caret_color"]:
		add_theme_color_override(part, ink)
	add_theme_color_override(&"line_number_color", quiet)
	add_theme_color_override(&"brace_mismatch_color", Palette.color(Palette.Role.WRONG))
	add_theme_color_override(&"selection_color", Color(Palette.drawn(Palette.FOCUS), 0.25))
	var highlighter := syntax_highlighter as CodeHighlighter
	highlighter.number_color = Palette.color(Palette.Role.PROJECTION)
	highlighter.symbol_color = ink
	highlighter.function_color = ink
	highlighter.member_variable_color = ink
	highlighter.clear_keyword_colors()
	for word in _KEYWORDS.split(" "):
		highlighter.add_keyword_color(word, Palette.color(Palette.Role.B))
	highlighter.clear_color_regions()
	highlighter.add_color_region("#", "", quiet, true)
	highlighter.add_color_region('"', '"', Palette.color(Palette.Role.A))


## Shows [param content], of which nothing can be undone.
func begin(content: String) -> void:
	text = content
	clear_undo_history()
	set_caret_line(first_line_to_write())
	set_caret_column(text.get_slice("\n", get_caret_line()).length())


## The line, from 0, in which the first body begins.
func first_line_to_write() -> int:
	var lines := text.split("\n")
	for at in lines.size():
		if lines[at].begins_with("\t") and lines[at].strip_edges():
			return at
	return 0


## Writes [param content] over all that is there, in one step that can be undone.
func replace_all(content: String) -> void:
	begin_complex_operation()
	select_all()
	insert_text_at_caret(content)
	end_complex_operation()
	set_caret_line(first_line_to_write())


## Marks a line, from 1, and brings it into view; no line for 0.
func mark(line: int) -> void:
	unmark()
	if line > 0 and line <= get_line_count():
		var color := Color(Palette.color(Palette.Role.WRONG), _MARK_OPACITY)
		set_line_background_color(line - 1, color)
		set_line_as_center_visible(line - 1)


## Marks no line any more.
func unmark() -> void:
	for line in get_line_count():
		set_line_background_color(line, Color.TRANSPARENT)
