extends SceneTree
## What stepping balls among angled lines costs, in each way of stepping; and ten minutes of it
## without a break, in which nothing may be lost.
##
## Run with: godot --headless --path . -s benchmarks/angled_lines.gd
## [br][br]
## The situations are those of the lesson. A time is the median of the frames; the soak is 36 000
## frames as fast as the machine makes them. Ends with exit code 1 where a ball was lost, a number
## is not finite, or objects are left over.

const FRAME := 1.0 / 60.0
const FRAMES := 600
const SOAK_FRAMES := 36000

## The lesson's situations with 1, 10 and 50 balls.
const SITUATIONS: Dictionary[int, int] = {1: 0, 10: 7, 50: 8}


func _init() -> void:
	print("Milliseconds of script per frame (median of %d), share of 1/60 s\n" % FRAMES)
	print("| balls | lines | position reset | rest dropped | rest used | event world |")
	print("|---|---|---|---|---|---|")
	for count: int in SITUATIONS:
		_print_row(count)
	quit(0 if _soak() else 1)


func _print_row(count: int) -> void:
	var cells: PackedStringArray = [str(count), str(_world(count).surroundings.segments.size())]
	for method: int in SteppingMethods.Method.size():
		var milliseconds := _median(count, method as SteppingMethods.Method)
		cells.append("%.3f = %.1f %%" % [milliseconds, milliseconds / FRAME / 10.0])
	print("| %s |" % " | ".join(cells))


func _median(count: int, method: SteppingMethods.Method) -> float:
	var world := _world(count)
	world.mover = SteppingMethods.mover_of(method)
	var times: PackedFloat64Array = []
	for frame: int in FRAMES:
		var start := Time.get_ticks_usec()
		var problem := world.step(FRAME)
		times.append((Time.get_ticks_usec() - start) / 1000.0)
		Refusal.push(problem)
	times.sort()
	return times[FRAMES >> 1]


func _soak() -> bool:
	var objects := Performance.get_monitor(Performance.OBJECT_COUNT)
	var start := Time.get_ticks_msec()
	var report := _soaked(50)
	var left_over := Performance.get_monitor(Performance.OBJECT_COUNT) - objects
	var seconds := (Time.get_ticks_msec() - start) / 1000.0
	print("\nSoak: 50 balls, %d frames = 10 minutes, in %.1f s" % [SOAK_FRAMES, seconds])
	print(
		(
			"%d bounces, %d lost, %d not finite, E / E0 - 1 = %s, %d objects left over"
			% (report + [left_over])
		)
	)
	return report[1] == 0 and report[2] == 0 and left_over == 0


# Bounces, lost balls, balls with a number that is not finite, and the error of the energy.
func _soaked(count: int) -> Array:
	var world := _world(count)
	var energy := world.energy()
	for frame: int in SOAK_FRAMES:
		Refusal.push(world.step(FRAME))
	var not_finite := 0
	for ball: Ball in world.balls:
		not_finite += int(not (ball.position.is_finite() and ball.velocity.is_finite()))
	var error := String.num_scientific(world.energy() / energy - 1.0)
	return [world.bounces, world.losses, not_finite, error]


func _world(count: int) -> SteppedWorld:
	var world := SteppedWorld.new(WholeFrameMover.new())
	AngledLinesScenes.set_up(SITUATIONS[count], world)
	return world
