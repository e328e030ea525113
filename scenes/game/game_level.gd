class_name GameLevel
extends RefCounted
## A level of the game: a gun, a target, walls and gravity. Lengths are in pixels.

## The field that is seen: from (0, 0) to here.
const FIELD_SIZE: PackedFloat64Array = [400.0, 300.0]
## The speed of the bullet, in px/s.
const SPEED := 260.0
## The radius of the bullet.
const BULLET := 6.0

## What there is to do, translated.
var task: String
## Where the gun is mounted.
var gun := Vec2.new(50.0, 240.0)
## What is to be hit.
var target: GameTarget
## What the bullet bounces off, without loss.
var walls: Array[LineSegment] = []
## What pulls the bullet, in px/s²; the target is not pulled.
var gravity := Vec2.zero()


## Bullet and target touch where their centres are so far apart, in pixels.
static func reach() -> float:
	return BULLET + GameTarget.RADIUS


## All levels in their order.
static func all() -> Array[GameLevel]:
	return [
		_of(
			LabText.translate("Drag to turn the barrel, then fire. Or switch on Aim."),
			GameTarget.at(Vec2.new(330, 90))
		),
		_of(
			LabText.translate("It moves: aim where it will be. Lead shows where."),
			GameTarget.between(Vec2.new(330, 25), Vec2.new(330, 275), 60)
		),
		(
			_of(
				LabText.translate("The bullet falls: aim higher. Gravity shows how much."),
				GameTarget.at(Vec2.new(330, 200))
			)
			. _with_gravity(180.0)
		),
		(
			_of(
				LabText.translate("A wall hides it: bounce off the floor. Bounce shows where."),
				GameTarget.at(Vec2.new(340, 110))
			)
			. _with_gun(60, 100)
			. _with_wall(200, 190, 200, 20)
			. _with_wall(20, 280, 380, 280)
		),
		(
			_of(
				LabText.translate("A wall blocks the low arc: shoot over it."),
				GameTarget.at(Vec2.new(330, 240))
			)
			. _with_gravity(180.0)
			. _with_wall(200, 290, 200, 160)
		),
		(
			_of(
				LabText.translate("It moves, and the bullet falls: it takes two helpers."),
				GameTarget.between(Vec2.new(190, 90), Vec2.new(330, 150), 45)
			)
			. _with_gravity(150.0)
		),
		(
			_of(
				LabText.translate("Round and round, behind angled lines. Which helpers?"),
				GameTarget.around(Vec2.new(300, 110), 40.0, 60.0)
			)
			. _with_gun(50, 90)
			. _with_wall(150, 150, 210, 20)
			. _with_wall(20, 280, 300, 250)
			. _with_wall(340, 260, 390, 180)
		),
	]


static func _of(its_task: String, its_target: GameTarget) -> GameLevel:
	var level := GameLevel.new()
	level.task = its_task
	level.target = its_target
	return level


func _with_gun(x: float, y: float) -> GameLevel:
	gun = Vec2.new(x, y)
	return self


func _with_gravity(down: float) -> GameLevel:
	gravity = Vec2.new(0.0, down)
	return self


func _with_wall(from_x: float, from_y: float, to_x: float, to_y: float) -> GameLevel:
	walls.append(LineSegment.new(Vec2.new(from_x, from_y), Vec2.new(to_x, to_y)))
	return self
