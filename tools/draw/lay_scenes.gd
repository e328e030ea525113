extends SceneTree
## Writes into each lesson's scene where its parts lie when the lesson starts, so that the editor
## shows the board as the lesson begins. Moves nothing that the lesson reads from its scene.
## Usage: godot --headless --path . -s tools/draw/lay_scenes.gd [-- LESSON ...]

const SceneStart := preload("scene_start.gd")
const _FRAME := "res://scenes/shell/lesson_frame.tscn"
const _FRAMES_TO_SETTLE := 5


func _init() -> void:
	OpeningMotion.is_allowed = false
	# The engine sets the window's size in the first frame.
	await process_frame
	root.size = Vector2i(1280, 720)
	var ids := OS.get_cmdline_user_args()
	for id: String in ids if ids else LessonIndex.ids() + PackedStringArray(["smallest_lesson"]):
		await _lay(LessonIndex.find(id))
	quit()


func _lay(info: LessonInfo) -> void:
	var frame := (load(_FRAME) as PackedScene).instantiate() as LessonFrame
	frame.lesson_info = info
	root.add_child(frame)
	for i: int in _FRAMES_TO_SETTLE:
		await process_frame
	var packed := load(info.scene_path()) as PackedScene
	var scene := packed.instantiate(PackedScene.GEN_EDIT_STATE_MAIN)
	var differences := SceneStart.differences(frame.lesson, scene)
	print("%s: %d values" % [info.id, differences.size()])
	if differences:
		SceneStart.copy(frame.lesson, scene)
		packed.pack(scene)
		ResourceSaver.save(packed, info.scene_path())
	scene.free()
	frame.free()
