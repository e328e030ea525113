extends SceneTree
## The command line of the stand-in, with GUT's options.

const CommandLine := preload("command_line.gd")
const Runner := preload("gut_main.gd")


func _init() -> void:
	print("This is NOT GUT but its small stand-in: it knows what Vec2 Lab's tests use.")
	var options := CommandLine.new()
	if not options.mistake.is_empty():
		print(options.mistake)
		quit(1)
		return
	# The tree is complete from the first frame on.
	await process_frame
	var gut := Runner.new()
	gut.options = options
	root.add_child(gut)
	quit(await gut.run())
