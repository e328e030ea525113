extends LessonJudge
## Judges what the lesson on balls among lines says while time stands still: by plain formulas of
## its own, and by a flight that it follows in very small steps.

# The status shows five digits, the formula four or what was typed.
const _SHARE_OFF := 1e-4
const _NUMBER_OFF := 1e-3
# The path to come is this long, in seconds.
const _AHEAD := 1.5
const _STEPS := 900
# Faster balls would need too many steps, in px/s.
const _FASTEST := 2000.0
# So deep a ball sinks in if no bounce holds it, and so close it comes to a line that it touches.
const _DEEP := 0.5
const _NEAR := 1.0
# A ball farther out than this is lost, in px.
const _REACH := 800.0

## The state when the run began; empty for one that has not begun.
var start := {}

var _balls: Array[PackedFloat64Array]
var _lines: Array[PackedFloat64Array]
var _gravity: PackedFloat64Array


func problem(seen: SeenLesson) -> String:
	_take(seen.state)
	for found: String in [
		_problem_of_status(seen),
		_problem_of_ball(seen),
		_problem_of_sentence(seen),
		_problem_of_rows(seen),
	]:
		if found:
			return found
	return ""


func _take(state: Dictionary) -> void:
	_balls = state["balls"]
	_lines = state["lines"]
	_gravity = state["gravity"]


# Of all balls: v²/2 + g h, with h above the lowest end of a line.
func _energy_of(state: Dictionary) -> float:
	_take(state)
	var lowest := -INF
	for line in _lines:
		lowest = maxf(lowest, maxf(_fall(line[0], line[1]), _fall(line[2], line[3])))
	var sum := 0.0
	for ball in _balls:
		var height := (lowest if _lines else 0.0) - _fall(ball[0], ball[1])
		sum += (ball[2] * ball[2] + ball[3] * ball[3]) / 2.0 + height
	return sum


func _fall(x: float, y: float) -> float:
	return _gravity[0] * x + _gravity[1] * y


func _problem_of_status(seen: SeenLesson) -> String:
	var status := ""
	for label in seen.labels:
		status = label if label.contains("E / E₀ = ") else status
	var lost := _balls.filter(_is_lost).size()
	if not start and not status.contains("bounces 0    lost %d\n" % lost):
		return "%d balls are lost, none has bounced: %s" % [lost, status]
	if status.contains("mistake: ") != (seen.state["mistake"] != 0):
		return "a mistake is told or not told: " + status
	var first := _energy_of(start if start else seen.state)
	var now := _energy_of(seen.state)
	var shown := status.get_slice("E / E₀ = ", 1).get_slice("    ", 0).get_slice(", mistake", 0)
	if lost or first <= 0.0:
		return "" if shown == "–" else "there is nothing to compare: " + status
	return _problem_of_share(shown, now / first, status)


func _problem_of_share(shown: String, share: float, status: String) -> String:
	if absf(SeenLesson.first_number(shown) - share) > _SHARE_OFF * maxf(absf(share), 1.0):
		return "the share is %s: %s" % [share, status]
	if shown.ends_with("✗") and share <= 1.0 or not shown.ends_with("✗") and share > 1.002:
		return "too much, or not: " + status
	return ""


func _is_lost(ball: PackedFloat64Array) -> bool:
	return absf(ball[0]) > _REACH or absf(ball[1]) > _REACH


func _selected(state: Dictionary) -> PackedFloat64Array:
	var place: int = state["selected"]
	return _balls[place]


func _problem_of_ball(seen: SeenLesson) -> String:
	var ball := _selected(seen.state)
	var parts := seen.lines[1].replace(",", "(").split("(")
	var places: Array[int] = [1, 2, 3, 4]
	for i in 4:
		var shown := SeenLesson.first_number(parts[places[i]])
		if absf(shown - ball[i]) > _NUMBER_OFF * maxf(absf(ball[i]), 1e-9):
			return "%s is shown as: %s" % [ball[i], seen.lines[1]]
	return ""


func _problem_of_sentence(seen: SeenLesson) -> String:
	var has_ring := seen.sentence.contains("At the ring")
	if (seen.lines.size() > 2) != has_ring:
		return "the formula of a bounce, and: " + seen.sentence
	var is_lost := _is_lost(_selected(seen.state))
	var closest := _closest_approach(seen.state)
	var claims: Dictionary[String, bool] = {
		"Drag on the board": seen.step == 0,
		"The ball is lost": seen.step == 1 and is_lost,
		"At the ring the ball touches a line": seen.step == 1 and not is_lost and closest <= _NEAR,
		"there is no bounce on it": seen.step == 1 and not is_lost and closest >= -_DEEP,
		"The same minute": seen.step == 2,
	}
	return false_claim([seen.sentence], claims)


# The smallest gap between a line and the selected ball in free flight; 0 where other rules decide:
# it overlaps a line already, flies very fast, or is moved in a way that may pass through lines.
func _closest_approach(state: Dictionary) -> float:
	var ball := _selected(state)
	var speed_x := absf(ball[2]) + absf(_gravity[0]) * _AHEAD
	var speed_y := absf(ball[3]) + absf(_gravity[1]) * _AHEAD
	if not state["method"] in ["whole_frame", "event_world"] or speed_x + speed_y > _FASTEST:
		return 0.0
	var closest := INF
	for i in _STEPS + 1:
		var time := _AHEAD * i / _STEPS
		var x := ball[0] + ball[2] * time + _gravity[0] * time * time / 2.0
		var y := ball[1] + ball[3] * time + _gravity[1] * time * time / 2.0
		for line in _lines:
			closest = minf(closest, _distance(x, y, line) - ball[4])
		if i == 0 and closest < 0.0:
			return 0.0
		if closest < -_DEEP or absf(x) > _REACH or absf(y) > _REACH:
			break
	return closest


func _distance(x: float, y: float, line: PackedFloat64Array) -> float:
	var along_x := line[2] - line[0]
	var along_y := line[3] - line[1]
	var way_x := x - line[0]
	var way_y := y - line[1]
	var square := along_x * along_x + along_y * along_y
	var share := clampf((way_x * along_x + way_y * along_y) / square, 0.0, 1.0)
	return sqrt((way_x - share * along_x) ** 2 + (way_y - share * along_y) ** 2)


# Name, share of the energy, error, run time.
func _problem_of_rows(seen: SeenLesson) -> String:
	if (seen.step == 2) == seen.rows.is_empty():
		return "the comparison belongs to the last step"
	for row in seen.rows:
		var share := SeenLesson.first_number(row[1])
		var error := SeenLesson.first_number(row[2].trim_prefix("≥ "))
		var text := " | ".join(row)
		if row[1] == "–" or row[1].contains("lost") or row[1] == "stopped":
			if row[2] != "–":
				return "there is no error to tell: " + text
		elif row[1].ends_with("✗") and share <= 1.0 or not row[1].ends_with("✗") and share > 1.002:
			return "too much, or not: " + text
		elif seen.state["bounciness"] != 1.0:
			if (row[2] != "–") != row[1].ends_with("✗"):
				return "with C below 1 only too much energy is an error: " + text
		elif absf(error - absf(share - 1.0)) > 0.06 * error + 6e-4:
			return "the error is the distance from 1: " + text
	return ""
