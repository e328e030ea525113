extends ScreenTest
## Each lesson moves within two seconds after it was opened, and goes on; where motion is reduced,
## it stays as it starts.

const _WITHIN := 2.0
# A frame counts for no more seconds than this, as in OpeningMotion: the first ones may take long.
const _LONGEST_FRAME := 0.1
## So many sights, one after another, are no single twitch.
const _SIGHTS := 4
const _STILL_FRAMES := 20
## Measures at the start: what moves there are figures, and they come also where motion is reduced.
const _MEASURES := &"error_and_time"

# The names of the variables of each script.
var _variables: Dictionary[Script, PackedStringArray] = {}


func after_each() -> void:
	OpeningMotion.is_allowed = false
	await super()


func test_a_lesson_moves_within_two_seconds(id: StringName = use_parameters(_ids())) -> void:
	OpeningMotion.is_allowed = true
	Motion.reduce(false)
	await open_lesson(LessonIndex.find(id))
	var seconds := 0.0
	var sights: Dictionary[String, bool] = {}
	while sights.size() < _SIGHTS and seconds < _WITHIN:
		sights[_sight()] = true
		await get_tree().process_frame
		seconds += minf(get_process_delta_time(), _LONGEST_FRAME)
	assert_eq(sights.size(), _SIGHTS, "%s is seen to move" % id)


func test_where_motion_is_reduced_a_lesson_stays(id: StringName = use_parameters(_ids())) -> void:
	OpeningMotion.is_allowed = true
	Motion.reduce(true)
	await open_lesson(LessonIndex.find(id))
	var first := _sight()
	for frame_number: int in _STILL_FRAMES:
		await get_tree().process_frame
	assert_eq(_sight() == first, id != _MEASURES, "%s stays" % id)


func _ids() -> Array[StringName]:
	var ids: Array[StringName] = []
	for info in LessonIndex.lessons():
		ids.append(info.id)
	return ids


# What is drawn on the board depends on this, and what the panel says.
func _sight() -> String:
	var seen := Screen.texts(frame().get_node("%Services"))
	for node: Node in frame().lesson.find_children("*", "CanvasItem", true, false):
		var item := node as CanvasItem
		if item.is_visible_in_tree():
			seen.append(str(item.get_global_transform()))
			seen.append_array(_numbers_in(item))
	return "\n".join(seen)


func _numbers_in(item: CanvasItem) -> PackedStringArray:
	var found: PackedStringArray = []
	for variable: String in _variables_of(item):
		var value: Variant = item.get(variable)
		if value is Vec2:
			var vector: Vec2 = value
			found.append(str(vector.to_vector2()))
		elif typeof(value) < TYPE_OBJECT or typeof(value) >= TYPE_PACKED_BYTE_ARRAY:
			found.append(str(value))
	return found


func _variables_of(item: CanvasItem) -> PackedStringArray:
	var script: Script = item.get_script()
	if not script:
		return []
	if not _variables.has(script):
		var names: PackedStringArray = []
		for property: Dictionary in item.get_property_list():
			if property["usage"] & PROPERTY_USAGE_SCRIPT_VARIABLE:
				names.append(str(property["name"]))
		_variables[script] = names
	return _variables[script]
