@tool
extends EditorPlugin
## Uses the editor as a person would: opens, saves and closes scenes, opens the export window and
## closes it, quits. [code]check_editor.sh[/code] enables this plugin in a copy of the project.
##
## The arguments behind [code]--[/code] are the scenes. Prints a line for each step, and
## [constant DONE] after the last one: as errors, which are not held back until many are there.

const DONE := "editor: done"
const EXPORT := "Export..."
const MOST_FRAMES_TO_OPEN := 100
const STUDENT_S_FILE := "res://workshop/my_vec2.gd"
## Longer than the editor waits before it writes changed presets.
const SECONDS_TO_WRITE := 1.0


func _enter_tree() -> void:
	_use.call_deferred()


func _use() -> void:
	await _wait_for_scan()
	await _look_for_student_s_files()
	for scene: String in OS.get_cmdline_user_args():
		await _open_save_and_close(scene)
	await _look_at_exports()
	if not get_tree().root.find_children("GutBottomPanel", "", true, false).is_empty():
		printerr("editor: GUT's panel is there")
	printerr(DONE)
	# From here on the editor must not run inside this function: it frees this plugin.
	get_tree().root.get_child(0).notification.call_deferred(NOTIFICATION_WM_CLOSE_REQUEST)


func _wait_for_scan() -> void:
	await _wait_frames(5)
	while EditorInterface.get_resource_filesystem().is_scanning():
		await _wait_frames(1)
	await _wait_frames(5)


# The workshop's plugin has put them there while the fresh project was read.
func _look_for_student_s_files() -> void:
	for _frame: int in MOST_FRAMES_TO_OPEN:
		if _lists(STUDENT_S_FILE):
			return
		await _wait_frames(1)
	push_error("%s is not in the list of files" % STUDENT_S_FILE)


func _lists(file: String) -> bool:
	var files := EditorInterface.get_resource_filesystem()
	var folder := files.get_filesystem_path(file.get_base_dir())
	return folder != null and folder.find_file_index(file.get_file()) >= 0


func _open_save_and_close(scene: String) -> void:
	EditorInterface.open_scene_from_path(scene)
	for _frame: int in MOST_FRAMES_TO_OPEN:
		await _wait_frames(1)
		if _edited_scene() == scene:
			break
	if _edited_scene() != scene:
		push_error("%s does not open; open is “%s”" % [scene, _edited_scene()])
		return
	# Without a change the editor would not write anything.
	EditorInterface.mark_scene_as_unsaved()
	var saved := EditorInterface.save_scene()
	await _wait_frames(1)
	var closed := EditorInterface.close_scene()
	await _wait_frames(1)
	printerr("editor: %s: saved %s, closed %s" % [scene, error_string(saved), error_string(closed)])


func _edited_scene() -> String:
	var root := EditorInterface.get_edited_scene_root()
	return root.scene_file_path if root != null else ""


func _look_at_exports() -> void:
	var windows := get_tree().root.find_children("*", "ProjectExportDialog", true, false)
	for menu: PopupMenu in get_tree().root.find_children("*", "PopupMenu", true, false):
		for index: int in menu.item_count:
			if menu.get_item_text(index) == EXPORT:
				menu.id_pressed.emit(menu.get_item_id(index))
	await _wait_frames(5)
	for window: Window in windows:
		printerr("editor: the export window is %s" % ("open" if window.visible else "NOT open"))
		window.hide()
	await get_tree().create_timer(SECONDS_TO_WRITE).timeout


func _wait_frames(count: int) -> void:
	for _frame: int in count:
		await get_tree().process_frame
