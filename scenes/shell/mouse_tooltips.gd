class_name MouseTooltips
extends Node
## On a screen that can be touched, tooltips are shown only once a mouse has moved: a finger points
## at nothing, and a tooltip at its last touch would lie over the screen.


func _ready() -> void:
	get_tree().node_added.connect(_hide_tooltip)


func _input(event: InputEvent) -> void:
	if event is InputEventMouseMotion and event.device != InputEvent.DEVICE_ID_EMULATION:
		queue_free()


# The engine shows a tooltip after it has added it.
func _hide_tooltip(node: Node) -> void:
	var popup := node as PopupPanel
	if popup and popup.theme_type_variation == &"TooltipPanel":
		popup.hide.call_deferred()
