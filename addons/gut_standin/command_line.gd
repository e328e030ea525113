extends RefCounted
## What to run: `res://.gutconfig.json`, overridden by the command line.

const CONFIG := "res://.gutconfig.json"
## Option on the command line -> key in the configuration file.
const KEYS := {
	"-gdir": "dirs",
	"-gtest": "tests",
	"-gselect": "selected",
	"-gunit_test_name": "unit_test_name",
	"-ginner_class": "inner_class",
	"-ginclude_subdirs": "include_subdirs",
	"-gprefix": "prefix",
	"-gsuffix": "suffix",
	"-gpre_run_script": "pre_run_script",
	"-gpost_run_script": "post_run_script",
	"-gjunit_xml_file": "junit_xml_file",
}
## Understood, and of no effect here.
const IGNORED: PackedStringArray = [
	"-gexit", "-gexit_on_success", "-gdisable_colors", "-glog", "-gconfig"
]

var values := {
	"dirs": [],
	"tests": [],
	"selected": "",
	"unit_test_name": "",
	"inner_class": "",
	"include_subdirs": false,
	"prefix": "test_",
	"suffix": ".gd",
	"pre_run_script": "",
	"post_run_script": "",
	"junit_xml_file": "",
}
## What was asked for wrongly; empty when all is well.
var mistake := ""


func _init() -> void:
	_read_config()
	_read_command_line()


## True when the text at [param key] is not set, or [param whole] contains it.
func admits(key: String, whole: String) -> bool:
	return text(key).is_empty() or whole.contains(text(key))


func text(key: String) -> String:
	return values[key]


func texts(key: String) -> PackedStringArray:
	var list: Array = values[key]
	return PackedStringArray(list)


func flag(key: String) -> bool:
	return values[key]


func _read_config() -> void:
	if not FileAccess.file_exists(CONFIG):
		return
	var read: Variant = JSON.parse_string(FileAccess.get_file_as_string(CONFIG))
	if read is not Dictionary:
		mistake = "%s holds no JSON object" % CONFIG
		return
	var config: Dictionary = read
	for key: String in values:
		values[key] = config.get(key, values[key])


func _read_command_line() -> void:
	var arguments := Array(OS.get_cmdline_args())
	var given := {}
	while not arguments.is_empty():
		var argument: String = arguments.pop_front()
		var option := argument.get_slice("=", 0)
		if KEYS.has(option):
			var key: String = KEYS[option]
			_take(key, argument, arguments, given)
		elif option.begins_with("-g") and option not in IGNORED:
			mistake = "Unknown arguments: %s" % argument


# A list may be given in several pieces; the first one replaces what the configuration says.
func _take(key: String, argument: String, arguments: Array, given: Dictionary) -> void:
	if values[key] is bool:
		values[key] = true
		return
	var value := argument.get_slice("=", 1)
	if not argument.contains("="):
		value = arguments.pop_front()
	if values[key] is String:
		values[key] = value
		return
	var list: Array = given.get_or_add(key, [])
	list.append_array(Array(value.split(",")))
	values[key] = list
