extends Node
## What F6 on the workshop's scene runs: it opens the workshop as its card on the start screen does.


func _ready() -> void:
	WorkshopWays.open_next(get_tree())
