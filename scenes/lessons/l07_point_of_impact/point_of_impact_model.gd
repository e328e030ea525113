class_name PointOfImpactModel
extends LessonModel
## One frame of a ball's motion towards a line without ends: where it touches, and where a position
## reset puts it.

## What the two distances say of the frame.
enum Case { IN_FRAME, OVERLAPS_FROM_START, TOO_FAR, MOVING_AWAY, LEAVING, PARALLEL }

# What a distance may be off by, as a share of the places that it is computed from.
const _ROUNDING := 4e-15
const _LINE: PackedFloat64Array = [60.0, 45.0, -60.0, -45.0]
const _SHORT_LINE: PackedFloat64Array = [24.0, 18.0, -24.0, -18.0]
const _LONG_LINE: PackedFloat64Array = [200.0, 150.0, -200.0, -150.0]
## Presets by their titles (source text): what each changes in the model's state. The speeds are
## those of the course's scenes, in pixels per frame.
const PRESETS: Dictionary[String, Dictionary] = {
	"Lecture": {old = [6.0, -58.0], new = [6.0, 42.0], line = _LINE, radius = 10.0},
	"10 px": {old = [6.0, -10.0], new = [6.0, 0.0], line = _SHORT_LINE, radius = 10.0},
	"38 px": {old = [6.0, -36.5], new = [6.0, 1.5], line = _LINE, radius = 10.0},
	"72 px": {old = [6.0, -26.0], new = [6.0, 46.0], line = _LINE, radius = 10.0},
	"500 px": {old = [6.0, -308.0], new = [6.0, 192.0], line = _LONG_LINE, radius = 10.0},
	"t = 0": {old = [6.0, -8.0], new = [6.0, 42.0], line = _LINE, radius = 10.0},
	"t = 1": {old = [6.0, -58.0], new = [6.0, -8.0], line = _LINE, radius = 10.0},
	"Not yet": {old = [6.0, -58.0], new = [6.0, -20.5], line = _LINE, radius = 10.0},
	"Inside": {old = [3.0, -4.0], new = [3.0, 21.0], line = _LINE, radius = 10.0},
	"Away": {old = [12.0, -16.0], new = [12.0, -66.0], line = _LINE, radius = 10.0},
	"Leaving": {old = [3.0, -4.0], new = [3.0, -29.0], line = _LINE, radius = 10.0},
	"Along": {old = [-34.0, -88.0], new = [46.0, -28.0], line = _LINE, radius = 10.0},
}

# A wrong fraction of the frame larger than this does not make the board smaller.
const _LARGEST_SHOWN_FRACTION := 20.0

## The line; its ends only say where it is drawn.
var line := LineSegment.new(Vec2.new(60.0, 45.0), Vec2.new(-60.0, -45.0))
## The ball's centre before the frame and after it, if nothing were in the way.
var old_position := Vec2.new(6.0, -58.0)
var new_position := Vec2.new(6.0, 42.0)
## The ball's radius in pixels.
var radius := 10.0
## The moment of the frame at which the ghost of the ball is shown: 0 at old, 1 at new.
var moment := 0.0
## The mistake that is switched on, by its number in [PointOfImpactMistakes]; 0 for none.
var mistake := 0


## The motion of the whole frame v, in pixels: new less old position.
func motion() -> Vec2:
	return new_position.minus(old_position)


## Where the ball is at the [member moment] of the frame, if nothing is in the way.
func position_at_moment() -> Vec2:
	return old_position.lerped(new_position, moment)


## Moves the ghost to the point of the path that is nearest to [param point].
func slide_to(point: Vec2) -> void:
	if motion().length() > 0.0:
		moment = clampf(LineSegment.new(old_position, new_position).share_of(point), 0.0, 1.0)


## Signed distance of the old position from the line, in pixels. Exactly 0 or the radius where only
## rounding makes a difference.
func old_distance() -> float:
	var distance := LineDistance.signed_distance(old_position, line)
	for exact: float in [0.0, radius]:
		distance = exact if _is_rounding(distance - exact) else distance
	return distance


## Signed distance of the new position from the line, in pixels. Exactly that of the old one, 0 or
## the radius where only rounding makes a difference.
func new_distance() -> float:
	var distance := LineDistance.signed_distance(new_position, line)
	for exact: float in [0.0, radius, old_distance()]:
		distance = exact if _is_rounding(distance - exact) else distance
	return distance


## a = old - r: the way along the normal up to the contact.
func way_to_contact() -> float:
	return old_distance() - radius


## b = old - new: the way along the normal of the whole frame.
func way_of_frame() -> float:
	return old_distance() - new_distance()


## t = a / b, not limited; infinite or NaN for b = 0.
func fraction() -> float:
	return PointOfImpact.fraction(old_distance(), new_distance(), radius)


## The impact in this frame, or why there is none, as the lecture's code finds it.
func impact() -> Impact:
	return PointOfImpact.with_line(old_position, motion(), radius, line)


## Which of the cases this frame is.
func frame_case() -> Case:
	var a := way_to_contact()
	var b := way_of_frame()
	if b == 0.0:
		return Case.PARALLEL
	if b < 0.0:
		return Case.LEAVING if a < 0.0 else Case.MOVING_AWAY
	if a < 0.0:
		return Case.OVERLAPS_FROM_START
	return Case.IN_FRAME if a <= b else Case.TOO_FAR


## Whether the ball touches the line's good side in this frame.
func touches() -> bool:
	return frame_case() in [Case.IN_FRAME, Case.OVERLAPS_FROM_START]


## The ball's centre when it [method touches].
func impact_position() -> Vec2:
	var found := impact()
	if found.hit:
		return found.position
	# Rounding alone keeps the lecture's code from a contact at one end of the frame.
	return old_position.plus(motion().scaled(clampf(fraction(), 0.0, 1.0)))


## Whether the ball overlaps the line after the frame, so that a position reset moves it.
func is_reset() -> bool:
	return new_distance() < radius


## Whether the position reset puts the ball where it touches, but for rounding.
func is_reset_at_impact() -> bool:
	return _is_rounding(0.01 * error_of(reset_position()))


## Where the position reset puts the ball's centre.
func reset_position() -> Vec2:
	var ball := Ball.new(new_position, radius)
	PositionReset.reset(ball, line)
	return ball.position


## How many pixels [param position] is from the exact contact on the path; means something only in
## the case [constant Case.IN_FRAME].
func error_of(position: Vec2) -> float:
	return ExactContact.distance_from(position, old_position, new_position, radius, line)


## t as the mistake that is switched on has it; the right one where none is.
func fraction_with_mistake() -> float:
	var old := old_distance()
	var new := new_distance()
	# As far from the line as before, on either side: without their signs they are the same.
	if mistake == PointOfImpactMistakes.UNSIGNED and _is_rounding(absf(old) - absf(new)):
		return INF
	return PointOfImpactMistakes.fraction(mistake, old, new, radius)


## Where the mistake that is switched on puts the ball; not finite where it divides by 0.
func position_with_mistake() -> Vec2:
	return old_position.plus(motion().scaled(fraction_with_mistake()))


## Whether the mistake that is switched on makes a difference: another t, or, for one that believes
## every t, one that is taken where there is no impact.
func shows_mistake() -> bool:
	if mistake == PointOfImpactMistakes.NOT_LIMITED:
		return frame_case() != Case.IN_FRAME
	return fraction_with_mistake() != fraction()


## Switches a mistake on. Where it changes nothing, a preset is shown in which it does.
func show_mistake(number: int) -> void:
	mistake = number
	for preset: String in ["Lecture", "Not yet"]:
		if number != 0 and not shows_mistake():
			Refusal.push(take(PRESETS[preset]))


## Where the ball touches the line on its way within the frame; null where it does not.
func touch_in_frame() -> Vec2:
	return impact_position() if frame_case() == Case.IN_FRAME else null


## The points that the board has to show: the ends of the line, both balls as far as half their
## radius, and the ball of a mistake that is not too far away.
func points_to_show() -> Array[Vec2]:
	var half := Vec2.new(radius / 2.0, radius / 2.0)
	var points: Array[Vec2] = [line.start, line.end]
	for centre: Vec2 in [old_position, new_position]:
		points.append(centre.plus(half))
		points.append(centre.minus(half))
	if mistake != 0 and absf(fraction_with_mistake()) < _LARGEST_SHOWN_FRACTION:
		points.append(position_with_mistake())
	return points


## Takes a typed number by its name in the formula. "" if it could be taken; else one sentence with
## the value and what is allowed, and nothing changes.
func enter(name_in_line: String, value: float) -> String:
	var start := line.start.copy()
	var end := line.end.copy()
	match name_in_line:
		"old_x":
			old_position.x = value
		"old_y":
			old_position.y = value
		"new_x":
			new_position.x = value
		"new_y":
			new_position.y = value
		"sx":
			start.x = value
		"sy":
			start.y = value
		"ex":
			end.x = value
		"ey":
			end.y = value
		"r":
			return set_radius(value)
		"speed":
			return set_speed(value)
	return move_line(start, end)


## Makes the frame's motion this long and keeps old position and direction. "" if it could be made
## so; else a sentence, and the motion stays.
func set_speed(pixels: float) -> String:
	if not (pixels > 0.0 and is_finite(pixels)):
		var sentence := "The speed must be above 0 and finite, not %s."
		return TranslationServer.translate(sentence) % NumberText.short(pixels)
	if motion().length() == 0.0:
		return TranslationServer.translate("A ball at rest has no direction: drag old or new.")
	new_position = old_position.plus(motion().normalized().scaled(pixels))
	return ""


## Moves the line's ends. "" if they could be moved; else a sentence, and the line stays.
func move_line(start: Vec2, end: Vec2) -> String:
	var moved := LineSegment.new(start, end)
	var problem := moved.problem()
	if problem == "":
		line = moved
	return problem


## Changes the radius. "" if it could be changed; else a sentence, and the radius stays.
func set_radius(pixels: float) -> String:
	var problem := Ball.new(old_position, pixels).problem()
	if problem == "":
		radius = pixels
	return problem


func to_dictionary() -> Dictionary:
	return {
		"line": PackedFloat64Array([line.start.x, line.start.y, line.end.x, line.end.y]),
		"old": PackedFloat64Array([old_position.x, old_position.y]),
		"new": PackedFloat64Array([new_position.x, new_position.y]),
		"radius": radius,
		"moment": moment,
		"mistake": mistake,
	}


func problem_in(stored: Dictionary) -> String:
	var model := PointOfImpactModel.new()
	model.from_dictionary(stored)
	return (
		StateCheck
		. first(
			[
				model.line.problem(),
				Ball.new(model.old_position, model.radius).problem(),
				_problem_in_moment(model.moment),
				StateCheck.mistake(model.mistake, PointOfImpactMistakes.infos()),
			]
		)
	)


static func _problem_in_moment(wanted: float) -> String:
	if wanted >= 0.0 and wanted <= 1.0:
		return ""
	var sentence := LabText.translate("The moment must be within 0..1, not %s.")
	return sentence % NumberText.short(wanted)


func from_dictionary(stored: Dictionary) -> void:
	var ends: PackedFloat64Array = stored["line"]
	var old: PackedFloat64Array = stored["old"]
	var new: PackedFloat64Array = stored["new"]
	line = LineSegment.new(Vec2.new(ends[0], ends[1]), Vec2.new(ends[2], ends[3]))
	old_position = Vec2.new(old[0], old[1])
	new_position = Vec2.new(new[0], new[1])
	radius = stored["radius"]
	moment = stored["moment"]
	mistake = stored["mistake"]


func _is_rounding(distance: float) -> bool:
	var places := line.start.length() + old_position.length() + new_position.length()
	return absf(distance) <= _ROUNDING * (places + radius)
