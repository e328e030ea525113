extends SceneTree
## Writes what other libraries are to fly, for tools/report/libraries.py: build/report/shots.json.
## Usage: godot --headless --path . -s tools/report/write_shots.gd -- [--quick]

const FILE := "res://build/report/shots.json"


func _init() -> void:
	var is_quick := OS.get_cmdline_user_args().has("--quick")
	var boxes: Array[Dictionary] = []
	for shot: Shot in BallInBoxProblem.shots():
		boxes.append(_tasks(shot.situation, shot.seconds, shot.segments(), [shot.ball]))
	var crowds: Array[Dictionary] = []
	for crowd: Crowd in ManyBallsProblem.crowds(is_quick):
		var situation := CrowdFlight.situation_of(crowd.count)
		crowds.append(_tasks(situation, crowd.seconds, crowd.walls(), crowd.balls()))
	var all := {"ball_in_box": boxes, "many_balls": crowds}
	FileAccess.open(FILE, FileAccess.WRITE).store_string(JSON.stringify(all, "\t", true, true))
	quit()


func _tasks(
	situation: String, seconds: float, walls: Array[LineSegment], balls: Array[Ball]
) -> Dictionary:
	var ends: Array[PackedFloat64Array] = []
	for wall: LineSegment in walls:
		ends.append(PackedFloat64Array([wall.start.x, wall.start.y, wall.end.x, wall.end.y]))
	var numbers: Array[PackedFloat64Array] = []
	for ball: Ball in balls:
		var velocity := ball.velocity
		numbers.append(
			PackedFloat64Array([ball.position.x, ball.position.y, velocity.x, velocity.y])
		)
	return {
		"situation": situation,
		"seconds": seconds,
		"walls": ends,
		"radius": balls[0].radius,
		"balls": numbers,
	}
