extends LabTest
## Tests of the list of the ways of stepping, and of the files that one way needs.

const NeededFiles := preload("res://tools/export/needed_files.gd")

const _FOLDER := "res://scripts/world/stepped/"


func test_each_method_has_its_own_mover() -> void:
	var kinds: Dictionary[Script, bool] = {}
	for method: int in SteppingMethods.Method.size():
		var mover := SteppingMethods.mover_of(method as SteppingMethods.Method)
		var kind: Script = mover.get_script()
		kinds[kind] = true
	assert_eq(kinds.size(), SteppingMethods.Method.size())


func test_a_stepped_world_knows_no_mover() -> void:
	var files := NeededFiles.new([_FOLDER + "stepped_world.gd"]).files
	var movers := Array(files).filter(func(file: String) -> bool: return file.contains("_mover"))
	assert_eq(movers, [_FOLDER + "ball_mover.gd"])


func test_a_stepped_world_with_the_right_mover_needs_at_most_18_files() -> void:
	var starts := [_FOLDER + "stepped_world.gd", _FOLDER + "whole_frame_mover.gd"]
	var needed := NeededFiles.new(PackedStringArray(starts))
	assert_eq(needed.problems, PackedStringArray())
	assert_lte(needed.files.size(), 18, "\n".join(needed.files))
	assert_has(needed.files, "res://scripts/collision/segment_impact.gd", "files are followed")
