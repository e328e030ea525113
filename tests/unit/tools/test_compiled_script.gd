extends LabTest
## What the export leaves of the line numbers in a compiled script. The script is put together here,
## byte by byte in Godot's form: three tokens on line 7 and two on line 9.

const CompiledScript := preload("res://tools/export/compiled_script.gd")

const _VEIL := 0xb6b6b6b6
const _NAME_TOKEN := 0x82
const _SIGN_TOKEN := 0x05
const _KNOWN_FORMAT := 101


func test_only_the_first_token_after_a_line_break_keeps_its_line() -> void:
	var lean := CompiledScript.with_fewer_line_numbers(_script(_tables(9, [7, 7, 7, 9, 9])))
	assert_eq(_unpacked(lean), _tables(0, [0, 0, 0, 9, 0]))


func test_the_names_and_the_constants_stay() -> void:
	var lean := CompiledScript.with_fewer_line_numbers(_script(_tables(9, [7, 7, 7, 9, 9])))
	assert_eq(CompiledScript.new(lean).names, PackedStringArray(["ab"]))
	assert_eq(CompiledScript.new(lean).strings, PackedStringArray(["text"]))


func test_a_script_of_another_format_stays_as_it_is() -> void:
	var other := _script(_tables(9, [7, 7, 7, 9, 9]), _KNOWN_FORMAT + 1)
	assert_eq(CompiledScript.with_fewer_line_numbers(other), other)


func test_what_is_no_compressed_script_stays_as_it_is() -> void:
	var tables := _tables(9, [7, 7, 7, 9, 9])
	var plain := "GDSC".to_ascii_buffer() + _numbers([_KNOWN_FORMAT, 0]) + tables
	for bytes: PackedByteArray in [PackedByteArray(), "GDSC".to_ascii_buffer(), plain]:
		assert_eq(CompiledScript.with_fewer_line_numbers(bytes), bytes)


func _script(tables: PackedByteArray, format: int = _KNOWN_FORMAT) -> PackedByteArray:
	var head := "GDSC".to_ascii_buffer() + _numbers([format, tables.size()])
	return head + tables.compress(FileAccess.COMPRESSION_ZSTD)


func _unpacked(script: PackedByteArray) -> PackedByteArray:
	return script.slice(12).decompress(script.decode_u32(8), FileAccess.COMPRESSION_ZSTD)


# One name, one constant, a break before the fourth token, which begins line [param new_line], and
# the line of each token.
func _tables(new_line: int, lines: Array[int]) -> PackedByteArray:
	var tables := _numbers([1, 1, 1, 5])
	tables += _numbers([2, "a".unicode_at(0) ^ _VEIL, "b".unicode_at(0) ^ _VEIL])
	tables += var_to_bytes("text")
	tables += _numbers([3, new_line, 3, 5])
	for place: int in lines.size():
		var is_name := place % 2 == 0
		tables += _numbers([_NAME_TOKEN]) if is_name else PackedByteArray([_SIGN_TOKEN])
		tables += _numbers([lines[place]])
	return tables


func _numbers(numbers: Array[int]) -> PackedByteArray:
	return PackedInt32Array(numbers).to_byte_array()
