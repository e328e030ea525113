class_name AimingGameDrawing
extends Node2D
## The board of the game: field, target, barrel, what the helpers plan, the bullet and its way.

## The barrel is so long, in pixels of the plane.
const BARREL := 34.0
## The handle that turns the barrel is so far from the gun.
const SIGHT := 78.0
# Without a helper the barrel points so far.
const _SIGHT_LINE := 70.0

# The plan and the miss whose ways are drawn.
var _drawn_plan: GameAim
var _drawn_miss: GameShot

@onready var _field: GameField = %Field
@onready var _target: TargetMark = %Target
@onready var _gun: GunBarrel = %Gun
@onready var _sight_line: FlightPath = %SightLine
@onready var _plan: FlightPath = %Plan
@onready var _meeting: TargetMark = %Meeting
@onready var _trail: FlightPath = %Trail
@onready var _missed: FlightPath = %Missed
@onready var _bullet: BallView = %Bullet
@onready var _rings: HitRings = %Rings
@onready var _sight: Handle = %Sight


## Shows the level of [param model] and the moment.
func show_model(model: AimingGameModel) -> void:
	_field.show_level(model.level())
	_drawn_plan = null
	show_moment(model)


## Shows what moves.
func show_moment(model: AimingGameModel) -> void:
	var level := model.level()
	_target.lay(model.target_place(), GameTarget.RADIUS)
	_target.role = Palette.Role.RIGHT if model.is_won() else Palette.Role.B
	_lay_barrel(level, model.barrel())
	_lay_plan(model)
	_lay_bullet(model)
	_rings.show_hit(model.target_place(), model.time - model.hit_at)


func _lay_barrel(level: GameLevel, direction: Vec2) -> void:
	var nozzle := level.gun.plus(direction.scaled(BARREL))
	_gun.lay(level.gun, nozzle)
	_sight.place(level.gun.plus(direction.scaled(SIGHT)))
	var line: Array[Vec2] = [nozzle, nozzle.plus(direction.scaled(_SIGHT_LINE))]
	_sight_line.show_path(line)


# A way is drawn anew only when there is another plan.
func _lay_plan(model: AimingGameModel) -> void:
	var plan := model.plan() if not model.is_won() else null
	var is_there := plan != null and plan.hit
	_plan.visible = is_there
	_meeting.visible = is_there
	if not is_there or plan == _drawn_plan:
		return
	_drawn_plan = plan
	_meeting.lay(plan.meeting, GameTarget.RADIUS)
	_plan.show_path(GameShot.way_of(model.level(), plan.direction, plan.time))


func _lay_bullet(model: AimingGameModel) -> void:
	_bullet.visible = model.shot != null
	_trail.visible = model.shot != null or model.is_won()
	# The way of a miss stays, to learn from.
	_missed.visible = model.missed != null
	if model.missed and model.missed != _drawn_miss:
		_missed.show_path(model.missed.way_until(model.missed.gone_after))
	_drawn_miss = model.missed
	if model.shot:
		var flown := maxf(model.time - model.shot.fired_at, 0.0)
		_bullet.lay(model.shot.place_after(flown), GameLevel.BULLET)
		_trail.show_path(model.shot.way_until(flown))
