class_name InputActions
extends RefCounted
## The keys and buttons of a pack. In a project's settings each event takes 400 bytes; a pack holds
## all of them compressed in one file, which `tools/export/lean_export.gd` writes.

## Where a pack holds them: their size in 4 bytes, then the compressed events of each action. In two
## parts, because it is no file of the project that an export would look for.
const FILE := "res:/" + "/input_actions.bin"


## Gives the InputMap the actions of a pack. Does nothing where the project's settings have them.
static func load_packed() -> void:
	if not FileAccess.file_exists(FILE):
		return
	var actions := unpacked(FileAccess.get_file_as_bytes(FILE))
	for action: StringName in actions:
		if not InputMap.has_action(action):
			InputMap.add_action(action)
		InputMap.action_erase_events(action)
		for event: InputEvent in actions[action]:
			InputMap.action_add_event(action, event)


## The actions with their events in [param bytes], the content of [constant FILE].
static func unpacked(bytes: PackedByteArray) -> Dictionary:
	var mode := FileAccess.COMPRESSION_ZSTD
	return bytes_to_var_with_objects(bytes.slice(4).decompress(bytes.decode_u32(0), mode))
