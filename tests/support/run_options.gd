class_name RunOptions
extends RefCounted
## What the command line asked the test runner for.


## The values of an option such as `-gtest`, written `-gtest=a,b` or `-gtest a`; empty when it was
## not given.
static func values_of(option: String) -> PackedStringArray:
	var values := PackedStringArray()
	var arguments := OS.get_cmdline_args()
	for index: int in arguments.size():
		if arguments[index].begins_with(option + "="):
			values.append_array(arguments[index].trim_prefix(option + "=").split(",", false))
		elif arguments[index] == option and index + 1 < arguments.size():
			values.append_array(arguments[index + 1].split(",", false))
	return values


## True when the script at [param path] belongs to what `-gselect`, `-gtest`, `-gdir` and
## `-ginner_class` ask for; without them every script does.
static func asks_for(path: String) -> bool:
	if not values_of("-ginner_class").is_empty():
		return false
	for part: String in values_of("-gselect"):
		if not path.get_file().contains(part):
			return false
	var places := values_of("-gtest") + values_of("-gdir")
	for place: String in places:
		if path.begins_with(place):
			return true
	return places.is_empty()
