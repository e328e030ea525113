class_name FormulaWords
extends RefCounted
## What a lesson's formula holds besides formulas: everything else that [FormulaReader] cannot read
## is an error.

## Words that are passed over, such as `to the segment`.
var words: PackedStringArray = []
## Symbols that the formula uses and does not show. Sides with them cannot be judged.
var not_shown: PackedStringArray = []
## Symbols that stand for another expression: `x` for `v.x`.
var meanings: Dictionary[String, String] = {}
## The lines are code, which [CodeReader] runs, and no formulas.
var is_code := false
## How many digits the numbers of this formula have at least.
var digits := 4


## From a dictionary with the names of the members.
static func of(members: Dictionary) -> FormulaWords:
	var new_words := FormulaWords.new()
	var phrases: Array = members.get("words", [])
	# The longest first: one phrase may begin another.
	phrases = phrases.duplicate()
	phrases.sort_custom(func(one: String, two: String) -> bool: return one.length() > two.length())
	new_words.words = PackedStringArray(phrases)
	var symbols: Array = members.get("not_shown", [])
	new_words.not_shown = PackedStringArray(symbols)
	var meanings_of: Dictionary = members.get("meanings", {})
	new_words.meanings.assign(meanings_of)
	new_words.is_code = members.get("is_code", false)
	new_words.digits = members.get("digits", 4)
	return new_words
