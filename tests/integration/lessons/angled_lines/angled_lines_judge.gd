extends RefCounted
## Judges what the lesson on balls among lines says, by plain formulas of its own: of the numbers in
## its state, and of a flight that it follows in very small steps.

# The status shows five digits, the formula four or what was typed.
const _SHARE_OFF := 1e-4
const _NUMBER_OFF := 1e-3
# The forecast looks so far ahead, in seconds.
const _AHEAD := 1.5
# Faster balls would need too many steps, in px/s.
const _FASTEST := 2000.0
# So deep a ball sinks in if no bounce holds it, and so close it comes to a line that it touches.
const _DEEP := 0.5
const _NEAR := 1.0

const _WHOLE_FRAME := 2
const _EVENT_WORLD := 3


## "" or what is false in [param texts] at [param step], counted from 0, where the state of the
## lesson is [param now] and was [param first] at the start of the run. Time stands still.
static func problem(
	now: Dictionary, first: Dictionary, step: int, texts: PackedStringArray
) -> String:
	for found: String in [
		_problem_of_counters(now, texts),
		_problem_of_energy(now, first, texts),
		_problem_of_ball(now, texts),
		_problem_of_bounce(now, step, texts),
	]:
		if found:
			return found
	return ""


## The energy of all balls by their numbers in a state: v²/2 + g h, with h above the lowest end.
static func energy(of: Dictionary) -> float:
	var gravity := _gravity(of)
	var lowest := -INF
	var lines := _lines(of)
	for at in range(0, lines.size(), 2):
		lowest = maxf(lowest, gravity.x * lines[at] + gravity.y * lines[at + 1])
	var sum := 0.0
	for i in _count(of):
		var ball := _ball(of, i)
		var fall := gravity.x * ball[0] + gravity.y * ball[1]
		var height := (lowest if lines else 0.0) - fall
		sum += (ball[2] * ball[2] + ball[3] * ball[3]) / 2.0 + height
	return sum


static func _problem_of_counters(now: Dictionary, texts: PackedStringArray) -> String:
	var moving := _moving(now)
	var wanted := "bounces %d    lost %d" % [moving[1], moving[2]]
	if not _has(texts, wanted):
		return "not told: " + wanted
	if _whole(now, "method") != _EVENT_WORLD:
		var time := "Frame %d, %.2f s" % [moving[0], moving[0] / 60.0]
		if not _has(texts, time):
			return "not told: " + time
	return ""


static func _problem_of_energy(
	now: Dictionary, first: Dictionary, texts: PackedStringArray
) -> String:
	var status := _with(texts, "E / E₀ = ")
	var shown := status.get_slice("E / E₀ = ", 1).get_slice("    ", 0).get_slice(", mistake", 0)
	if status.contains("mistake: ") != (_whole(now, "mistake") != 0):
		return "a mistake is told or not told: " + status
	var is_lost := false
	for i in _count(now):
		is_lost = is_lost or _ball(now, i)[4] != 0.0
	if is_lost or energy(first) <= 0.0:
		return "" if shown == "–" else "nothing to compare, but: " + status
	var share := energy(now) / energy(first)
	var number := shown.trim_suffix(" ✗").replace("−", "-").to_float()
	if absf(number - share) > _SHARE_OFF * maxf(absf(share), 1.0):
		return "E / E₀ is %s: %s" % [share, status]
	if shown.ends_with("✗") and share <= 1.0:
		return "not too much, but: " + status
	if not shown.ends_with("✗") and share > 1.002:
		return "too much, but: " + status
	return ""


static func _problem_of_ball(now: Dictionary, texts: PackedStringArray) -> String:
	var line := _with(texts, "P = ( ")
	var ball := _ball(now, _whole(now, "selected"))
	var numbers := _numbers_in(line)
	for i in 4:
		if absf(numbers[i] - ball[i]) > _NUMBER_OFF * maxf(absf(ball[i]), 1e-9):
			return "%s is shown: %s" % [ball[i], line]
	return ""


static func _problem_of_bounce(now: Dictionary, step: int, texts: PackedStringArray) -> String:
	var has_ring := _has(texts, "At the ring the ball touches a line")
	var has_none := _has(texts, "there is no bounce on it")
	var has_lost := _has(texts, "The ball is lost")
	var has_formula := _has(texts, "v₂ = v₁ − (1 + C)")
	if step != 1:
		return "told too early" if has_ring or has_none or has_lost or has_formula else ""
	if has_ring != has_formula:
		return "the formula of a bounce and the sentence disagree"
	var ball := _ball(now, _whole(now, "selected"))
	if has_lost != (ball[4] != 0.0):
		return "lost or not lost"
	if has_lost or not _whole(now, "method") in [_WHOLE_FRAME, _EVENT_WORLD]:
		return ""
	var fall := _gravity(now)
	var fastest := Vec2.new(absf(ball[2]), absf(ball[3])).plus(
		Vec2.new(absf(fall.x), absf(fall.y)).scaled(_AHEAD)
	)
	if fastest.length() > _FASTEST:
		return ""
	var closest := _closest_approach(now, ball)
	if has_ring and closest > _NEAR:
		return "the ball stays %s px away from all lines: no touch" % closest
	if has_none and closest < -_DEEP:
		return "the ball would sink %s px into a line: a bounce" % -closest
	return ""


# The smallest gap between the freely flying ball and a line that it comes closer to; INF where it
# overlaps one at the start already, because then other rules decide.
static func _closest_approach(now: Dictionary, ball: PackedFloat64Array) -> float:
	var gravity := _gravity(now)
	var radii: PackedFloat64Array = _list(now, "radii")
	var radius := radii[_whole(now, "selected")]
	var lines := _lines(now)
	var steps := ceili(_AHEAD * 600.0)
	var closest := INF
	for i in steps + 1:
		var time := _AHEAD * i / steps
		var x := ball[0] + ball[2] * time + gravity.x * time * time / 2.0
		var y := ball[1] + ball[3] * time + gravity.y * time * time / 2.0
		for at in range(0, lines.size(), 4):
			var gap := _distance(x, y, lines, at) - radius
			if i == 0 and gap < 0.0:
				return 0.0
			closest = minf(closest, gap)
		if closest < -_DEEP or absf(x) > 800.0 or absf(y) > 800.0:
			break
	return closest


# From a point to the segment whose four numbers begin at `at`.
static func _distance(x: float, y: float, lines: PackedFloat64Array, at: int) -> float:
	var along_x := lines[at + 2] - lines[at]
	var along_y := lines[at + 3] - lines[at + 1]
	var way_x := x - lines[at]
	var way_y := y - lines[at + 1]
	var square := along_x * along_x + along_y * along_y
	var share := clampf((way_x * along_x + way_y * along_y) / square, 0.0, 1.0)
	return sqrt((way_x - share * along_x) ** 2 + (way_y - share * along_y) ** 2)


static func _gravity(of: Dictionary) -> Vec2:
	var numbers: PackedFloat64Array = _list(of, "gravity")
	return Vec2.new(numbers[0], numbers[1])


static func _lines(of: Dictionary) -> PackedFloat64Array:
	return _list(of, "lines")


static func _list(of: Dictionary, name: String) -> PackedFloat64Array:
	var world: Dictionary = of["world"]
	return world[name]


static func _whole(of: Dictionary, name: String) -> int:
	return of[name]


static func _moving(of: Dictionary) -> PackedFloat64Array:
	return _list(of, "moving")


static func _count(of: Dictionary) -> int:
	return roundi((_moving(of).size() - 3) / 5.0)


# Place, velocity, and 1 if it is lost.
static func _ball(of: Dictionary, index: int) -> PackedFloat64Array:
	return _moving(of).slice(3 + 5 * index, 8 + 5 * index)


static func _has(texts: PackedStringArray, part: String) -> bool:
	return _with(texts, part) != ""


static func _with(texts: PackedStringArray, part: String) -> String:
	for text in texts:
		if text.contains(part):
			return text
	return ""


static func _numbers_in(line: String) -> PackedFloat64Array:
	var found: PackedFloat64Array = []
	for hit in RegEx.create_from_string("-?\\d[\\d.]*(?:e-?\\d+)?").search_all(
		line.replace("−", "-")
	):
		found.append(hit.get_string().to_float())
	return found
