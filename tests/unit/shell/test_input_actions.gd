extends LabTest
## Actions in a pack: as in the project's settings, without a bit lost.

const LeanExport := preload("res://tools/export/lean_export.gd")


func test_a_pack_holds_the_actions_of_the_project() -> void:
	var actions := LeanExport.actions_in_settings(["input/lab_slow"])
	assert_has(actions, &"lab_undo")
	assert_has(actions, &"ui_accept")
	assert_does_not_have(actions, &"lab_slow")


func test_packed_actions_come_back_with_all_their_events() -> void:
	var actions := LeanExport.actions_in_settings([])
	var bytes := LeanExport.packed(actions)
	assert_lt(bytes.size(), 2000)
	var back := InputActions.unpacked(bytes)
	assert_eq(back.keys(), actions.keys())
	for action: StringName in actions:
		var events: Array = back[action]
		var texts := func(event: InputEvent) -> String: return event.as_text()
		assert_eq(events.map(texts), actions[action].map(texts), action)
