extends RefCounted
## Reads the text of a script: the names that it uses and the strings that it holds, comments left
## out.

## A string in one of its forms, or a comment; only the inside of a string is captured.
const _STRING_OR_COMMENT := (
	r'(?s)"""(.*?)"""|' + r"'''(.*?)'''|" + r'"((?:\\.|[^"\\])*)"|' + r"'((?:\\.|[^'\\])*)'|#[^\n]*"
)
## A name; after `%`, `$`, `/` or a dot it is a node's or a member's.
const _NAME := r"(?<![\w%$/.])[A-Za-z_]\w*"


## The names in [param code], each once.
static func names_in(code: String) -> PackedStringArray:
	var found: Dictionary[String, bool] = {}
	var bare := RegEx.create_from_string(_STRING_OR_COMMENT).sub(code, " ", true)
	for hit: RegExMatch in RegEx.create_from_string(_NAME).search_all(bare):
		found[hit.get_string()] = true
	return PackedStringArray(found.keys())


## The strings in [param code], as they are written.
static func strings_in(code: String) -> PackedStringArray:
	var found: PackedStringArray = []
	for hit: RegExMatch in RegEx.create_from_string(_STRING_OR_COMMENT).search_all(code):
		if not hit.get_string().begins_with("#"):
			found.append("".join(hit.strings.slice(1)))
	return found
