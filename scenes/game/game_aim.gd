class_name GameAim
extends RefCounted
## Where the helpers that are switched on aim: at the target as it is; ahead of it; over what
## gravity takes away; at its mirror image. Each helper knows one thing, and only that.

## Why there is no shot: the target gets away; no arc reaches it; no way over the walls.
enum Outcome { HIT, OUTRUN, OUT_OF_REACH, NO_WAY }

## What a helper that is switched off would have seen: the bullet falls; the target is elsewhere by
## then, or has turned round; a wall is in the way.
enum Flaw { NONE, FALLS, MOVES_ON, TURNS, BLOCKED }

# The way over walls depends on where the target is then, and the other way round: so often the one
# is found from the other, until the place stays within so many pixels.
const _ROUNDS := 12
const _STAYS := 1e-3
const _MOST_BOUNCES := 2
# No shot is followed longer, in seconds.
const _LONGEST := 4.0

## Whether there is a direction.
var hit := false
## In which direction to shoot, length 1.
var direction: Vec2
## Seconds until the helpers expect the bullet at the target.
var time := 0.0
## Where they expect it then.
var meeting: Vec2
## Why there is a shot, or why there is none.
var outcome := Outcome.HIT
## Why the shot will miss all the same.
var flaw := Flaw.NONE


## For a shot at [param now], in seconds since the level began, with these helpers switched on.
static func of(level: GameLevel, now: float, leads: bool, falls: bool, bounces: bool) -> GameAim:
	var aim := _found(level, now, leads, falls, bounces)
	if aim.hit:
		aim.flaw = aim._flaw_in(level, now, leads, falls and not bounces)
	return aim


static func _found(
	level: GameLevel, now: float, leads: bool, falls: bool, bounces: bool
) -> GameAim:
	if bounces:
		return _over_walls(level, now, leads)
	var velocity := level.target.velocity_at(now) if leads else Vec2.zero()
	var target := AimTarget.new(level.target.place_at(now), velocity)
	if falls:
		return _in_an_arc(level, target)
	return _from(LeadAim.first(level.gun, target, GameLevel.SPEED))


# The first arc on which no wall is in the way; else the flattest.
static func _in_an_arc(level: GameLevel, target: AimTarget) -> GameAim:
	var arcs := BallisticAim.at_moving(level.gun, target, level.gravity, GameLevel.SPEED, _LONGEST)
	for arc in arcs:
		var shot := GameShot.fired(level, arc.direction)
		if shot.place_after(arc.time).distance_to(arc.target) < 1.0:
			return _from(arc)
	return _from(arcs[0]) if arcs else _none(Outcome.OUT_OF_REACH)


static func _over_walls(level: GameLevel, now: float, leads: bool) -> GameAim:
	for bounces in range(1, _MOST_BOUNCES + 1):
		var found := _none(Outcome.NO_WAY)
		for round_number in _ROUNDS if leads else 1:
			var meeting_place := level.target.place_at(now + found.time)
			var way := BankAim.first(
				level.gun, meeting_place, GameLevel.BULLET, 1.0, level.walls, bounces
			)
			found.hit = way.hit
			var stays := found.meeting != null and meeting_place.distance_to(found.meeting) < _STAYS
			if not way.hit or stays:
				break
			found.direction = way.direction
			found.time = way.distance / GameLevel.SPEED
			found.meeting = meeting_place
		if found.hit:
			found.outcome = Outcome.HIT
			return found
	return _none(Outcome.NO_WAY)


static func _from(aim: Aim) -> GameAim:
	if not aim.hit:
		return _none(Outcome.OUTRUN if aim.outcome == Aim.Outcome.OUTRUN else Outcome.OUT_OF_REACH)
	var found := GameAim.new()
	found.hit = true
	found.direction = aim.direction
	found.time = aim.time
	found.meeting = aim.target
	return found


static func _none(why: Outcome) -> GameAim:
	var found := GameAim.new()
	found.outcome = why
	return found


func _flaw_in(level: GameLevel, now: float, leads: bool, falls: bool) -> Flaw:
	if level.gravity.length() > 0.0 and not falls:
		return Flaw.FALLS
	if meeting.distance_to(level.target.place_at(now + time)) > GameLevel.reach():
		return Flaw.TURNS if leads else Flaw.MOVES_ON
	var place := GameShot.fired(level, direction).place_after(time)
	return Flaw.NONE if place.distance_to(meeting) < GameLevel.reach() else Flaw.BLOCKED
