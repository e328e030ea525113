@abstract class_name CrowdFlight
extends FlightCase
## Many balls by one method, all read after each step: the run time, the deepest overlap, the drift
## of the energy, and for how long a reversed run retraces its path.

## Pixels. A reversed run is lost when the first ball is farther from its path than this.
const LOST := 1.0

const _FRAMES_PER_SECOND := 60
# The overlap is measured in every sixth frame.
const _EVERY := 6

## The balls.
var crowd: Crowd

# x, y of each ball, as read after the latest step.
var _places: PackedFloat64Array = []


## A flight of these balls with [param at_rate] steps a second: 60 or a multiple of it.
func _init(of_crowd: Crowd, at_rate: int) -> void:
	super(of_crowd.seconds, at_rate)
	crowd = of_crowd
	problem = "many_balls"
	situation = situation_of(crowd.count)
	_places.resize(2 * crowd.count)


## The name of the situation in tables.
static func situation_of(count: int) -> String:
	return "%d balls" % count


## The x, y of the velocity of each ball.
@abstract func _velocities() -> PackedFloat64Array

## Reverses all velocities.
@abstract func _turn_round() -> void


## A further remark for the note; "" for none.
func _remark() -> String:
	return ""


func _find_error() -> void:
	@warning_ignore("redundant_await")
	await _set_up()
	var before := _velocities()
	var places: Array[PackedFloat64Array] = []
	var overlap := 0.0
	for frame in roundi(seconds * _FRAMES_PER_SECOND):
		@warning_ignore("redundant_await")
		await _fly_frame()
		places.append(_places.duplicate())
		if frame % _EVERY == 0:
			overlap = maxf(overlap, Crowd.worst_overlap(_places))
	error = overlap
	figures["energy drift"] = Crowd.energy_drift(before, _velocities())
	var remark := _remark()
	_turn_round()
	@warning_ignore("redundant_await")
	figures["reversed"] = await _time_until_lost(places)
	var texts := [FigureText.short(figures["energy drift"]), _reversed_text(), seconds]
	note = "energy off by %s of itself; %s of %s s" % texts + remark


func _fly_frame() -> void:
	@warning_ignore("redundant_await")
	await _fly(floori(float(rate) / _FRAMES_PER_SECOND))


# Flies back, and compares each frame with that of the way there.
func _time_until_lost(places: Array[PackedFloat64Array]) -> float:
	for back in range(1, places.size()):
		@warning_ignore("redundant_await")
		await _fly_frame()
		if not Crowd.worst_distance(_places, places[-1 - back]) <= LOST:
			return float(back) / _FRAMES_PER_SECOND
	return seconds


func _reversed_text() -> String:
	if figures["reversed"] == seconds:
		return "reversed, never 1 px off its own way in all"
	return "reversed, 1 px off its own way after %.2f s" % figures["reversed"]
