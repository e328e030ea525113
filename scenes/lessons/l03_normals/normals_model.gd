class_name NormalsModel
extends LessonModel
## A line from a start to an end, its vector v and the normals of v.
##
## v = (x, y) is end minus start, in pixels. Its normal is (-y, x), no matter which way y is drawn.

## What a change did to the line.
enum Change { NONE, MOVED, STRETCHED, TURNED }

## Presets by their titles (source text): what each changes in the model's state.
const PRESETS: Dictionary[String, Dictionary] = {
	"(3, 1)": {line = [0.0, 0.0, 3.0, 1.0], times = 2.0},
	"(3, −2)": {line = [0.0, 0.0, 3.0, -2.0], times = 2.0},
	"(3, −4)": {line = [0.0, 0.0, 3.0, -4.0], times = 2.0},
	"In pixels": {line = [-40.0, 60.0, 200.0, -10.0], times = 60.0},
	"Zero": {line = [0.0, 0.0, 0.0, 0.0], times = 2.0},
}

## Two directions count as the same where their unit vectors differ by no more than rounding.
const SAME_DIRECTION := 1e-15

## Where the line begins, in pixels.
var start := Vec2.new()
## Where the line ends, in pixels.
var end := Vec2.new(3.0, 1.0)
## The factor by which the unit normal is drawn longer, to be seen; negative for the other side.
var times := 2.0
## The mistake that is switched on, by its number; 0 for none.
var mistake := 0


## Lays the line from one point to another, in pixels.
func lay(from: Vec2, to: Vec2) -> void:
	start = from.copy()
	end = to.copy()


## Takes the number that has this name in the formula. A new start takes the end along: v stays.
func enter(name_in_line: String, value: float) -> String:
	var along := v()
	match name_in_line:
		"vx":
			along.x = value
		"vy":
			along.y = value
		"sx":
			start.x = value
		"sy":
			start.y = value
		"k":
			times = value
	end = start.plus(along)
	return ""


## The vector of the line: end minus start.
func v() -> Vec2:
	return end.minus(start)


## Whether [method v] has a direction, and so normals: it is not zero.
func has_direction() -> bool:
	return v().length() > 0.0


## Whether the mistake that is switched on leads to a wrong normal of this v.
func is_mistaken() -> bool:
	match mistake:
		NormalsMistakes.WRONG_NORMAL:
			return has_direction()
		NormalsMistakes.ZERO_VECTOR:
			return not has_direction()
		NormalsMistakes.CUT_LENGTH:
			return has_direction() and v().length() < 1.0
	return false


## The normal (-y, x): +90 degrees from [method v], of the same length. Zero for a zero v.
func normal() -> Vec2:
	var along := v()
	return Vec2.new(-along.y, along.x)


## The opposite normal (y, -x).
func opposite() -> Vec2:
	return normal().negated()


## The unit normal: [method normal] divided by its length. Zero for a zero v.
func unit() -> Vec2:
	return v().normal()


## The unit normal [member times] over.
func scaled() -> Vec2:
	return unit().scaled(times)


## The middle of the line, where the unit normal is drawn [member times] over.
func middle() -> Vec2:
	return start.lerped(end, 0.5)


## The ends of all that is drawn of the line and its normals.
func points_to_show() -> Array[Vec2]:
	var points: Array[Vec2] = [start, end]
	for arm: Vec2 in [normal(), opposite(), unit()]:
		points.append(start.plus(arm))
	if mistake == 0:
		points.append(middle().plus(scaled()))
	return points


## What has happened to the line since it began at [param old_start] with the vector [param old_v];
## [constant Change.NONE] where either has no direction.
func change_since(old_start: Vec2, old_v: Vec2) -> Change:
	if v().equals_approx(old_v, 0.0):
		return Change.NONE if start.equals_approx(old_start, 0.0) else Change.MOVED
	if not has_direction() or old_v.length() == 0.0:
		return Change.NONE
	if v().normalized().equals_approx(old_v.normalized(), SAME_DIRECTION):
		return Change.STRETCHED
	return Change.TURNED


## The angle by which the line has been turned since its vector was [param old_v], in degrees, in
## (-180, 180].
func turned_degrees(old_v: Vec2) -> float:
	return Vec2.rad_to_deg(old_v.angle_to(v()))


## All of it, for undo and links.
func to_dictionary() -> Dictionary:
	return {
		"line": PackedFloat64Array([start.x, start.y, end.x, end.y]),
		"times": times,
		"mistake": mistake,
	}


## "" if the mistake is one of [NormalsMistakes]; else a sentence with those that are.
func problem_in(stored: Dictionary) -> String:
	var number: int = stored["mistake"]
	return StateCheck.mistake(number, NormalsMistakes.infos())


## Puts back what [method to_dictionary] has told.
func from_dictionary(stored: Dictionary) -> void:
	var ends: PackedFloat64Array = stored["line"]
	start.set_xy(ends[0], ends[1])
	end.set_xy(ends[2], ends[3])
	times = stored["times"]
	mistake = stored["mistake"]


## A model of its own with the same numbers.
func copy() -> NormalsModel:
	var same := NormalsModel.new()
	same.from_dictionary(to_dictionary())
	return same
