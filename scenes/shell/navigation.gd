class_name Navigation
extends RefCounted
## Goes from the start screen to a lesson and back.

const _LESSON_FRAME := "res://scenes/shell/lesson_frame.tscn"
# The setting that names a script whose `follow(frame)` adds something to each lesson that is
# opened. A setting, because no export holds that script.
const _BESIDES := "vec2_lab/lesson/besides"


## Opens [param lesson] in place of the present scene. Only now is the lesson's scene loaded.
static func open_lesson(tree: SceneTree, lesson: LessonInfo) -> void:
	var frame := (load(_LESSON_FRAME) as PackedScene).instantiate() as LessonFrame
	frame.lesson_info = lesson
	frame.lessons = LessonAgenda.lessons()
	frame.left.connect(open_start_screen.bind(tree, lesson))
	frame.other_lesson_wanted.connect(func(other: LessonInfo) -> void: open_lesson(tree, other))
	frame.ready.connect(DoneNotes.follow.bind(frame))
	var besides: String = ProjectSettings.get_setting(_BESIDES, "")
	if ResourceLoader.exists(besides):
		var script := load(besides) as GDScript
		frame.ready.connect(func() -> void: script.call(&"follow", frame))
	_change_scene.call_deferred(tree, frame)


## Goes back from the lesson [param left] to the start screen, the project's main scene.
static func open_start_screen(tree: SceneTree, left: LessonInfo) -> void:
	var main_scene: String = ProjectSettings.get_setting("application/run/main_scene")
	var start_screen := (load(main_scene) as PackedScene).instantiate()
	start_screen.set(&"came_from", left)
	_change_scene.call_deferred(tree, start_screen)


## Shows [param screen], a screen of the lab of another kind, in place of the present scene.
static func open_screen(tree: SceneTree, screen: Node) -> void:
	_change_scene.call_deferred(tree, screen)


static func _change_scene(tree: SceneTree, scene: Node) -> void:
	# What is being typed is taken, or refused, while its scene is still there.
	tree.root.gui_release_focus()
	var frame := tree.current_scene as LessonFrame
	if frame:
		LessonBoards.keep(frame.lesson_info.id, frame.view)
	if tree.current_scene:
		tree.current_scene.free()
	tree.root.add_child(scene)
	tree.current_scene = scene
