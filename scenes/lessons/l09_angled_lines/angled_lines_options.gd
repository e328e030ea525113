class_name AngledLinesOptions
extends RefCounted
## The options of the lesson on angled lines: the way of stepping, the scene, trails, Godot's body.

var _options: LessonOptions


## Adds them to [param options].
func _init(options: LessonOptions) -> void:
	_options = options
	options.add_choice("method", tr("How a frame is stepped"), AngledLinesTexts.methods())
	options.add_choice("kind", tr("The kind of line"), AngledLinesTexts.kinds_of_line())
	options.add_switch("trails", tr("Trails"))
	options.add_switch("engine", tr("Godot"))
	options.add_choice("scene", tr("The scene to which R goes back"), AngledLinesTexts.scenes())


## Puts into [param model] what was chosen from the list [param key]. "" or one sentence on why it
## cannot be.
static func choose(key: String, place: int, model: AngledLinesModel) -> String:
	match key:
		"scene":
			model.set_up(place)
		"kind":
			model.set_endless_lines(place == 1)
		"method":
			return model.set_method(place as SteppingMethods.Method)
	return ""


## Shows what is chosen and switched on.
func show_model(model: AngledLinesModel, has_trails: bool, has_engine: bool) -> void:
	_options.show_choice("method", model.method)
	_options.show_choice("kind", int(model.has_endless_lines))
	_options.show_choice("scene", model.preset)
	_options.show_switch("trails", has_trails)
	_options.show_switch("engine", has_engine)
