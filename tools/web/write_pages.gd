extends SceneTree
## Writes the index of the exported web demos, the speaker's notes and the rubric, and fills in each
## demo's page: see web_pages.gd.
## Usage: godot --headless --path . -s tools/web/write_pages.gd -- FOLDER [ADDRESS]

const RubricText := preload("rubric_text.gd")
const TeachingPlan := preload("teaching_plan.gd")
const WebDemo := preload("web_demo.gd")
const WebPages := preload("web_pages.gd")

const _FORM := "res://tools/web/index_page.html"
const _NOTES_FORM := "res://tools/web/notes_page.html"
const _ICON := "res://assets/icons/app_icon.svg"
const _ICON_LINK := '<link rel="icon" type="image/svg+xml" href="icon.svg">'
# Where on the site a file of the project can be read.
const _SOURCE := "sources/%s.txt"
# What a browser needs to put the lab among a machine's programs.
const _MANIFEST := "res://tools/web/manifest.webmanifest"

var _site: String
# Where the site will be; "" where that is not known.
var _address := ""
var _failed := 0


func _init() -> void:
	TranslationServer.set_locale(LabText.ENGLISH)
	_site = OS.get_cmdline_user_args()[0]
	if OS.get_cmdline_user_args().size() > 1:
		_address = OS.get_cmdline_user_args()[1]
	var demos: Array[WebDemo] = WebDemo.all().filter(_is_there)
	for place in demos.size():
		_fill_in(demos[place], demos[place + 1] if place + 1 < demos.size() else null)
	_copy_pictures()
	var page := FileAccess.get_file_as_string(_FORM)
	_write("index.html", WebPages.index(page, demos, _engine_bytes(), _address))
	# The notes lead the lab, and so does the rubric.
	if demos[0].id == WebDemo.LAB:
		var notes := FileAccess.get_file_as_string(_NOTES_FORM)
		_write("notes.html", WebPages.notes(notes, TeachingPlan.new()))
		var rubric := RubricText.page("lab/index.html", _SOURCE)
		_write("rubric.html", WebPages.fill(rubric, "icon", _ICON_LINK))
		_copy_sources()
	quit(mini(_failed, 1))


func _is_there(demo: WebDemo) -> bool:
	return FileAccess.file_exists(_site.path_join(demo.id).path_join("index.html"))


func _fill_in(demo: WebDemo, next: WebDemo) -> void:
	var page := demo.id.path_join("index.html")
	var sizes: Dictionary[String, int] = {
		"wasm": FileAccess.get_size(_site.path_join("engine/godot.wasm")),
		"pck": FileAccess.get_size(_site.path_join("%s/%s.pck" % [demo.id, demo.id])),
	}
	var text := FileAccess.get_file_as_string(_site.path_join(page))
	_write(page, WebPages.demo_page(text, demo, next, sizes, _address))


# What travels is the compressed copy.
func _engine_bytes() -> int:
	return FileAccess.get_size(_site.path_join("engine/godot.wasm.gz"))


func _copy_pictures() -> void:
	_check(DirAccess.make_dir_recursive_absolute(_site.path_join("cards")), "cards")
	for lesson in LessonIndex.all():
		_copy(lesson.card_path(), "cards/%s.png" % lesson.id)
	_copy(WebDemo.WORKSHOP_PICTURE, "cards/%s.png" % WebDemo.WORKSHOP)
	_copy(_ICON, "icon.svg")
	_copy(_MANIFEST, "manifest.webmanifest")


# As plain text: a browser then shows them.
func _copy_sources() -> void:
	for path in RubricText.sources():
		var place := _SOURCE % path
		var folder := _site.path_join(place.get_base_dir())
		_check(DirAccess.make_dir_recursive_absolute(folder), folder)
		_copy("res://" + path, place)


func _copy(from: String, to: String) -> void:
	_check(DirAccess.copy_absolute(ProjectSettings.globalize_path(from), _site.path_join(to)), to)


func _write(path: String, text: String) -> void:
	var file := FileAccess.open(_site.path_join(path), FileAccess.WRITE)
	if file:
		file.store_string(text)
	_check(FileAccess.get_open_error(), path)


func _check(error: Error, path: String) -> void:
	if error != OK:
		_failed += 1
		printerr("%s: %s" % [path, error_string(error)])
