extends SceneTree
## A lab with nothing but the watcher of the workshop: tests kill it. Prints the number of its child
## when that runs his code.


func _initialize() -> void:
	var watcher := WorkshopWatcher.new()
	watcher.folder = OS.get_cmdline_user_args()[0]
	root.add_child(watcher)
	await watcher.began
	await create_timer(1.0).timeout
	print("child %d" % watcher.child_id())
