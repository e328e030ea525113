class_name WorkshopWays
extends RefCounted
## The ways between the workshop's screens, the lessons and the start screen. The screens only say
## where the student wants to go.

const _ROOM := "res://scenes/workshop/room/workshop_room.tscn"
const _RUBRIC := "res://scenes/workshop/room/rubric_page.tscn"
const _CODE := "res://scenes/workshop/room/code_page.tscn"
const _ROTATION := "res://scenes/workshop/room/rotation_room.tscn"

# The student comes back from the workshop: the start screen begins at its card.
static var _comes_back := false


## Opens what comes next, as soon as the student's files have been looked at. Where he writes in the
## lab itself that is the page for it.
static func open_next(tree: SceneTree) -> void:
	if not WorkshopChild.can_run():
		open_code(tree)
		return
	var room := _made(_ROOM) as WorkshopRoom
	room.left.connect(open_start_screen.bind(tree))
	room.lesson_wanted.connect(_open_lesson.bind(tree))
	room.rubric_wanted.connect(open_rubric.bind(tree))
	Navigation.open_screen(tree, room)


## Opens the page on which the student writes.
static func open_code(tree: SceneTree) -> void:
	var page := _made(_CODE) as CodePage
	page.left.connect(open_start_screen.bind(tree))
	Navigation.open_screen(tree, page)


## Opens the page on which the student writes, at [param exercise]. From there he comes back to
## [param lesson].
static func open_code_of(exercise: WorkshopExercise, lesson: LessonInfo, tree: SceneTree) -> void:
	var page := _made(_CODE) as CodePage
	page.left.connect(_open_lesson.bind(lesson, tree))
	WorkshopKeptCode.choose(exercise)
	Navigation.open_screen(tree, page)


## Opens the page with the rubric.
static func open_rubric(tree: SceneTree) -> void:
	var page := _made(_RUBRIC) as RubricPage
	page.left.connect(open_start_screen.bind(tree))
	page.lesson_wanted.connect(_open_lesson.bind(tree))
	page.rotation_wanted.connect(open_rotation.bind(tree))
	Navigation.open_screen(tree, page)


## Opens the board of exercise 0.
static func open_rotation(tree: SceneTree) -> void:
	var room := _made(_ROTATION) as RotationRoom
	room.left.connect(open_rubric.bind(tree))
	Navigation.open_screen(tree, room)


## Goes back to the start screen.
static func open_start_screen(tree: SceneTree) -> void:
	_comes_back = true
	Navigation.open_start_screen(tree, null)


## Whether the student has just come back to the start screen; asked once.
static func take_way_back() -> bool:
	var comes_back := _comes_back
	_comes_back = false
	return comes_back


# Who comes from here wants to write: what is asked of him is not folded away.
static func _open_lesson(lesson: LessonInfo, tree: SceneTree) -> void:
	Navigation.open_lesson(tree, lesson)
	_unfold_section.call_deferred(tree)


static func _unfold_section(tree: SceneTree) -> void:
	for section: OwnCode in tree.current_scene.find_children("*", "OwnCode", true, false):
		section.unfold()


static func _made(scene: String) -> Node:
	return (load(scene) as PackedScene).instantiate()
