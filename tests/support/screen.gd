class_name Screen
## What can be seen on a screen: finds things by the text that a person would look for.


## All visible controls below [param above], itself included, in the order of the tree.
static func controls(above: Node) -> Array[Control]:
	var found: Array[Control] = []
	if above is CanvasItem and not (above as CanvasItem).is_visible_in_tree():
		return found
	if above is Control:
		found.append(above as Control)
	for child: Node in above.get_children():
		found.append_array(controls(child))
	return found


## What a control shows as text, translated; "" for one without.
static func text_of(control: Control) -> String:
	for property: StringName in [&"text", &"title"]:
		if control is not Plot and control is not Handle and property in control:
			var text: String = control.get(property)
			return control.atr(text)
	return ""


## The visible button with this text, or, for one with a picture, with this tooltip; null where
## there is none.
static func button(above: Node, text: String) -> BaseButton:
	for control: Control in controls(above):
		if control is BaseButton and (text_of(control) == text or control.tooltip_text == text):
			return control as BaseButton
	return null


## The field or handle with this name for screen readers; null where there is none.
static func named(above: Node, title: String) -> Control:
	for control: Control in controls(above):
		if control.accessibility_name == title:
			return control
	return null


## Whether some visible label, button or field holds this text, wherever its lines may break.
static func reads(above: Node, text: String) -> bool:
	var wanted := text.replace(Steps.NO_BREAK_SPACE, " ")
	for control: Control in controls(above):
		if text_of(control).replace(Steps.NO_BREAK_SPACE, " ").contains(wanted):
			return true
	return false


## The texts of all visible controls that show one.
static func texts(above: Node) -> PackedStringArray:
	var found: PackedStringArray = []
	for control: Control in controls(above):
		if text_of(control):
			found.append(text_of(control))
	return found


## The text of each line of a formula, its parts put together.
static func lines(formula: Formula) -> PackedStringArray:
	var found: PackedStringArray = []
	for row: Node in formula.get_children():
		found.append("".join(texts(row)))
	return found
