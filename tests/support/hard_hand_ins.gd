class_name HardHandIns
extends RefCounted
## Makes a folder of hand-ins that are hard to grade: as course platforms pack them, badly named,
## damaged, hostile. Each name is that of a hand-in.

const _RIGHT := "res://tests/data/hand_ins/right_plain"
const _TESTS := "res://tests/data/hand_in_tests/my_vec2_test.gd"
const _DOT := "func dot(other: MyVec2) -> float:\n\treturn 0.0"
const _LOOP := "\twhile true:\n\t\tpass\n"
const _BOMB_CHUNK := 1_000_000

var _folder := ""


## Makes them in [param folder], whose path is one of the disk.
func _init(folder: String) -> void:
	_folder = folder
	DirAccess.make_dir_recursive_absolute(folder)


## Makes all of them. Zip bombs hold [param megabytes].
func make_all(megabytes: int) -> void:
	make_packed_ones()
	make_named_ones()
	make_hostile_zips(megabytes)
	make_hostile_files(megabytes)
	make_hostile_code()
	make_copies()


## Right ones, as course platforms pack them.
func make_packed_ones() -> void:
	put_right("Jos\u00e9 de la Cruz_12345_assignsubmission_file_")
	zip("Zip_12346_assignsubmission_file_/my work.zip", right_files("my work/"))
	zip("zip_of_files.zip", right_files(""))
	var lab := right_files("lab-main/workshop/")
	lab["lab-main/workshop/kit/judge.gd"] = "# the lab".to_utf8_buffer()
	lab["lab-main/workshop/starters/my_bounce.gd"] = _bytes("res://workshop/starters/my_bounce.gd")
	lab["lab-main/tests/data/hand_ins/right_step/my_bounce.gd"] = _bytes(
		"res://tests/data/hand_ins/right_step/my_bounce.gd"
	)
	lab["__MACOSX/lab-main/workshop/my_vec2.gd"] = PackedByteArray([0, 5, 22, 7])
	zip("zip_of_lab.zip", lab)
	put_right("two_deep/my game/workshop")
	put("with_tests/test_my_vec2.gd", _bytes(_TESTS))
	put("with_tests/my_vec2.gd", _bytes(_RIGHT.path_join("my_vec2.gd")))


## Those that are not what was asked for.
func make_named_ones() -> void:
	put("twice/a/my_vec2.gd", right())
	put("twice/b/my_vec2.gd", right())
	put("misnamed/My_Vec2.gd", right())
	put("misnamed_copy/my_vec2 (1).gd", right())
	put("other_language/Vec2.cs", "class Vec2 {}".to_utf8_buffer())
	put("rar.rar", "Rar!".to_utf8_buffer())
	DirAccess.make_dir_recursive_absolute(_folder.path_join("nothing"))
	put("-rf/my_vec2.gd", right())
	put("=1+1/my_vec2.gd", right())
	put("new\nline | \u001b[31m/my_vec2.gd", right())
	for number: int in 25:
		put("many_tests/test_my_%d.gd" % number, _bytes(_TESTS))


## Zips that were made to do harm, or are damaged.
func make_hostile_zips(megabytes: int) -> void:
	zip("zip_climbs.zip", {"../../climbed/my_vec2.gd": right(), "/climbed/my_line.gd": right()})
	zip_bomb("zip_bomb.zip", megabytes)
	put("zip_bomb_that_lies.zip", _with_size(_read("zip_bomb.zip"), 1000))
	put("zip_locked.zip", _with_flags(_read("zip_of_files.zip"), 1))
	put("zip_cut_off.zip", _read("zip_of_files.zip").slice(0, 900))
	put("zip_of_noise.zip", "PK no zip at all".to_utf8_buffer())
	put("zip_empty.zip", PackedByteArray())


## Links, pipes, and files that are too large or may not be read. Not on Windows.
func make_hostile_files(megabytes: int) -> void:
	put("huge/my_vec2.gd", PackedByteArray())
	var huge := FileAccess.open(_folder.path_join("huge/my_vec2.gd"), FileAccess.WRITE)
	for chunk in megabytes:
		huge.store_string("#".repeat(_BOMB_CHUNK))
	put("unreadable/my_vec2.gd", right())
	FileAccess.set_unix_permissions(_folder.path_join("unreadable/my_vec2.gd"), 0)
	put("link_out/my_line.gd", _bytes(_RIGHT.path_join("my_line.gd")))
	var here := DirAccess.open(_folder)
	here.create_link("/etc/passwd", _folder.path_join("link_out/my_vec2.gd"))
	here.create_link("/etc", _folder.path_join("link_to_folder"))
	put("link_round/my_vec2.gd", right())
	here.create_link(_folder, _folder.path_join("link_round/round"))
	put("pipe/my_line.gd", _bytes(_RIGHT.path_join("my_line.gd")))
	OS.execute("mkfifo", [_folder.path_join("pipe/my_vec2.gd")])


## Code that takes too long in unusual places.
func make_hostile_code() -> void:
	var text := right().get_string_from_utf8()
	var made := "float = 0.0) -> void:\n"
	put("loop_when_made/my_vec2.gd", text.replace(made, made + _LOOP).to_utf8_buffer())
	var every := RegEx.create_from_string("(?m)^(func [a-z].*:)$").sub(text, "$1\n" + _LOOP, true)
	put("loop_everywhere/my_vec2.gd", every.to_utf8_buffer())
	put("loop_in_test/my_vec2.gd", right())
	var test := "extends GutTest\n\n\nfunc test_dot() -> void:\n"
	put("loop_in_test/test_my_vec2.gd", (test + _LOOP).to_utf8_buffer())
	put("brackets/my_vec2.gd", (text + "var a := " + "(".repeat(90_000)).to_utf8_buffer())
	put("quotes/my_vec2.gd", (text + '"""'.repeat(30_000)).to_utf8_buffer())
	put("functions/my_vec2.gd", (text + "func a():\n\tpass\n".repeat(5000)).to_utf8_buffer())


## Two with the same code but for names, blanks and comments.
func make_copies() -> void:
	var own := _bytes("res://tests/data/hand_ins/right_in_vectors/my_vec2.gd")
	put("copy_of_one/my_vec2.gd", own)
	var text := own.get_string_from_utf8()
	for word: String in ["size", "other", "onto", "change"]:
		text = RegEx.create_from_string("\\b%s\\b" % word).sub(text, word + "_2", true)
	put("copy_renamed/my_vec2.gd", (text + "\n# mine\n").to_utf8_buffer())


## The text of a right `my_vec2.gd`.
static func right() -> PackedByteArray:
	return _bytes(_RIGHT.path_join("my_vec2.gd"))


## The files of a right hand-in, by their paths behind [param prefix].
static func right_files(prefix: String) -> Dictionary[String, PackedByteArray]:
	var files: Dictionary[String, PackedByteArray] = {}
	for name in DirAccess.get_files_at(_RIGHT):
		files[prefix + name] = _bytes(_RIGHT.path_join(name))
	return files


## Writes the files of a right hand-in into a folder.
func put_right(below: String) -> void:
	var files := right_files(below + "/")
	for path in files:
		put(path, files[path])


## Writes a file.
func put(path: String, bytes: PackedByteArray) -> void:
	DirAccess.make_dir_recursive_absolute(_folder.path_join(path).get_base_dir())
	FileAccess.open(_folder.path_join(path), FileAccess.WRITE).store_buffer(bytes)


## Writes a zip of these files.
func zip(path: String, files: Dictionary[String, PackedByteArray]) -> void:
	DirAccess.make_dir_recursive_absolute(_folder.path_join(path).get_base_dir())
	var packer := _packer(path)
	for name in files:
		packer.start_file(name)
		packer.write_file(files[name])
		packer.close_file()
	packer.close()


## Writes a small zip whose one file is very large.
func zip_bomb(path: String, megabytes: int) -> void:
	var packer := _packer(path)
	packer.start_file("my_vec2.gd")
	var chunk := "#".repeat(_BOMB_CHUNK).to_utf8_buffer()
	for number in megabytes:
		packer.write_file(chunk)
	packer.close_file()
	packer.close()


func _packer(path: String) -> ZIPPacker:
	var packer := ZIPPacker.new()
	var problem := packer.open(_folder.path_join(path))
	assert(problem == OK, "a zip can be written")
	return packer


func _read(path: String) -> PackedByteArray:
	return _bytes(_folder.path_join(path))


static func _bytes(path: String) -> PackedByteArray:
	return FileAccess.get_file_as_bytes(path)


# A zip whose list says that its first file has another size.
static func _with_size(bytes: PackedByteArray, size: int) -> PackedByteArray:
	bytes.encode_u32(_list_in(bytes) + 24, size)
	return bytes


static func _with_flags(bytes: PackedByteArray, flags: int) -> PackedByteArray:
	bytes.encode_u16(_list_in(bytes) + 8, flags)
	return bytes


# Where the list of a zip begins.
static func _list_in(bytes: PackedByteArray) -> int:
	return bytes.decode_u32(bytes.size() - 6)
