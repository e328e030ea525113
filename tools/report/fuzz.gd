extends SceneTree
## Tries random worlds until the time is over, prints what does not hold, made small, and adds it to
## a list; ends with exit code 1 if there is something.
## Usage: tools/commands/stability.sh --fuzz, which says what can be asked for.

const _LIST := "res://build/fuzz/found.md"
# Names the world that is tried: whoever stops a program that hangs finds it there.
const _TRIED := "res://build/fuzz/tried.txt"
const _MOST_SECONDS_OF_SILENCE := 30
const _NO_KIND := 2

var _minutes := 5.0
var _seed := 0
var _word := ""


func _init() -> void:
	for argument in OS.get_cmdline_user_args():
		if argument.begins_with("--minutes="):
			_minutes = argument.trim_prefix("--minutes=").to_float()
		elif argument.begins_with("--seed="):
			_seed = argument.trim_prefix("--seed=").to_int()
		elif argument.begins_with("--word="):
			_word = argument.trim_prefix("--word=")
	var kinds: Array[FuzzKind] = FuzzRun.all_kinds().filter(
		func(kind: FuzzKind) -> bool: return _word == "" or kind.name.containsn(_word)
	)
	if kinds.is_empty():
		printerr("lab: no kind of worlds has '%s' in its name" % _word)
		quit(_NO_KIND)
		return
	_try(FuzzRun.new(kinds, _seed))


func _try(run: FuzzRun) -> void:
	print("seed %d" % _seed)
	var start := Time.get_ticks_msec()
	var said := start
	while Time.get_ticks_msec() - start < _minutes * 60_000.0:
		_write(_TRIED, "%s %d" % [run.next_kind().name, run.next_number()])
		var find := run.try_next()
		if find:
			print("\n" + find.text())
			_write(_LIST, _list_so_far() + find.text() + "\n")
		elif Time.get_ticks_msec() - said < _MOST_SECONDS_OF_SILENCE * 1000:
			continue
		said = Time.get_ticks_msec()
		print("%d worlds tried, %d of them with a problem" % [run.tried, run.count()])
	print("\n%s\n%s" % [run.figures_text(), run.counts_text()])
	print("seed %d: %d worlds tried, %d with a problem" % [_seed, run.tried, run.count()])
	quit(mini(run.count(), 1))


func _list_so_far() -> String:
	return FileAccess.get_file_as_string(_LIST) if FileAccess.file_exists(_LIST) else ""


func _write(path: String, text: String) -> void:
	var file := FileAccess.open(path, FileAccess.WRITE)
	file.store_string(text)
	file.close()
