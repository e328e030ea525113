class_name FrictionRows
extends RefCounted
## Judges impacts of a ball with a segment by a reference table with friction: the columns of the
## ball, the segment and the answer are the same in three of them.

## The reference answers.
var table: MotionTable
## The largest error of each family, of anything that was noted.
var worst := WorstErrors.new()
## The rows in which hit, regime, feature, or a velocity without a hit are not those of the table.
var wrong: PackedInt32Array = []


func _init(name: String) -> void:
	table = MotionTable.new(name)


## The ball of a row.
func ball(row: int) -> Ball:
	var radius := table.at(row, "r")
	var velocity := table.vector(row, "vx", "vy")
	return Ball.new(table.vector(row, "px", "py"), radius, velocity, 1.0, table.at(row, "spin"))


## The bounciness of a row.
func bounciness(row: int) -> float:
	return table.at(row, "restitution")


## The friction of a row.
func friction(row: int) -> float:
	return table.at(row, "friction")


## The velocity of the row's segment, or of its pivot; zero where the table has none.
func segment_velocity(row: int) -> Vec2:
	return table.vector(row, "wx", "wy") if table.has("wx") else Vec2.zero()


## The segment of a row.
func segment(row: int) -> LineSegment:
	return LineSegment.new(table.vector(row, "ax", "ay"), table.vector(row, "bx", "by"))


## Notes the answer to a row. [param speed] is how fast ball and segment can move past each other,
## in px/s: the error of the normal is judged by it.
func judge(row: int, impact: FrictionImpact, speed: float) -> void:
	if not _agrees(row, impact):
		wrong.append(row)
		return
	var family := table.family(row)
	var velocity := table.vector(row, "vx_after", "vy_after")
	worst.note(family, table.velocity_error(row, impact.velocity, velocity, "condition_v"))
	worst.note(family, table.error(row, impact.spin, "spin_after", "condition_spin"))
	if not impact.hit:
		return
	worst.note(family, table.error(row, impact.time, "t"))
	var flying := ball(row)
	var lengths: PackedFloat64Array = [speed, flying.position.length(), segment(row).start.length()]
	worst.note(family, table.normal_error(row, impact.normal, flying.radius, lengths))


# Features 1, 2, 3 in the file are line, start, end. On the very joint of both either is right.
func _agrees(row: int, impact: FrictionImpact) -> bool:
	if impact.hit != table.is_hit(row) or impact.regime != int(table.at(row, "regime")):
		return false
	if not impact.hit or table.family(row) == "feature-boundary":
		return true
	return impact.feature == int(table.at(row, "feature")) - 1
