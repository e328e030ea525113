class_name Navigation
extends RefCounted
## Goes from the start screen to a lesson and back.

const _LESSON_FRAME := "res://scenes/shell/lesson_frame.tscn"


## Opens [param lesson] in place of the present scene. Only now is the lesson's scene loaded.
static func open_lesson(tree: SceneTree, lesson: LessonInfo) -> void:
	var frame := (load(_LESSON_FRAME) as PackedScene).instantiate() as LessonFrame
	frame.lesson_info = lesson
	frame.left.connect(open_start_screen.bind(tree))
	frame.other_lesson_wanted.connect(func(other: LessonInfo) -> void: open_lesson(tree, other))
	_change_scene.call_deferred(tree, frame)


## Goes back to the start screen, the project's main scene.
static func open_start_screen(tree: SceneTree) -> void:
	var start_screen: String = ProjectSettings.get_setting("application/run/main_scene")
	_change_scene.call_deferred(tree, (load(start_screen) as PackedScene).instantiate())


static func _change_scene(tree: SceneTree, scene: Node) -> void:
	# What is being typed is taken, or refused, while its scene is still there.
	tree.root.gui_release_focus()
	if tree.current_scene:
		tree.current_scene.free()
	tree.root.add_child(scene)
	tree.current_scene = scene
