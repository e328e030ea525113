extends LabTest
## The reader of packs against packs that the engine itself has written, and against broken ones.

const Pack := preload("res://tools/export/pack.gd")

const _FILE := "user://made.pck"


func after_each() -> void:
	DirAccess.remove_absolute(_FILE)


func test_it_lists_every_file_with_its_size_and_reads_it() -> void:
	MadePack.write(_FILE, {"a.txt": "one", "folder/b.txt": "äö", "empty": ""})
	var pack := Pack.new(_FILE)
	assert_eq(pack.problem, "")
	assert_eq(pack.sizes, {"a.txt": 3, "folder/b.txt": 4, "empty": 0} as Dictionary[String, int])
	assert_eq(pack.bytes_of("folder/b.txt").get_string_from_utf8(), "äö")
	assert_eq(pack.bytes_of("not_there"), PackedByteArray())
	assert_eq(pack.total_size, FileAccess.get_size(_FILE))


func test_a_file_that_is_not_there_is_said() -> void:
	assert_string_contains(Pack.new("user://none.pck").problem, "none.pck cannot be opened")


func test_a_file_that_is_no_pack_is_said() -> void:
	_assert_problem("".to_utf8_buffer(), "it does not begin as one")
	_assert_problem("a text ".repeat(40).to_utf8_buffer(), "it does not begin as one")


func test_another_format_is_said_with_its_number() -> void:
	var bytes := _made()
	bytes.encode_u32(4, 99)
	_assert_problem(bytes, "its format is 99, and 3 is known")


func test_a_directory_outside_of_the_file_is_said() -> void:
	var bytes := _made()
	bytes.encode_u64(32, bytes.size() + 1)
	_assert_problem(bytes, "its directory lies outside of it")


func test_a_pack_that_breaks_off_is_said_and_lists_nothing() -> void:
	var bytes := _made()
	_assert_problem(bytes.slice(0, bytes.size() - 1), "is broken")


func test_a_size_beyond_the_end_of_the_file_is_said() -> void:
	var bytes := _made()
	var size_at := bytes.size() - 28
	assert_eq(bytes.decode_u64(size_at), 3)
	bytes.encode_u64(size_at, 1 << 40)
	_assert_problem(bytes, "entry 1 of its directory is broken")


func _made() -> PackedByteArray:
	MadePack.write(_FILE, {"a.txt": "one", "b.txt": "two"})
	return FileAccess.get_file_as_bytes(_FILE)


func _assert_problem(bytes: PackedByteArray, part: String) -> void:
	FileAccess.open(_FILE, FileAccess.WRITE).store_buffer(bytes)
	var pack := Pack.new(_FILE)
	assert_string_contains(pack.problem, part)
	assert_string_contains(pack.problem, "made.pck")
	assert_eq(pack.sizes.size(), 0)
