extends RefCounted
## A file of texts in gettext's form: what the lab shows, with its translation and where it stands.

const _HEADER := """# %s
msgid ""
msgstr ""
"Project-Id-Version: Vec2 Lab\\n"
"Language: %s\\n"
"MIME-Version: 1.0\\n"
"Content-Type: text/plain; charset=UTF-8\\n"
"Content-Transfer-Encoding: 8bit\\n"
"""
const _QUOTED := '"((?:[^"\\\\]|\\\\.)*)"'

## What the first line says of the file.
var title := ""
## The language's code, such as `nl`.
var language := ""
## The translation of each text, in the order of the file; "" where there is none yet.
var translations: Dictionary[String, String] = {}
## The files that show each text.
var places: Dictionary[String, PackedStringArray] = {}


## The file at [param path]; an empty one without.
func _init(path: String = "") -> void:
	if path:
		_read(FileAccess.get_file_as_string(path))


## The whole file as a text.
func text() -> String:
	var parts: PackedStringArray = [_HEADER % [title, language]]
	for message in translations:
		var found_in := "\n#: ".join(places[message])
		var lines := [found_in, _escaped(message), _escaped(translations[message])]
		parts.append('#: %s\nmsgid "%s"\nmsgstr "%s"\n' % lines)
	return "\n".join(parts)


## The same as the engine has it when it runs, without the places and the texts that have no
## translation.
func translation() -> Translation:
	var made := Translation.new()
	made.locale = language
	for message in translations:
		if translations[message]:
			made.add_message(message, translations[message])
	return made


static func _escaped(plain: String) -> String:
	return plain.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n")


func _read(content: String) -> void:
	title = content.get_slice("\n", 0).trim_prefix("# ")
	for entry in content.split("\n\n", false):
		var message := _quoted_after("msgid ", entry)
		var translated := _quoted_after("msgstr ", entry)
		if message:
			translations[message] = translated
			places[message] = PackedStringArray()
			for line in entry.split("\n"):
				if line.begins_with("#: "):
					places[message].append(line.trim_prefix("#: "))
		else:
			for line in translated.split("\n"):
				if line.begins_with("Language: "):
					language = line.trim_prefix("Language: ")


# All quoted texts from a keyword on to the next one, joined.
static func _quoted_after(keyword: String, entry: String) -> String:
	var found := ""
	var is_inside := false
	for line in entry.split("\n"):
		if line.begins_with(keyword):
			is_inside = true
		elif not line.begins_with('"'):
			is_inside = false
		if is_inside:
			var hit := RegEx.create_from_string(_QUOTED).search(line)
			var text_of_line: String = str_to_var('"%s"' % hit.get_string(1)) if hit else ""
			found += text_of_line
	return found
