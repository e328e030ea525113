class_name AimExercise
extends Exercise
## Asks for the barrel's own angle, for the short way round, or for the nozzle, with fresh numbers.
## Angles are whole tens of degrees, and are answered in degrees.

## What is asked for.
enum Kind { OWN_ANGLE, SHORT_WAY, NOZZLE }

# Directions of length 5.
const _DIRECTIONS: Array[Vector2i] = [
	Vector2i(4, 3), Vector2i(3, 4), Vector2i(4, -3), Vector2i(-3, 4), Vector2i(-4, -3)
]

var _solution := ""
var _board := {}


## A question of this kind with three numbers: the angles of the target and of the hull; those of
## barrel and target; or the place of a direction in its list, a length, and fifths of a distance.
func _init(kind: Kind, first: int, second: int, third: int = 0) -> void:
	match kind:
		Kind.OWN_ANGLE:
			_ask_own_angle(first, second)
		Kind.SHORT_WAY:
			_ask_short_way(first, second)
		Kind.NOZZLE:
			_ask_nozzle(_DIRECTIONS[first], second, third)


## A question with numbers drawn from [param rng].
static func fresh(kind: Kind, rng: RandomNumberGenerator) -> AimExercise:
	match kind:
		Kind.OWN_ANGLE:
			return new(kind, 10 * rng.randi_range(-17, 18), 10 * rng.randi_range(-17, 17))
		Kind.SHORT_WAY:
			# So far apart that the short way leads over 180 degrees.
			var from := 10 * rng.randi_range(10, 17)
			var to := from - 10 * rng.randi_range(20, 34)
			var side := 1 if rng.randf() < 0.5 else -1
			return new(kind, side * from, side * to)
	var length := 10 * rng.randi_range(2, 8)
	return new(kind, rng.randi_range(0, _DIRECTIONS.size() - 1), length, 10 * rng.randi_range(4, 9))


## The question with the numbers of the lesson's start; null where it has none.
static func of_the_table(kind: Kind) -> AimExercise:
	match kind:
		Kind.OWN_ANGLE:
			return new(kind, 90, 30)
		Kind.SHORT_WAY:
			return new(kind, 135, -135)
	return null


func board_state() -> Dictionary:
	return _board


func solution() -> String:
	return _solution


func _ask_own_angle(seen: int, hull: int) -> void:
	var right := AimAtModel.short(seen - hull)
	var sentence := tr("The hull is turned to α = %s, and sees the target at θ = %s.")
	prompt = sentence % [_angle(hull), _angle(seen)] + " "
	prompt += tr("What is the barrel's own angle, within ±180°?")
	answer_titles = [tr("in degrees =")]
	right_answer = [right]
	_solution = "θ − α = %s − %s = %s" % [_angle(seen), _factor(hull), _angle(right)]
	_board = {"hull_degrees": float(hull)}
	_add(seen, tr("That is θ: the hull has turned the barrel by α already."))
	_add(AimAtModel.short(seen + hull), tr("α is taken off, not added."))
	_add(-right, tr("The other way round: θ − α, not α − θ."))
	if absf(seen - hull) > 180.0:
		_add(seen - hull, tr("That is more than half a turn: add or subtract 360°."))


func _ask_short_way(from: int, to: int) -> void:
	var right := AimAtModel.short(to - from)
	var sentence := tr("The barrel points along %s, the target is at %s.")
	prompt = sentence % [_angle(from), _angle(to)] + " "
	prompt += tr("By how much does it turn, the short way? Clockwise is positive.")
	answer_titles = [tr("in degrees =")]
	right_answer = [right]
	var raw := float(to - from)
	var added := "+ 360°" if raw < 0.0 else "− 360°"
	_solution = "%s − %s %s = %s" % [_angle(to), _factor(from), added, _angle(right)]
	_add(raw, tr("That is the long way round: add or subtract 360°."))
	_add(-raw, tr("That is the long way round, and the other way."))
	_add(-right, tr("That turns the other way: it is target less barrel."))
	_add(AimAtModel.short(to + from), tr("The angles are subtracted, not added."))


func _ask_nozzle(direction: Vector2i, length: int, fifth: int) -> void:
	var way := Vec2.new(direction.x * fifth, direction.y * fifth)
	var mount := Vec2.new(-direction.x * 10.0, -direction.y * 10.0)
	var unit := way.normalized()
	var right := mount.plus(unit.scaled(length))
	var at := mount.plus(way)
	var sentence := tr("A barrel of length %s is mounted at P = %s and points at T = %s.")
	prompt = sentence % [NumberText.short(length), _pair(mount), _pair(at)] + " "
	prompt += tr("Where is its nozzle?")
	answer_titles = ["x =", "y ="]
	right_answer = [right.x, right.y]
	var numbers := [_pair(mount), NumberText.short(length), _pair(unit), _pair(right)]
	_solution = "P + L d = %s + %s %s = %s" % numbers
	_board = {"hull": [mount.x, mount.y], "target": [at.x, at.y], "length": float(length)}
	_add_place(unit.scaled(length), tr("That is L d alone: it begins at P."))
	_add_place(mount.plus(unit), tr("That is P + d: the barrel is L long."))
	_add_place(
		mount.plus(way.scaled(length)), tr("T − P is not of length 1: divide by its length.")
	)
	_add_place(mount.minus(unit.scaled(length)), tr("That is the other end: P + L d, not P − L d."))
	_add_place(at, tr("That is the target."))


func _add(answer: float, sentence: String) -> void:
	add_mistake([answer], sentence)


func _add_place(place: Vec2, sentence: String) -> void:
	add_mistake([place.x, place.y], sentence)


static func _angle(degrees: float) -> String:
	return NumberText.short(degrees) + "°"


static func _factor(degrees: float) -> String:
	return "(%s)" % _angle(degrees) if degrees < 0.0 else _angle(degrees)


static func _pair(vector: Vec2) -> String:
	return NumberText.pair(vector.x, vector.y)
