extends RefCounted
## The table of a class as Markdown, and what can be said of all hand-ins together.

const HandInRow := preload("hand_in_row.gd")

# The short form of a word in a cell of the table.
const _SIGNS: Dictionary[String, String] = {"right": "✓", "open": "–", "wrong": "✗", "": ""}
const _NO_MISTAKES: PackedStringArray = ["right", "open", "missing", "waits"]
# What is wrong with a file is said for each exercise in it, and counts once.
const _OF_FILE: PackedStringArray = ["form", HandInRow.BY_HAND]


## What stands above the rows.
static func head() -> String:
	var heads: PackedStringArray = ["hand-in", "mark", "right"]
	for number in HandInRow.exercises():
		heads.append(str(number))
	heads.append_array(["tests", "note"])
	return (
		"# Hand-ins\n\n"
		+ "✓ right, – not begun, ✗ wrong; the other words are in docs/teaching.md. The sentences are "
		+ "in results.csv.\n\n"
		+ "| %s |\n|%s\n" % [" | ".join(heads), "---|".repeat(heads.size())]
	)


## A row of the table.
static func row_text(row: HandInRow) -> String:
	var cells: PackedStringArray = [_escaped(row.name), row.mark, str(row.right())]
	if not row.mark:
		cells = [_escaped(row.name), "not judged", ""]
	for number in HandInRow.exercises():
		var word := row.word(number)
		cells.append(_SIGNS[word] if _SIGNS.has(word) else word.trim_prefix("mistake "))
	var notes := row.note
	if row.same_as:
		notes = "Same code as %s. %s" % [row.same_shortly(), notes]
	cells.append_array([row.tests.get_slice(":", 0), _escaped(notes.strip_edges())])
	return "| %s |" % " | ".join(cells)


## What can be said of all: marks, exercises, mistakes, and what is to be looked at.
static func text_of(rows: Array[HandInRow]) -> String:
	return (
		"\n## The class\n\n"
		+ "%d hand-ins. %s\n" % [rows.size(), _marks(rows)]
		+ _exercises(rows)
		+ _mistakes(rows)
		+ _to_look_at(rows)
	)


static func _marks(rows: Array[HandInRow]) -> String:
	var counts: Dictionary[String, int] = {}
	for row in rows:
		_count(counts, row.mark if row.mark else "not judged")
	var told: PackedStringArray = []
	for mark in counts:
		told.append("%s: %d" % [mark, counts[mark]])
	return ", ".join(told)


static func _exercises(rows: Array[HandInRow]) -> String:
	var text := "\n| exercise | right | wrong | missing, waits | not begun |\n|---|---|---|---|---|\n"
	for number in HandInRow.exercises():
		var counts: Dictionary[String, int] = {}
		for row in rows:
			_count(counts, row.word(number))
		var right: int = counts.get("right", 0)
		var open: int = counts.get("open", 0)
		var missing: int = counts.get("missing", 0) + counts.get("waits", 0)
		var wrong: int = rows.size() - right - open - missing - counts.get("", 0)
		var title := WorkshopIndex.exercise(number).title
		text += "| %d %s | %d | %d | %d | %d |\n" % [number, title, right, wrong, missing, open]
	return text


static func _mistakes(rows: Array[HandInRow]) -> String:
	var counts: Dictionary[String, int] = {}
	for row in rows:
		var told_once: Dictionary[String, bool] = {}
		for number in row.cells:
			if not row.word(number) in _NO_MISTAKES:
				var is_of_file := row.word(number) in _OF_FILE
				var what := _escaped(_without_place(row.cells[number]))
				told_once["%s | %s" % ["" if is_of_file else str(number), what]] = true
		for told in told_once:
			_count(counts, told)
	if not counts:
		return ""
	var sorted := counts.keys()
	sorted.sort_custom(
		func(one: String, other: String) -> bool:
			return counts[one] > counts[other] or (counts[one] == counts[other] and one < other)
	)
	var text := "\n| how often | exercise | what |\n|---|---|---|\n"
	for line: String in sorted:
		text += "| %d | %s |\n" % [counts[line], line]
	return text


static func _to_look_at(rows: Array[HandInRow]) -> String:
	var text := ""
	for row in rows:
		var by_hand: PackedStringArray = []
		for number in row.cells:
			if row.word(number) == HandInRow.BY_HAND:
				by_hand.append(str(number))
		if by_hand:
			text += "- %s: look by hand at %s\n" % [_escaped(row.name), ", ".join(by_hand)]
		if not row.mark:
			text += "- %s: not judged. %s\n" % [_escaped(row.name), _escaped(row.note)]
		if row.same_as:
			text += "- %s: same code as %s\n" % [_escaped(row.name), _escaped(row.same_shortly())]
	return "\nTo look at:\n\n" + text if text else ""


static func _count(counts: Dictionary[String, int], what: String) -> void:
	counts[what] = counts.get(what, 0) + 1


static func _without_place(cell: String) -> String:
	return RegEx.create_from_string(r" \(my_\w+\.gd, line \d+\)$").sub(cell, "")


static func _escaped(text: String) -> String:
	return RegEx.create_from_string(r"([\\|<>`*_\[\]])").sub(text, "\\$1", true)
