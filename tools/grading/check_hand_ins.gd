extends SceneTree
## Checks hand-ins: each folder and each zip in a folder is one. As many are judged at once as the
## machine has cores. What it prints for the user begins with "> ".
## Usage: godot --headless --path . -s tools/grading/check_hand_ins.gd -- FOLDER INTO HOME LANGUAGE
## MARK [--again]     (MARK: the least that each must reach, or 0)

const HandIn := preload("hand_in.gd")
const HandInRow := preload("hand_in_row.gd")
const Results := preload("results.gd")

const _WAIT := 2
# A hand-in is judged anew when one of these has changed.
const _RULES: PackedStringArray = ["res://workshop/kit", "res://workshop/starters", "res://scripts"]

var _results: Results
var _home := ""
var _running: Array[HandIn] = []
var _judged := 0


func _initialize() -> void:
	var arguments := OS.get_cmdline_user_args()
	_home = arguments[2]
	TranslationServer.set_locale(arguments[3])
	var begun := Time.get_ticks_msec()
	var names := _names_in(arguments[0])
	_results = Results.new(arguments[1], "--again" in arguments)
	if not names or _results.problem():
		print("> %s" % (_results.problem() if names else "There is no hand-in in the folder."))
		quit(2)
		return
	_check(arguments[0], names)
	_results.finish()
	var seconds := (Time.get_ticks_msec() - begun) / 1000.0
	_tell_end(names, seconds, arguments[1])
	quit(0 if _have_reached(names, arguments[4].to_int()) else 1)


func _check(folder: String, names: PackedStringArray) -> void:
	var rules := _sum_of_rules()
	for index in names.size():
		var hand_in := HandIn.new(folder.path_join(names[index]), rules)
		if _results.has(hand_in.row):
			continue
		hand_in.begin(_home.path_join(str(index)))
		_running.append(hand_in)
		_wait_for_fewer_than(maxi(1, OS.get_processor_count()))
	_wait_for_fewer_than(1)


func _wait_for_fewer_than(count: int) -> void:
	while _running.size() >= count:
		for hand_in: HandIn in _running.duplicate():
			if hand_in.look():
				_running.erase(hand_in)
				_results.add(hand_in.row)
				_judged += 1
				print("> %s" % hand_in.row.line())
		OS.delay_msec(_WAIT)


func _tell_end(names: PackedStringArray, seconds: float, into: String) -> void:
	for row in _results.rows():
		if row.same_as:
			print("> %s: same code as %s" % [row.name, row.same_shortly()])
	var known := names.size() - _judged
	print("> %d judged in %.1f s, %d known before: see %s" % [_judged, seconds, known, into])


func _have_reached(names: PackedStringArray, least: int) -> bool:
	if least == WorkshopReport.Mark.NOT_YET:
		return true
	var marks: PackedStringArray = []
	for mark: WorkshopReport.Mark in WorkshopReport.Mark.values():
		marks.append(WorkshopReport.name_of(mark))
	for row in _results.rows():
		var is_meant := Array(names).any(
			func(name: String) -> bool: return HandInRow.plain(name) == row.name
		)
		if is_meant and marks.find(row.mark) < least:
			return false
	return true


# Folders, zips and what else lies there, but for the results, and for what is hidden.
static func _names_in(folder: String) -> PackedStringArray:
	var names := DirAccess.get_directories_at(folder)
	for name in DirAccess.get_files_at(folder):
		if not name.begins_with("results."):
			names.append(name)
	names.sort()
	return names


static func _sum_of_rules() -> String:
	var sums := TranslationServer.get_locale() + str(WorkshopTestRun.is_by_gut())
	for folder in _RULES:
		sums += _sum_of(folder)
	return sums.md5_text()


static func _sum_of(folder: String) -> String:
	var sums := ""
	for name in DirAccess.get_directories_at(folder):
		sums += _sum_of(folder.path_join(name))
	for name in DirAccess.get_files_at(folder):
		if name.get_extension() == "gd":
			sums += FileAccess.get_md5(folder.path_join(name))
	return sums
