class_name DeskTest
extends ScreenTest
## The base of tests in which a student saves files while a lesson is open, in a folder of its own.

const FOLDER := "user://desk_test"
const HAND_INS := "res://tests/data/hand_ins"

## Frames in which what is waited for must have come.
const _PATIENCE := 30_000

## The lab's watcher, on [constant FOLDER].
var watcher: WorkshopWatcher


func before_each() -> void:
	super()
	DirAccess.make_dir_recursive_absolute(FOLDER)
	for file in DirAccess.get_files_at(FOLDER):
		DirAccess.remove_absolute(FOLDER.path_join(file))
	watcher = WorkshopLabWatcher.of(get_tree())
	watcher.folder = FOLDER


func after_each() -> void:
	await super()


## Opens a lesson as the start screen does, and waits until the files have been judged.
func open_with_desk(id: StringName) -> void:
	Navigation.open_lesson(get_tree(), LessonIndex.find(id))
	await student.settle()
	await wait_for(is_judged)


## Saves [param body] as that of `dot`.
func save_dot(body: String) -> void:
	var head := "(other: MyVec2) -> float:\n\t"
	var text := WorkshopFiles.starter("my_vec2.gd").replace(head + "return 0.0", head + body)
	save_file("my_vec2.gd", text)


func save_file(file: String, text: String) -> void:
	FileAccess.open(FOLDER.path_join(file), FileAccess.WRITE).store_string(text)


## Saves the files of a hand-in, and waits until they have been judged.
func save_hand_in(hand_in: String) -> void:
	for file in DirAccess.get_files_at(HAND_INS.path_join(hand_in)):
		var from := HAND_INS.path_join(hand_in).path_join(file)
		DirAccess.copy_absolute(from, FOLDER.path_join(file))
	await wait_for_verdict(watcher.report)


## Waits until what is saved has been judged; [param before] is the report on what was there before.
func wait_for_verdict(before: WorkshopReport) -> void:
	await wait_for(func() -> bool: return watcher.report != before and is_judged())


## Whether all that is saved has been judged.
func is_judged() -> bool:
	return watcher.report != null and watcher.report.is_complete


## Lets frames pass until [param condition] holds; fails where it never does.
func wait_for(condition: Callable) -> void:
	for frame_number in _PATIENCE:
		if condition.call():
			return
		await get_tree().process_frame
		OS.delay_msec(1)
	fail_test("it never comes")


## The section in the panel; null where there is none.
func section() -> OwnCode:
	var found := screen().find_children("*", "OwnCode", true, false)
	return found[0] as OwnCode if found else null


## What is drawn on the board; null where there is nothing.
func answers() -> OwnAnswer:
	var found := screen().find_children("*", "OwnAnswer", true, false)
	return found[0] as OwnAnswer if found else null


## Waits until the student's answer to the board as it is now is drawn.
func wait_for_answer(method: String) -> OwnQuestion:
	await wait_for(func() -> bool: return answers().is_current(method))
	return answers().shown(method)
