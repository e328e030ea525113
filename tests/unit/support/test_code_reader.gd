extends LabTest
## The reader of code finds out what names hold.

const _SHARED: PackedStringArray = [
	"position = Vec2.new(2, −3)",
	"value = Vector2(2, −3)",
	"old = position",
	"old_value = value",
	"position.set_xy( 4 , −4 )",
	"value = Vector2(4, −4)",
]


func test_an_object_is_shared_and_a_value_is_copied() -> void:
	assert_eq(_problems("position (4, −4)   old (4, −4)"), PackedStringArray())
	assert_eq(_problems("value (4, −4)   old_value (2, −3)"), PackedStringArray())
	assert_eq(_problems("position (4, −4)   old (2, −3)"), _told("old (2, −3)", "4.0, not 2.0"))
	assert_eq(_problems("old_value (4, −4)"), _told("old_value (4, −4)", "2.0, not 4.0"))


func test_a_copy_is_an_object_of_its_own() -> void:
	var lines: PackedStringArray = [
		"position = Vec2.new(2, −3)", "old = position.copy()", "position.set_xy( 4 , −4 )"
	]
	lines.append("position (4, −4)   old (2, −3)")
	assert_eq(CodeReader.new().problems(lines), PackedStringArray())
	lines[-1] = "old (4, −4)"
	assert_eq(CodeReader.new().problems(lines).size(), 1)


func test_a_new_object_leaves_the_old_one_to_its_other_name() -> void:
	var lines: PackedStringArray = [
		"position = Vec2.new(2, −3)", "old = position", "position = Vec2.new( 9 , −4 )"
	]
	lines.append("old (9, −4)")
	assert_eq(CodeReader.new().problems(lines), _told("old (9, −4)", "2.0, not 9.0"))


func test_what_it_cannot_read_is_told() -> void:
	assert_eq(_problems("old += position"), _told("old += position", "cannot read it"))
	assert_eq(_problems("new = nobody"), _told("new = nobody", "nothing is called “nobody”"))


func test_a_rounded_number_is_within_half_a_unit() -> void:
	var lines: PackedStringArray = ["a = Vec2.new( 0.3333 , 2 )", "a (0.333333333333, 2)"]
	assert_eq(CodeReader.new().problems(lines), PackedStringArray())
	lines[1] = "a (0.33341, 2)"
	assert_eq(CodeReader.new().problems(lines).size(), 1)


func _problems(line: String) -> PackedStringArray:
	return CodeReader.new().problems(_SHARED + PackedStringArray([line]))


func _told(line: String, what: String) -> PackedStringArray:
	return ["“%s”: %s" % [line, what]]
