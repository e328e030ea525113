extends LessonJudge
## Judges what the lesson on balls among lines says while time stands still: by plain formulas of
## its own, and by a flight that it follows in very small steps.

const _FRAME := 1.0 / 60.0

# The status shows five digits, the formula four or what was typed.
const _SHARE_OFF := 1e-4
const _NUMBER_OFF := 1e-3
# The path to come is this long, in seconds.
const _AHEAD := 1.5
const _STEPS := 900
# Faster balls would need too many steps, in px/s.
const _FASTEST := 2000.0
# So many places of a frame's way are looked at for the touch, for balls at least this large in px.
const _PLACES := 24
const _SMALLEST := 2.0
# Where it comes so close before, or where the next line is so close, rounding decides, in px.
const _CLOSE := 0.2
# Numbers of the bounce are shown with four digits.
const _BOUNCE_OFF := 2e-3
# What is left of the energy by a way that keeps it differs from 1 by less than this.
const _RIGHT := 1e-6
const _WAYS: PackedStringArray = ["position reset", "rest dropped", "rest used", "event world"]
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
var _is_endless: bool


func problem(seen: SeenLesson) -> String:
	_take(seen.state)
	return first_of(
		[
			_problem_of_status(seen),
			_problem_of_surroundings(seen),
			_problem_of_ball(seen),
			_problem_of_sentence(seen),
			_problem_of_bounce(seen),
			_problem_of_labels(seen),
			_problem_of_rows(seen),
			false_claim([seen.notice] if seen.notice else [], {}),
		]
	)


func _take(state: Dictionary) -> void:
	_balls = state["balls"]
	_lines = state["lines"]
	_gravity = state["gravity"]
	_is_endless = state.get("endless", false)


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
	var frames := SeenLesson.number_behind("Frame ", status)
	var seconds := SeenLesson.number_behind(", ", status)
	if not start and frames != 0.0 or absf(seconds - frames * _FRAME) > _FRAME + 0.006:
		return "so many frames do not last so long: " + status
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
	if shown.ends_with("> 1") and share <= 1.0 or not shown.ends_with("> 1") and share > 1.002:
		return "too much, or not: " + status
	return ""


func _is_lost(ball: PackedFloat64Array) -> bool:
	return absf(ball[0]) > _REACH or absf(ball[1]) > _REACH


func _selected(state: Dictionary) -> PackedFloat64Array:
	var place: int = state["selected"]
	return _balls[place]


# g = ( x , y )    C = C
func _problem_of_surroundings(seen: SeenLesson) -> String:
	var parts := seen.lines[0].replace(",", "(").split("(")
	var wanted: Array[float] = [_gravity[0], _gravity[1], seen.state["bounciness"]]
	var shown: Array[String] = [parts[1], parts[2], seen.lines[0].get_slice("C = ", 1)]
	for i in 3:
		var off := absf(SeenLesson.first_number(shown[i]) - wanted[i])
		if off > _NUMBER_OFF * maxf(absf(wanted[i]), 1e-9):
			return "%s is shown as: %s" % [wanted[i], seen.lines[0]]
	return ""


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
		"Drag on the board to draw a line": seen.step == 0 and not _is_endless,
		"Week 4: lines are endless and work on the side to which n̂":
		seen.step == 0 and _is_endless,
		"A ball behind a line is put before it. Next time: lines end":
		seen.step == 2 and _is_endless,
		"The ball is lost": seen.step == 1 and is_lost,
		"At the ring the ball touches a line": seen.step == 1 and not is_lost and closest <= _NEAR,
		"The dots show its path in the next 1.5 s: no bounce":
		seen.step == 1 and not is_lost and closest >= -_DEEP,
		"The same minute": seen.step == 2 and not _is_endless,
	}
	return false_claim([seen.sentence], claims)


# v₂ = v₁ − (1 + C) · (v₁ · n) n, in numbers. The arithmetic is read elsewhere; here v₁, n
# and t are those of the first touch.
func _problem_of_bounce(seen: SeenLesson) -> String:
	if seen.lines.size() < 4:
		return ""
	var touch := _first_touch(seen.state)
	if not touch:
		return ""
	var numbers := seen.lines[3].replace(",", "(").split("(")
	var ball := _selected(seen.state)
	var speed := sqrt(_speed_squared_at(ball, touch))
	var shown := Vector2(SeenLesson.first_number(numbers[1]), SeenLesson.first_number(numbers[2]))
	if absf(shown.length() - speed) > _BOUNCE_OFF * speed:
		return "at the touch it is %s px/s fast: %s" % [speed, seen.lines[3]]
	var factor := SeenLesson.number_behind(") − ", seen.lines[3])
	var bounciness: float = seen.state["bounciness"]
	if absf(factor - 1.0 - bounciness) > _BOUNCE_OFF:
		return "it is 1 + C = %s: %s" % [1.0 + bounciness, seen.lines[3]]
	var shown_pair := seen.lines[3].get_slice(" = ", 1)
	shown_pair = shown_pair.substr(shown_pair.rfind("(") + 1)
	var n_x := SeenLesson.first_number(shown_pair.get_slice(", ", 0))
	var n_y := SeenLesson.first_number(shown_pair.get_slice(", ", 1))
	if absf(n_x - touch.normal_x) + absf(n_y - touch.normal_y) > 2.0 * _BOUNCE_OFF:
		return "n̂ is (%s, %s): %s" % [touch.normal_x, touch.normal_y, seen.lines[3]]
	return _problem_of_share_of_frame(seen, touch)


# By the law of energy: v² = v₀² + 2 g s.
func _speed_squared_at(ball: PackedFloat64Array, touch: Touch) -> float:
	var fallen := _fall(touch.x, touch.y) - _fall(ball[0], ball[1])
	return ball[2] * ball[2] + ball[3] * ball[3] + 2.0 * fallen


func _problem_of_share_of_frame(seen: SeenLesson, touch: Touch) -> String:
	for label in seen.labels:
		if label.begins_with("t = "):
			var off := absf(SeenLesson.number_behind("t = ", label) - touch.share)
			return "" if off < 5e-3 or off > 0.999 else "it is t = %s: %s" % [touch.share, label]
	return "the ring has no t"


## Where a flying ball first touches a line.
class Touch:
	extends RefCounted
	## Its centre.
	var x: float
	var y: float
	## From the line to its centre; length 1.
	var normal_x: float
	var normal_y: float
	## The share of the frame's way, or of its time in the event world.
	var share: float


# The first touch of the selected ball; null where other rules decide, where rounding does, or where
# so rough a look may miss it.
func _first_touch(state: Dictionary) -> Touch:
	var ball := _selected(state)
	var is_exact: bool = state["method"] == "event_world"
	var is_clear := ball[4] >= _SMALLEST and _closest_approach(state) < -_DEEP
	if start or not is_clear or _gap_at(ball, 0.0, is_exact) < _CLOSE:
		return null
	var longest := _fastest_speed(ball) * _FRAME / _PLACES
	var gap := INF
	var i := 1
	while i < roundi(_AHEAD / _FRAME) * _PLACES:
		var next := _gap_at(ball, 1.0 * i / _PLACES, is_exact)
		if next <= 0.0:
			return _touch_between(ball, (i - 1.0) / _PLACES, 1.0 * i / _PLACES, is_exact)
		if gap < _CLOSE and next > gap:
			return null
		gap = next
		i += _places_to_skip(gap, longest)
	return null


func _touch_between(ball: PackedFloat64Array, apart: float, inside: float, is_exact: bool) -> Touch:
	for i in 60:
		var middle := (apart + inside) / 2.0
		if _gap_at(ball, middle, is_exact) > 0.0:
			apart = middle
		else:
			inside = middle
	var touch := Touch.new()
	var place := _place_at(ball, inside, is_exact)
	touch.x = place[0]
	touch.y = place[1]
	touch.share = inside - floorf(inside)
	var gaps: Array[float] = []
	for line in _lines:
		var foot := _foot(touch.x, touch.y, line)
		var distance := sqrt((touch.x - foot[0]) ** 2 + (touch.y - foot[1]) ** 2)
		gaps.append(distance - ball[4])
		if gaps[-1] <= gaps.min():
			touch.normal_x = (touch.x - foot[0]) / distance
			touch.normal_y = (touch.y - foot[1]) / distance
	gaps.sort()
	return null if gaps.size() > 1 and gaps[1] - gaps[0] < _CLOSE else touch


# The place after so many frames: on the parabola, or on the straight way within a frame.
func _place_at(ball: PackedFloat64Array, frames: float, is_exact: bool) -> PackedFloat64Array:
	if is_exact or frames == floorf(frames):
		var time := frames * _FRAME
		return [
			ball[0] + ball[2] * time + _gravity[0] * time * time / 2.0,
			ball[1] + ball[3] * time + _gravity[1] * time * time / 2.0,
		]
	var from := _place_at(ball, floorf(frames), true)
	var to := _place_at(ball, floorf(frames) + 1.0, true)
	var share := frames - floorf(frames)
	return [from[0] + (to[0] - from[0]) * share, from[1] + (to[1] - from[1]) * share]


func _gap_at(ball: PackedFloat64Array, frames: float, is_exact: bool) -> float:
	var place := _place_at(ball, frames, is_exact)
	var least := INF
	for line in _lines:
		least = minf(least, _distance(place[0], place[1], line) - ball[4])
	return least


# v, g, n, t and the names of the lines; the rest is the status.
func _problem_of_labels(seen: SeenLesson) -> String:
	var names: PackedStringArray = []
	var has_ring := seen.sentence.contains("At the ring")
	for label in seen.labels:
		if label in ["n̂"] or label.begins_with("t = "):
			if seen.step == 0 or seen.step == 1 and not has_ring:
				return "there is no bounce to show: “%s”" % label
		elif label.ends_with("Bring lost balls back"):
			if not _balls.any(_is_lost):
				return "no ball is lost: “%s”" % label
		elif not (label in ["v", "g"] or label.contains("E / E₀ = ")):
			names.append(label)
	var wanted: PackedStringArray = []
	for i in _lines.size():
		wanted.append(char(65 + i) if i < 26 else str(i + 1))
	if names != wanted:
		return "the lines are named %s" % ", ".join(names)
	return ""


# The smallest gap between a line and the selected ball in free flight; 0 where other rules decide:
# it overlaps a line already, flies very fast, or is moved in a way that may pass through lines.
func _closest_approach(state: Dictionary) -> float:
	var ball := _selected(state)
	var speed := _fastest_speed(ball)
	if not state["method"] in ["whole_frame", "event_world"] or speed > _FASTEST:
		return 0.0
	var closest := INF
	var i := 0
	while i <= _STEPS:
		var time := _AHEAD * i / _STEPS
		var x := ball[0] + ball[2] * time + _gravity[0] * time * time / 2.0
		var y := ball[1] + ball[3] * time + _gravity[1] * time * time / 2.0
		var gap := INF
		for line in _lines:
			gap = minf(gap, _distance(x, y, line) - ball[4])
		closest = minf(closest, gap)
		if i == 0 and closest < 0.0:
			return 0.0
		if closest < -_DEEP or absf(x) > _REACH or absf(y) > _REACH:
			break
		i += _places_to_skip(gap, speed * _AHEAD / _STEPS)
	return closest


# In the time looked at; at least that.
func _fastest_speed(ball: PackedFloat64Array) -> float:
	var speed_x := absf(ball[2]) + absf(_gravity[0]) * _AHEAD
	return speed_x + absf(ball[3]) + absf(_gravity[1]) * _AHEAD


# So many places further the ball may be close to a line; before, there is nothing to see.
func _places_to_skip(gap: float, longest: float) -> int:
	return clampi(floori((gap - _NEAR) / maxf(longest, 1e-6)), 1, _STEPS)


func _distance(x: float, y: float, line: PackedFloat64Array) -> float:
	var foot := _foot(x, y, line)
	return sqrt((x - foot[0]) ** 2 + (y - foot[1]) ** 2)


# The closest point of the line.
func _foot(x: float, y: float, line: PackedFloat64Array) -> PackedFloat64Array:
	var along_x := line[2] - line[0]
	var along_y := line[3] - line[1]
	var square := along_x * along_x + along_y * along_y
	var share := ((x - line[0]) * along_x + (y - line[1]) * along_y) / square
	share = clampf(share, 0.0, 1.0)
	return [line[0] + share * along_x, line[1] + share * along_y]


# Name, share of the energy, error, run time.
func _problem_of_rows(seen: SeenLesson) -> String:
	if (seen.step == 2 and not _is_endless) == seen.rows.is_empty():
		return "the comparison belongs to the last step"
	var bounciness: float = seen.state["bounciness"]
	for i in seen.rows.size():
		var row := seen.rows[i]
		if row[0] != _WAYS[i]:
			return "the ways are %s, not: %s" % [", ".join(_WAYS), row[0]]
		var found := _problem_of_row(row, i >= 2, bounciness == 1.0)
		if found:
			return "%s: %s" % [found, " | ".join(row)]
	return ""


func _problem_of_row(row: PackedStringArray, is_right_way: bool, keeps_energy: bool) -> String:
	var share := SeenLesson.first_number(row[1])
	var is_marked := row[1].ends_with("> 1")
	if row[1] == "–" or row[1].contains("lost") or row[1] == "stopped":
		return "" if row[2] == "–" else "there is no error to tell"
	if is_marked and share <= 1.0 or not is_marked and share > 1.002:
		return "too much, or not"
	if not keeps_energy:
		var is_error := row[2] != "–"
		return "" if is_error == is_marked else "with C below 1 only too much energy is an error"
	var error := SeenLesson.first_number(row[2])
	if absf(error - absf(share - 1.0)) > 0.06 * error + 6e-4:
		return "the error is the distance from 1"
	return "this way keeps the energy" if is_right_way and error > _RIGHT else ""
