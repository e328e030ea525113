extends RefCounted
## Notes the emissions of every signal of the watched objects.

## Object -> signal -> list of the emissions' arguments.
var _emissions := {}


func watch(object: Object) -> void:
	if is_watching(object):
		return
	var of_object := {}
	_emissions[object] = of_object
	for info: Dictionary in object.get_signal_list():
		var name: StringName = info["name"]
		of_object[name] = []
		object.connect(name, _note.bind(of_object, name))


func is_watching(object: Object) -> bool:
	return _emissions.has(object)


## The arguments of each emission since watching began.
func emissions(object: Object, name: StringName) -> Array:
	var of_object: Dictionary = _emissions[object]
	return of_object.get(name, [])


## The names of all signals that the object has emitted.
func emitted_by(object: Object) -> PackedStringArray:
	var names := PackedStringArray()
	var of_object: Dictionary = _emissions[object]
	for name: StringName in of_object:
		if of_object[name] != []:
			names.append(name)
	return names


func forget_all() -> void:
	for object: Variant in _emissions:
		if not is_instance_valid(object):
			continue
		var watched: Object = object
		for info: Dictionary in watched.get_signal_list():
			_disconnect(Signal(watched, str(info["name"])))
	_emissions.clear()


func _disconnect(from: Signal) -> void:
	for connection: Dictionary in from.get_connections():
		var callable: Callable = connection["callable"]
		if callable.get_object() == self:
			from.disconnect(callable)


# The emission's own arguments come first, then the two that were bound.
func _note(...arguments: Array) -> void:
	var name: StringName = arguments.pop_back()
	var of_object: Dictionary = arguments.pop_back()
	var emissions_of_signal: Array = of_object[name]
	emissions_of_signal.append(arguments)
