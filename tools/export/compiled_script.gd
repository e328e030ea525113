extends RefCounted
## The names and the strings in a compiled script (.gdc), as Godot 4.5 and 4.6 write it: tokens,
## compressed. Comments are not in it.

const _FORMAT := 101
const _HEAD_SIZE := 12
# After four counts, of which the first two are those of names and constants.
const _TABLES_AT := 16
const _LINE_COUNT_AT := 8
# An entry of the two tables after the names and constants: a token's place and its line or column.
const _ENTRY_SIZE := 8
# In the first byte of a token that is a name or a constant, which has four bytes instead of one.
# Each token is followed by four bytes with its line.
const _LONG_TOKEN := 0x80
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


## The same script with less about where its tokens stood: a line's first token keeps the number of
## the line, so that errors still tell it, and the others have 0. Godot notes it for every token and
## once more in a table of line breaks, which takes a fifth of a compressed script. Bytes that are
## no compressed script of the known form come back as they are.
static func with_fewer_line_numbers(bytes: PackedByteArray) -> PackedByteArray:
	var script := new(bytes)
	if not script.is_valid or bytes.decode_u32(_HEAD_SIZE - 4) == 0:
		return bytes
	var size := bytes.decode_u32(_HEAD_SIZE - 4)
	var tables := bytes.slice(_HEAD_SIZE).decompress(size, FileAccess.COMPRESSION_ZSTD)
	_clear_line_numbers(tables, _place_of_lines(tables))
	return bytes.slice(0, _HEAD_SIZE) + tables.compress(FileAccess.COMPRESSION_ZSTD)


static func _place_of_lines(tables: PackedByteArray) -> int:
	var place := _TABLES_AT
	for index: int in tables.decode_u32(0):
		place += 4 + 4 * tables.decode_u32(place)
	for index: int in tables.decode_u32(4):
		place += tables.decode_var_size(place)
	return place


static func _clear_line_numbers(tables: PackedByteArray, lines_at: int) -> void:
	var line_count := tables.decode_u32(_LINE_COUNT_AT)
	var is_first: Dictionary[int, bool] = {}
	for entry: int in line_count:
		var place := lines_at + _ENTRY_SIZE * entry
		is_first[tables.decode_u32(place)] = true
		tables.encode_u32(place + 4, 0)
	var token_at := lines_at + 2 * _ENTRY_SIZE * line_count
	for token: int in tables.decode_u32(_LINE_COUNT_AT + 4):
		var line_at := token_at + (4 if tables[token_at] & _LONG_TOKEN else 1)
		if not is_first.has(token):
			tables.encode_u32(line_at, 0)
		token_at = line_at + 4
