extends RefCounted
## The names and the strings in a compiled script (.gdc), as Godot 4.5 and 4.6 write it: tokens,
## compressed. Comments are not in it.

const _FORMAT := 101
const _HEAD_SIZE := 12
# After four counts, of which the first two are those of names and constants.
const _TABLES_AT := 16
# Letters of names are stored combined with this by exclusive or.
const _VEIL := 0xb6b6b6b6

## False for bytes that are no such script; then there are no names.
var is_valid := false
var names: PackedStringArray
var strings: PackedStringArray


## [param bytes]: the whole file.
func _init(bytes: PackedByteArray) -> void:
	if bytes.size() < _HEAD_SIZE or bytes.slice(0, 4).get_string_from_ascii() != "GDSC":
		return
	if bytes.decode_u32(4) != _FORMAT:
		return
	var tables := bytes.slice(_HEAD_SIZE)
	var unpacked_size := bytes.decode_u32(8)
	if unpacked_size > 0:
		tables = tables.decompress(unpacked_size, FileAccess.COMPRESSION_ZSTD)
	if tables.size() > _TABLES_AT:
		is_valid = true
		_read_strings(tables, _read_names(tables))


# Comes back with the place after the last name.
func _read_names(tables: PackedByteArray) -> int:
	var place := _TABLES_AT
	for index: int in tables.decode_u32(0):
		var end := place + 4 + 4 * tables.decode_u32(place)
		if end > tables.size():
			is_valid = false
			return tables.size()
		names.append(_unveiled(tables.slice(place + 4, end)))
		place = end
	return place


func _unveiled(letters: PackedByteArray) -> String:
	var word := ""
	for letter: int in letters.to_int32_array():
		word += String.chr((letter ^ _VEIL) & 0xffffffff)
	return word


func _read_strings(tables: PackedByteArray, from: int) -> void:
	var place := from
	for index: int in tables.decode_u32(4) if is_valid else 0:
		var value: Variant = tables.decode_var(place)
		if value is String or value is StringName or value is NodePath:
			strings.append(str(value))
		place += tables.decode_var_size(place)
