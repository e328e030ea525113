class_name KeptChoices
extends RefCounted
## What the student has chosen for the whole lab, such as a language: kept for the next time.

const _SECTION := "choices"

## Where it is kept. Tests have a file of their own.
static var file := "user://choices.cfg"

# Null until it has been read.
static var _kept: ConfigFile


## What was chosen for [param key]; [param otherwise] where nothing was.
static func value(key: String, otherwise: Variant) -> Variant:
	return _read().get_value(_SECTION, key, otherwise)


## Keeps a choice from now on. Where nothing can be written it holds until the lab is closed.
static func keep(key: String, chosen: Variant) -> void:
	_read().set_value(_SECTION, key, chosen)
	_kept.save(file)


## From now on nothing has been chosen for [param key].
static func forget(key: String) -> void:
	if _read().has_section_key(_SECTION, key):
		_kept.erase_section_key(_SECTION, key)
		_kept.save(file)


## Reads [member file] anew when something is asked next: what was chosen is as it was kept there.
static func read_again() -> void:
	_kept = null


static func _read() -> ConfigFile:
	if not _kept:
		_kept = ConfigFile.new()
		if FileAccess.file_exists(file):
			_kept.load(file)
	return _kept
