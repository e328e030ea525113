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
@onready var _passed: TargetMark = %Passed
@onready var _bullet: BallView = %Bullet
@onready var _rings: HitRings = %Rings
@onready var _sight: Handle = %Sight


func _ready() -> void:
	# Without a graphics card the paper and the field take a third of a frame. They are drawn once.
	(%Grid as Grid).take(_field)


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
	# Where it has hit it stays, at the end of its way.
	var seen := model.shot if model.shot else model.landed
	_bullet.visible = seen != null
	_trail.visible = seen != null
	if seen:
		var flown := clampf(model.time - seen.fired_at, 0.0, seen.hit_after)
		_bullet.lay(seen.place_after(flown), GameLevel.BULLET)
		_trail.show_path(seen.way_until(flown))
	_lay_miss(model)


# The way of a miss stays, to learn from, with the target where it was when the bullet was nearest.
func _lay_miss(model: AimingGameModel) -> void:
	var missed := model.missed
	_missed.visible = missed != null
	_passed.visible = missed != null and model.level().target.speed != 0.0
	if missed and missed != _drawn_miss:
		_missed.show_path(missed.way_until(missed.gone_after))
		_passed.lay(missed.passed, GameTarget.RADIUS)
	_drawn_miss = missed
