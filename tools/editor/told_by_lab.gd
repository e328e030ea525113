extends SceneTree
## Starts the lab as a user does, and prints what it says of the student's own code: a line whenever
## that changes, with the milliseconds of the day. The opening does not move: the numbers on
## the board stay. [code]check_workshop.sh[/code] runs it beside the editor.
## Usage: godot --path . -s tools/editor/told_by_lab.gd -- --lesson=ID

const DAY := 86_400.0

var _told := ""


func _initialize() -> void:
	var main_scene: String = ProjectSettings.get_setting("application/run/main_scene")
	OpeningMotion.is_allowed = false
	change_scene_to_file(main_scene)


func _process(_seconds: float) -> bool:
	var told := _panel() + _board()
	if told != _told:
		_told = told
		print("lab: %d %s" % [fmod(Time.get_unix_time_from_system(), DAY) * 1000.0, told])
	return false


# The section in the panel: sign, exercise, place, sentence.
func _panel() -> String:
	for section: OwnCode in root.find_children("*", "OwnCode", true, false):
		var parts: PackedStringArray = []
		for part: String in ["%Sign", "%Heading", "%Place", "%Sentence"]:
			parts.append((section.get_node(part) as Label).text)
		return " | ".join(parts)
	return ""


# What is written on the board beside the answer of `dot`, as long as it is this file's.
func _board() -> String:
	for answers: OwnAnswer in root.find_children("*", "OwnAnswer", true, false):
		if answers.is_current("dot"):
			return " | " + answers.shown("dot").words()
	return ""
