extends RefCounted
## What a .pck really holds, read from its own directory; the format is that of Godot 4.5 and 4.6.

const _MAGIC := 0x43504447
const _FORMAT := 3
const _HEAD_SIZE := 112
const _ENCRYPTED_DIRECTORY := 1
const _REMOVED_FILE := 2
# Places in the head.
const _FORMAT_AT := 4
const _FLAGS_AT := 20
const _BASE_AT := 24
const _DIRECTORY_AT := 32
# What follows a path in the directory: place, size, MD5 sum, flags.
const _ENTRY_TAIL := 36

## Why it could not be read: one sentence; "" when all is well. Then the rest is empty.
var problem := ""
## Size of the whole file in bytes.
var total_size := 0
## Every file in the pack, without `res://`, with its size in bytes; in their order in the pack.
var sizes: Dictionary[String, int] = {}

var _path: String
var _places: Dictionary[String, int] = {}


## Reads the pack at [param path]; a file that is no pack has a [member problem].
func _init(path: String) -> void:
	_path = path
	var file := FileAccess.open(path, FileAccess.READ)
	if file == null:
		problem = "%s cannot be opened: %s" % [path, error_string(FileAccess.get_open_error())]
		return
	total_size = file.get_length()
	problem = _problem_of_head(file.get_buffer(_HEAD_SIZE))
	if not problem:
		_read_directory(file)
	if problem:
		problem = "%s is no pack that can be read: %s" % [path, problem]
		sizes.clear()


## The content of a file in the pack, as in [member sizes]; empty for one that is not there.
func bytes_of(inner_path: String) -> PackedByteArray:
	if not sizes.has(inner_path):
		return PackedByteArray()
	var file := FileAccess.open(_path, FileAccess.READ)
	file.seek(_places[inner_path])
	return file.get_buffer(sizes[inner_path])


func _problem_of_head(head: PackedByteArray) -> String:
	if head.size() < _HEAD_SIZE or head.decode_u32(0) != _MAGIC:
		return "it does not begin as one"
	var format := head.decode_u32(_FORMAT_AT)
	if format != _FORMAT:
		return "its format is %d, and %d is known" % [format, _FORMAT]
	if head.decode_u32(_FLAGS_AT) & _ENCRYPTED_DIRECTORY:
		return "its directory is encrypted"
	return ""


func _read_directory(file: FileAccess) -> void:
	file.seek(_BASE_AT)
	var base := file.get_64()
	file.seek(_DIRECTORY_AT)
	var directory := file.get_64()
	if directory < _HEAD_SIZE or directory + 4 > total_size:
		problem = "its directory lies outside of it"
		return
	file.seek(directory)
	for entry: int in file.get_32():
		if not _read_entry(file, base):
			problem = "entry %d of its directory is broken" % entry
			return


func _read_entry(file: FileAccess, base: int) -> bool:
	var left := total_size - file.get_position()
	var length := file.get_32()
	if 4 + length + _ENTRY_TAIL > left:
		return false
	var inner_path := file.get_buffer(length).get_string_from_utf8()
	var place := base + file.get_64()
	var size := file.get_64()
	file.get_buffer(16)
	if file.get_32() & _REMOVED_FILE:
		return true
	if not inner_path or place < _HEAD_SIZE or size < 0 or place + size > total_size:
		return false
	sizes[inner_path] = size
	_places[inner_path] = place
	return true
