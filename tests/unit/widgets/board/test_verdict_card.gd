extends LabTest
## How the words of a verdict wrap.


func test_no_short_word_of_a_verdict_is_left_alone_in_a_line() -> void:
	var scene := load("res://scenes/widgets/board/verdict_card.tscn") as PackedScene
	var card := scene.instantiate() as VerdictCard
	add_child_autofree(card)
	var words: PackedStringArray = [
		"a · b̂ = −1.0000000050247593e−08 px", "but the gap to the segment is 35 px"
	]
	card.show_verdict("+", Palette.Role.WRONG, words)
	var lines := (card.get_node("%Words") as Label).text.split("\n")
	assert_eq(lines.size(), 2)
	assert_string_contains(lines[0], "= −1", "a line can still break before a long number")
	for i in lines.size():
		assert_true(lines[i].ends_with("\u00a0px"), lines[i])
		assert_eq(lines[i].replace("\u00a0", " "), words[i])
