extends SceneTree
## Starts the lab as a user does, saves what is drawn, and fails when that is blank, or when the
## window shows something else after a menu was open over it.
## Usage: godot --path . --resolution 1280x720 --fixed-fps 60 -s tools/draw/draw_picture.gd
## -- --picture=FILE [--lesson=ID] [--card] [--check-window] [--opening]
## [--press=ACTION[*TIMES],...]

const CardPicture := preload("card_picture.gd")

## Half a second: what is laid out has its place.
const FRAMES := 30
## What a link or a key has a step turn or move over a second has arrived.
const FRAMES_TO_ARRIVE := 90
const FEWEST_COLORS := 16
const ARGUMENT := "--picture="
## Draws what a lesson's card shows; see card_picture.gd.
const CARD := "--card"
## Also look at the window: on a screen on which nothing else is.
const CHECK_WINDOW := "--check-window"
## Lets the lesson's opening move; else the picture shows the lesson as it starts.
const OPENING := "--opening"
## Presses the keys of these actions first, in turn: `--press=lab_next_step*3,lab_hide_answers`.
const PRESS := "--press="
## Whoever draws pictures has chosen nothing and seen nothing; it is forgotten again.
const CHOICES := "user://choices_in_pictures.cfg"
## What may differ in the window: numbers that change while a lesson works by itself.
const MOST_DIFFERING := 0.05


func _init() -> void:
	var main_scene: String = ProjectSettings.get_setting("application/run/main_scene")
	KeptChoices.file = CHOICES
	OpeningMotion.is_allowed = OPENING in OS.get_cmdline_user_args()
	if CARD in OS.get_cmdline_user_args():
		CardPicture.hide_text()
	change_scene_to_file(main_scene)
	for frame: int in FRAMES_TO_ARRIVE:
		await process_frame
	await _press_all()
	if CARD in OS.get_cmdline_user_args():
		CardPicture.show_board_alone(current_scene as LessonFrame)
		for frame: int in FRAMES:
			await process_frame
	await RenderingServer.frame_post_draw
	var picture := root.get_texture().get_image()
	var colors := _count_colors(picture)
	print("%dx%d, %d colors" % [picture.get_width(), picture.get_height(), colors])
	var saved := picture.save_png(_path())
	var is_drawn := colors >= FEWEST_COLORS and picture.get_size() == root.size
	if picture.detect_alpha() != Image.ALPHA_NONE:
		print("the picture has holes: something does not fill the window")
		is_drawn = false
	var is_shown := await _is_shown_again(picture)
	DirAccess.remove_absolute(CHOICES)
	quit(0 if saved == OK and is_drawn and is_shown else 1)


func _path() -> String:
	for argument: String in OS.get_cmdline_user_args():
		if argument.begins_with(ARGUMENT):
			return argument.trim_prefix(ARGUMENT)
	return ""


func _press_all() -> void:
	for argument: String in OS.get_cmdline_user_args():
		if argument.begins_with(PRESS):
			for part: String in argument.trim_prefix(PRESS).split(","):
				for time: int in maxi(part.get_slice("*", 1).to_int(), 1):
					await _press(part.get_slice("*", 0))
			for frame: int in FRAMES_TO_ARRIVE:
				await process_frame


# A picture stays in its lesson: the step behind the last one would lead on.
func _press(action: StringName) -> void:
	if action == &"lab_next_step" and _is_at_last_step():
		return
	var key := InputMap.action_get_events(action)[0].duplicate() as InputEventKey
	for is_down: bool in [true, false]:
		key.pressed = is_down
		root.push_input(key)
	await process_frame


# Behind it the key leads to the next lesson, which is another picture.
func _is_at_last_step() -> bool:
	var frame := current_scene as LessonFrame
	var steps: Steps = frame.lesson.services.get(&"steps") if frame and frame.lesson else null
	return steps != null and steps.is_at_end()


# Where a processor draws, pictures that do not change stay on the screen: see SoftwareDrawing.
func _is_shown_again(picture: Image) -> bool:
	if not CHECK_WINDOW in OS.get_cmdline_user_args() or not SoftwareDrawing.is_on:
		return true
	await _cover_for_a_moment()
	for frame: int in FRAMES:
		await process_frame
	var window := Rect2i(root.position, root.size)
	var differing := _share_differing(picture, DisplayServer.screen_get_image(0).get_region(window))
	if differing > MOST_DIFFERING:
		print("%.1f %% of the pixels in the window differ" % (differing * 100.0))
	return differing <= MOST_DIFFERING


# A menu or tooltip that comes and goes leaves nothing behind.
func _cover_for_a_moment() -> void:
	for frame: int in FRAMES:
		await process_frame
	var cover := PopupPanel.new()
	root.add_child(cover)
	cover.popup(Rect2i(Vector2i.ZERO, root.size))
	for frame: int in FRAMES:
		await process_frame
	cover.free()


func _share_differing(picture: Image, other: Image) -> float:
	var differing := 0
	var count := 0
	for y: int in range(0, picture.get_height(), 3):
		for x: int in range(0, picture.get_width(), 3):
			var change := picture.get_pixel(x, y) - other.get_pixel(x, y)
			count += 1
			if maxf(absf(change.r), maxf(absf(change.g), absf(change.b))) > 0.06:
				differing += 1
	return float(differing) / count


## Of every fourth pixel in each direction.
func _count_colors(picture: Image) -> int:
	var seen := {}
	for y: int in range(0, picture.get_height(), 4):
		for x: int in range(0, picture.get_width(), 4):
			seen[picture.get_pixel(x, y)] = true
	return seen.size()
