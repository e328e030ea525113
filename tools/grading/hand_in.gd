extends RefCounted
## One hand-in on its way: its files are found, copied into a home of their own, and judged there.

const HandInFiles := preload("hand_in_files.gd")
const Judging := preload("judging.gd")
const HandInRow := preload("hand_in_row.gd")

# The word for each kind of verdict in a cell.
const _WORDS: Dictionary[WorkshopVerdict.Kind, String] = {
	WorkshopVerdict.Kind.OPEN: "open",
	WorkshopVerdict.Kind.RIGHT: "right",
	WorkshopVerdict.Kind.MISTAKE: "wrong",
	WorkshopVerdict.Kind.UNKNOWN: "wrong",
	WorkshopVerdict.Kind.UNREADABLE: "form",
	WorkshopVerdict.Kind.BROKEN: "stopped",
	WorkshopVerdict.Kind.ENDLESS: "endless",
	WorkshopVerdict.Kind.MEMORY: "memory",
	WorkshopVerdict.Kind.REFUSED: HandInRow.BY_HAND,
	WorkshopVerdict.Kind.MISSING: "missing",
	WorkshopVerdict.Kind.WAITING: "waits",
	WorkshopVerdict.Kind.CRASHED: "crashed",
}
# Less code than this can be the same by chance.
const _LEAST_TOKENS := 150

## What is told of it so far: its name and the checksum of its files, at the end all.
var row := HandInRow.new()

var _files: HandInFiles
var _home := ""
var _judging: Judging
var _begun := 0


## The hand-in at [param path]; [param rules] is a checksum of what it is judged by.
func _init(path: String, rules: String) -> void:
	_begun = Time.get_ticks_msec()
	_files = HandInFiles.new(path)
	row.name = HandInRow.plain(path.get_file())
	row.note = HandInRow.plain(" ".join(_files.problems))
	row.sum = _sum(rules)


## Begins to judge it; everything that is written is in [param home].
func begin(home: String) -> void:
	_home = home
	var folder := home.path_join("hand_in")
	DirAccess.make_dir_recursive_absolute(folder)
	for name in _files.files:
		FileAccess.open(folder.path_join(name), FileAccess.WRITE).store_buffer(_files.files[name])
	if _files.files:
		_judging = Judging.new(folder, home)
		_judging.begin()


## Goes on with it; whether it is through. Its row is complete then, and its home is gone.
func look() -> bool:
	if _judging and not _judging.look():
		return false
	if _judging:
		_fill_row()
	row.seconds = (Time.get_ticks_msec() - _begun) / 1000.0
	_remove(_home)
	return true


func _fill_row() -> void:
	var report := _judging.report
	row.mark = WorkshopReport.name_of(report.mark())
	for number in report.verdicts:
		row.cells[number] = HandInRow.plain(_cell(report.verdicts[number]))
		# It was not run, so nothing is known of what it is worth.
		if report.verdicts[number].kind == WorkshopVerdict.Kind.REFUSED:
			row.mark = HandInRow.BY_HAND
	if report.tests:
		var sentence := report.tests.sentence()
		var share := "%d of %d: " % [report.tests.found.size(), _wrong_ways(report.tests)]
		row.tests = HandInRow.plain(share + sentence)
	if _judging.tokens >= _LEAST_TOKENS:
		row.shape = _judging.shape


static func _cell(verdict: WorkshopVerdict) -> String:
	var word := _WORDS[verdict.kind]
	if verdict.mistake > 0:
		word = "mistake %d" % verdict.mistake
	if verdict.is_right() or verdict.kind == WorkshopVerdict.Kind.OPEN:
		return word
	var place := " (%s, line %d)" % [verdict.file, verdict.line] if verdict.line > 0 else ""
	return "%s: %s%s" % [word, verdict.sentence, place]


static func _wrong_ways(tests: WorkshopTestsVerdict) -> int:
	return tests.found.size() + tests.missed.size()


func _sum(rules: String) -> String:
	var hashing := HashingContext.new()
	var problem := hashing.start(HashingContext.HASH_SHA256)
	assert(problem == OK, "the engine knows SHA-256")
	hashing.update((rules + row.note).to_utf8_buffer())
	for name in _files.files:
		hashing.update(("\n%s\n" % name).to_utf8_buffer())
		if _files.files[name]:
			hashing.update(_files.files[name])
	return hashing.finish().hex_encode().left(16)


static func _remove(folder: String) -> void:
	for name in DirAccess.get_directories_at(folder):
		_remove(folder.path_join(name))
	for name in DirAccess.get_files_at(folder):
		DirAccess.remove_absolute(folder.path_join(name))
	DirAccess.remove_absolute(folder)
