class_name MadePack
extends RefCounted
## Writes small packs with the engine's own packer.

const _SOURCE := "user://packed_file"


## Writes a pack with these texts by their paths in it, without `res://`, to [param path].
static func write(path: String, texts: Dictionary[String, String]) -> void:
	var packer := PCKPacker.new()
	packer.pck_start(path)
	for inner_path: String in texts:
		# The packer reads its files when it is flushed: each needs one of its own.
		var source := _SOURCE + str(inner_path.hash())
		FileAccess.open(source, FileAccess.WRITE).store_string(texts[inner_path])
		packer.add_file("res://" + inner_path, source)
	packer.flush()
	for inner_path: String in texts:
		DirAccess.remove_absolute(_SOURCE + str(inner_path.hash()))


## A script in the form of a pack, for [method write]: its pointer and its content, which is empty.
static func script(path: String) -> Dictionary[String, String]:
	return {
		path + ".remap": '[remap]\n\npath="res://%sc"\n' % path,
		path + "c": "",
	}
