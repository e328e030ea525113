class_name AimingGameModel
extends LessonModel
## The game on aiming: a level, a barrel that is turned by hand or by helpers, and a bullet.
##
## Level, helpers and the barrel's angle are kept for undo and links. Time, the bullet and the score
## belong to the moment.

## The angle of the barrel at the start: it hits nothing.
const START_DEGREES := -80.0
# The barrel turns half of what is left in so many seconds.
const _HALF_LIFE := 0.05
# The plan is made anew after so many seconds: target and helpers hardly differ before.
const _PLAN_SECONDS := 0.1

## The level, from 1.
var level_number := 1
## The angle of the barrel as it was turned by hand, in degrees, clockwise on screen.
var hand_degrees := START_DEGREES
## Whether the barrel turns by itself to where the helpers aim.
var aims := false
## Whether the helpers look ahead of a target that moves.
var leads := false
## Whether they know of gravity.
var falls := false
## Whether they look for a way over walls.
var bounces := false

## Seconds since the level began.
var time := 0.0
## The bullet; null while there is none.
var shot: GameShot
## Bullets fired in each level, by its number.
var shots_in: Dictionary[int, int] = {}
## The levels that have been hit, by their numbers.
var levels_hit: Dictionary[int, bool] = {}
## The last bullet, if it has missed; else null.
var missed: GameShot
## The bullet that has hit the target of this level; null while none has.
var landed: GameShot
## When the target of this level was hit, in seconds since the level began; INF while it was not.
var hit_at := INF

var _levels := GameLevel.all()
var _barrel := deg_to_rad(START_DEGREES)
var _plan: GameAim
var _planned_at := -INF


## The level that is played.
func level() -> GameLevel:
	return _levels[level_number - 1]


## How many levels there are.
func level_count() -> int:
	return _levels.size()


## Whether any helper is switched on.
func has_helper() -> bool:
	return aims or leads or falls or bounces


## Whether the target of this level has been hit.
func is_won() -> bool:
	return hit_at < INF


## Where the target is now; where it was hit it stays.
func target_place() -> Vec2:
	return level().target.place_at(minf(time, hit_at))


## How long ago the last bullet missed, in seconds.
func seconds_since_miss() -> float:
	return time - missed.fired_at - missed.gone_after if missed else INF


## The direction of the barrel, length 1.
func barrel() -> Vec2:
	return Vec2.unit_radians(_barrel)


## Where the helpers aim now; null where none is switched on. Made anew some ten times a second;
## while a bullet flies, it stays as it was.
func plan() -> GameAim:
	if not has_helper():
		return null
	if shot and _plan:
		return _plan
	if _plan == null or time - _planned_at > _PLAN_SECONDS or time < _planned_at:
		_plan = _plan_now()
		_planned_at = time
	return _plan


## Turns the barrel by hand to [param point]. From then on it does not turn by itself.
func aim_at(point: Vec2) -> void:
	if point.distance_to(level().gun) > 0.0 and not is_won():
		turn_to(rad_to_deg(Turn.toward(level().gun, point)))
		aims = false


## Turns the barrel to so many [param degrees], clockwise on screen.
func turn_to(degrees: float) -> void:
	hand_degrees = degrees
	_barrel = deg_to_rad(degrees)


## Fires, unless a bullet flies or the level is won. Returns whether it has.
func fire() -> bool:
	if shot or is_won():
		return false
	_forget_plan()
	if aims and plan().hit:
		_barrel = plan().direction.angle_radians()
	shot = GameShot.new(level(), barrel(), time)
	shots_in[level_number] = shots_in.get(level_number, 0) + 1
	missed = null
	return true


## Lets [param seconds] pass.
func advance(seconds: float) -> void:
	time += seconds
	if aims and plan().hit and not shot and not is_won():
		var wanted := plan().direction.angle_radians()
		_barrel = Turn.eased(_barrel, wanted, _HALF_LIFE, seconds)
	if shot and shot.is_over(time):
		if shot.hit_after < INF:
			hit_at = shot.fired_at + shot.hit_after
			landed = shot
			levels_hit[level_number] = true
		else:
			missed = shot
		shot = null


## Whether all levels have been hit.
func is_complete() -> bool:
	return levels_hit.size() == level_count()


## Goes to the next level that has not been hit, after the last one from the first. When all have
## been hit, the game begins anew.
func go_on() -> void:
	if is_complete():
		levels_hit.clear()
		shots_in.clear()
		level_number = 0
	for step in level_count():
		level_number = level_number % level_count() + 1
		if not levels_hit.has(level_number):
			break
	begin_level()


## Begins the level anew; the score stays.
func begin_level() -> void:
	time = 0.0
	shot = null
	hit_at = INF
	missed = null
	landed = null
	_forget_plan()
	_barrel = deg_to_rad(hand_degrees)


## All bullets that have been fired.
func all_shots() -> int:
	var count := 0
	for number: int in shots_in.values():
		count += number
	return count


## Takes other values for a part of the state; another level begins anew.
func take(changes: Dictionary) -> String:
	var problem := super(changes)
	if not problem and changes.has("level"):
		begin_level()
	return problem


func to_dictionary() -> Dictionary:
	return {
		"level": level_number,
		"angle": hand_degrees,
		"aims": aims,
		"leads": leads,
		"falls": falls,
		"bounces": bounces,
	}


func problem_in(stored: Dictionary) -> String:
	var number: int = stored["level"]
	var angle: float = stored["angle"]
	return (
		StateCheck
		. first(
			[
				StateCheck.within("level", number, 1.0, level_count()),
				StateCheck.within("angle", angle, -180.0, 180.0),
			]
		)
	)


func from_dictionary(stored: Dictionary) -> void:
	var is_other: bool = stored["level"] != level_number
	level_number = stored["level"]
	hand_degrees = stored["angle"]
	aims = stored["aims"]
	leads = stored["leads"]
	falls = stored["falls"]
	bounces = stored["bounces"]
	_forget_plan()
	if is_other:
		begin_level()
	elif not aims:
		_barrel = deg_to_rad(hand_degrees)


func _plan_now() -> GameAim:
	return GameAim.of(level(), time, leads, falls, bounces)


func _forget_plan() -> void:
	_plan = null
	_planned_at = -INF
