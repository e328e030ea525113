extends LabTest
## No process is left when the lab is killed, even while a student's code loops in a child.

const _FOLDER := "user://workshop_orphans"
const _LAB := "res://tests/support/killed_lab.gd"
const _LOOP := "func dot(other: MyVec2) -> float:\n\twhile true:\n\t\tpass"
## The child ends at once when its pipe does; the watchdog alone takes 2.5 s.
const _MOST_MILLISECONDS := 10_000


func test_a_killed_lab_leaves_no_process() -> void:
	DirAccess.make_dir_recursive_absolute(_FOLDER)
	var text := WorkshopFiles.starter("my_vec2.gd")
	text = text.replace("func dot(other: MyVec2) -> float:", _LOOP)
	FileAccess.open(_FOLDER.path_join("my_vec2.gd"), FileAccess.WRITE).store_string(text)
	var arguments: PackedStringArray = [
		"--headless", "--path", ProjectSettings.globalize_path("res://"), "-s", _LAB, "--", _FOLDER
	]
	var pipes := OS.execute_with_pipe(OS.get_executable_path(), arguments)
	var lab: int = pipes["pid"]
	var said: FileAccess = pipes["stdio"]
	var child := -1
	while child < 0:
		var line := said.get_line()
		if line.begins_with("child "):
			child = line.get_slice(" ", 1).to_int()
	assert_true(OS.is_process_running(lab))
	assert_true(_is_there(child))
	OS.kill(lab)
	var begun := Time.get_ticks_msec()
	while _is_there(child) and Time.get_ticks_msec() - begun < _MOST_MILLISECONDS:
		OS.delay_msec(50)
	assert_false(_is_there(child))


# The engine knows its own children only, so on Linux and macOS the system is asked.
func _is_there(process: int) -> bool:
	return OS.execute("kill", ["-0", str(process)]) == 0
