extends ScreenTest
## Play, pause, step and slow in a lesson that only counts the seconds.

const _CLOCK := preload("res://tests/support/lessons/clock.tres")
const _FRAME_SECONDS := 1.0 / 60.0


func before_each() -> void:
	super()
	await open_lesson(_CLOCK)


func test_time_stands_still_at_first() -> void:
	assert_eq(_seconds(), 0.0)


func test_play_lets_time_pass_and_pause_stops_it() -> void:
	await click_button("Play or pause")
	assert_gt(_seconds(), 0.0)
	await click_button("Play or pause")
	var stopped := _seconds()
	await student.settle()
	assert_eq(_seconds(), stopped)


func test_the_key_for_pause_plays_and_pauses() -> void:
	await student.press(&"lab_pause")
	assert_gt(_seconds(), 0.0)
	await student.press(&"lab_pause")
	var stopped := _seconds()
	await student.settle()
	assert_eq(_seconds(), stopped)


func test_start_on_the_gamepad_plays() -> void:
	await student.press_pad(JOY_BUTTON_START)
	assert_gt(_seconds(), 0.0)


func test_one_frame_on_and_one_frame_back() -> void:
	await click_button("One frame on")
	assert_almost_eq(_seconds(), _FRAME_SECONDS, 1e-12)
	await click_button("One frame back")
	assert_almost_eq(_seconds(), 0.0, 1e-12)


func test_a_single_step_pauses() -> void:
	await click_button("Play or pause")
	await click_button("One frame on")
	assert_false(_transport().is_playing)
	var stopped := _seconds()
	await student.settle()
	assert_eq(_seconds(), stopped)


# The test itself says how much time has passed, so that no clock is involved.
func test_slow_motion_runs_at_a_fifth() -> void:
	watch_signals(_transport())
	_transport()._process(1.0)
	assert_signal_emitted_with_parameters(_transport(), "advanced", [1.0])
	await click_button("Slow motion")
	_transport()._process(1.0)
	assert_signal_emitted_with_parameters(_transport(), "advanced", [0.2])


func test_the_key_for_slow_switches_slow_motion() -> void:
	var slow := Screen.button(screen(), "Slow motion")
	await student.press(&"lab_slow")
	assert_true(slow.button_pressed)
	await student.press(&"lab_slow")
	assert_false(slow.button_pressed)


func test_play_shows_a_pause_sign_while_time_runs_and_only_then() -> void:
	var play := Screen.button(screen(), "Play or pause") as Button
	var play_sign := play.icon
	for switch: Callable in [student.press.bind(&"lab_pause"), click_button.bind("Play or pause")]:
		await switch.call()
		assert_true(play.icon.resource_path.ends_with("pause.svg"), play.icon.resource_path)
		await switch.call()
		assert_same(play.icon, play_sign)
	await student.press(&"lab_pause")
	frame().lesson.pause()
	assert_same(play.icon, play_sign, "also where something else stops it")


func test_keys_go_one_frame_on_and_back() -> void:
	await student.press(&"lab_next_frame")
	assert_almost_eq(_seconds(), _FRAME_SECONDS, 1e-12)
	await student.press(&"lab_previous_frame")
	assert_almost_eq(_seconds(), 0.0, 1e-12)


func test_a_flight_stops_when_its_end_was_shown_and_play_begins_it_anew() -> void:
	var transport := _transport()
	var flown: PackedFloat64Array = [0.5]
	var shown_while_playing: Array[bool] = []
	transport.advanced.connect(
		func(seconds: float) -> void:
			flown[0] = transport.flown(flown[0], seconds, 1.0)
			shown_while_playing.append(transport.is_playing)
	)
	transport.is_playing = true
	transport._process(0.25)
	assert_eq(flown[0], 0.75)
	assert_true(transport.is_playing)
	transport._process(2.0)
	assert_eq(flown[0], 1.0)
	assert_eq(shown_while_playing, [true, true], "the end is shown before time stops")
	assert_false(transport.is_playing)
	transport.is_playing = true
	transport._process(0.25)
	assert_eq(flown[0], 0.25, "played on from its end it begins anew")
	transport.is_playing = false
	await click_button("One frame back")
	assert_almost_eq(flown[0], 0.25 - _FRAME_SECONDS, 1e-12)


func test_a_flight_goes_back_to_its_beginning_at_most() -> void:
	assert_eq(_transport().flown(-0.5, -3.0, 2.0, -1.0), -1.0)
	assert_eq(_transport().flown(0.5, -3.0, 2.0), 0.0)


func _transport() -> Transport:
	return frame().lesson.services[&"transport"] as Transport


func _seconds() -> float:
	var seconds: float = frame().lesson.state()["seconds"]
	return seconds
