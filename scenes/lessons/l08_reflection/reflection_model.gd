class_name ReflectionModel
extends LessonModel
## A ball that meets a line at the origin, and what becomes of its velocity.
##
## Velocities in units per second. The line goes through the origin, from minus [member along] to
## plus along; the ball touches it there at time 0.

## How the drawing is built up. From the second one on, each step says how many times the part along
## the normal is subtracted; the first one shows the ball as it bounces, and the last one asks
## whether it is reflected once more in the next frame.
enum Step { MEET, SPLIT, SLIDE, MIRROR, BOUNCE, NEXT_FRAME }

## Presets by their titles (source text): what each changes in the model's state.
const PRESETS: Dictionary[String, Dictionary] = {
	"Lecture": {velocity = [3, 4], along = [-7, 0], bounciness = 1.0, has_unit_normal = true},
	"C = 0.5": {velocity = [3, 4], along = [-7, 0], bounciness = 0.5, has_unit_normal = true},
	"Angled": {velocity = [0, 5], along = [-8, -6], bounciness = 1.0, has_unit_normal = true},
	"Head-on": {velocity = [0, 5], along = [-7, 0], bounciness = 0.8, has_unit_normal = true},
	"Along": {velocity = [4, 0], along = [-7, 0], bounciness = 1.0, has_unit_normal = true},
}

## The flight begins this many seconds before the ball touches the line; the time is then negative.
const START := -1.2
## The flight ends this many seconds after the ball has touched the line.
const END := 1.6
## No number is larger than this: its square still fits into the 32 bits of Godot's Vector2, which
## is shown beside ours.
const LARGEST := 1e18
# The bounciness with which one that acts along the line shows.
const _SHOWING_BOUNCINESS := 0.5
## How far from 1 the length of a normal may be: as in [method Vec2.reflect].
const NORMAL_TOLERANCE := 1e-9

## The velocity with which the ball comes.
var velocity := Vec2.new(3.0, 4.0)
## Half of the line that is drawn, from the origin to one end; never zero.
var along := Vec2.new(-7.0, 0.0)
## The bounciness C (coefficient of restitution), 0..1.
var bounciness := 1.0
## False takes a normal of [member normal_length] instead of one of length 1.
var has_unit_normal := true
## The length of the normal where it is not 1.
var normal_length := 2.0
## The number of the mistake that is switched on; 0 for none.
var mistake := 0
## Seconds since the ball touched the line, within [constant START] to [constant END].
var time := START:
	set(value):
		time = clampf(value, START, END)

# Whether a mistake has taken another bounciness.
var _lends_bounciness := false


## The normal of length 1.
func unit_normal() -> Vec2:
	return along.normal()


## The normal that is handed to reflect: of length 1, or of [member normal_length].
func used_normal() -> Vec2:
	return unit_normal() if has_unit_normal else unit_normal().scaled(normal_length)


## The unit normal on the side from which the ball comes: v . n is not above 0 for it.
func facing_normal() -> Vec2:
	return unit_normal() if faces_ball() else unit_normal().negated()


## "" if the normal can be used; else the sentence with which [method Vec2.reflect] refuses it.
func refusal() -> String:
	var size := used_normal().length()
	if absf(size - 1.0) <= NORMAL_TOLERANCE:
		return ""
	return tr("Vec2.reflect: the normal must have length 1, but has length %s.") % size


## What the normal that is handed to reflect is called: one that is refused is no unit normal.
func normal_symbol() -> String:
	return "n" if refusal() else "n̂"


## Whether [method unit_normal] points to the side from which the ball comes.
func faces_ball() -> bool:
	return velocity.dot(unit_normal()) <= 0.0


## The velocity of the next frame: after the bounce.
func velocity_out() -> Vec2:
	return velocity_after(1.0 + bounciness)


## Whether the ball moves away from the line after the bounce; with C = 0 it slides along it.
func leaves_line() -> bool:
	return velocity_out().dot(facing_normal()) > velocity.length() / 2.0 ** 50


## (v . n) n with the unit normal: the part of the velocity along the normal.
func normal_part() -> Vec2:
	return normal_part_of(velocity)


## The same for [param moving], another velocity.
func normal_part_of(moving: Vec2) -> Vec2:
	return moving.vector_projection(unit_normal())


## Whether the ball moves along the line, or not at all: what rounding leaves of v . n counts as 0.
func is_along_line() -> bool:
	return absf(velocity.dot(unit_normal())) <= velocity.length() / 2.0 ** 50


## Whether the ball stops where the part along the normal was subtracted [param times] times: what
## rounding leaves of the velocity counts as 0. A ball that comes straight at the line does after
## once.
func stops_after(times: float) -> bool:
	return velocity_after(times).length() <= velocity.length() / 2.0 ** 50


## How many times the part along the normal is subtracted at [param step]; never where the normal is
## refused.
func times_subtracted(step: Step) -> float:
	if refusal() or step == Step.SPLIT:
		return 0.0
	if step in [Step.MEET, Step.BOUNCE, Step.NEXT_FRAME]:
		return 1.0 + bounciness
	return 1.0 if step == Step.SLIDE else 2.0


## The velocity after the part along the normal was subtracted [param times] times: 0, or 1 to 2.
func velocity_after(times: float) -> Vec2:
	return velocity.copy() if times == 0.0 else velocity.reflected(unit_normal(), times - 1.0)


## What [method Vec2.reflected] answers: the velocity as it was where the normal is refused.
func reflected() -> Vec2:
	return velocity.copy() if refusal() else velocity.reflected(used_normal(), bounciness)


## The velocity to which the mistake that is switched on leads; [member velocity] where none is.
func velocity_with_mistake() -> Vec2:
	return ReflectionMistakes.velocity_after(
		mistake, velocity, unit_normal(), normal_length, bounciness
	)


## Whether the mistake that is switched on leads to another velocity than the right one.
func mistake_shows() -> bool:
	var off := velocity_with_mistake().distance_to(velocity.reflected(unit_normal(), bounciness))
	return mistake != 0 and off > 1e-9 * velocity.length()


## The angle in degrees between the way back of the ball and the normal, 0..90.
func angle_in_degrees() -> float:
	return absf(Vec2.rad_to_deg(facing_normal().angle_to(velocity.negated())))


## The angle in degrees between [param leaving] and the normal on the ball's side, 0..180.
func angle_out_degrees(leaving: Vec2) -> float:
	return absf(Vec2.rad_to_deg(facing_normal().angle_to(leaving)))


## Whether the ball leaves at the angle to the normal at which it came, after the part along the
## normal was subtracted [param times] times. Below 2 only head on or along the line. A ball that
## stops does not leave.
func has_equal_angles(times: float) -> bool:
	if times == 2.0 or stops_after(times):
		return times == 2.0
	return absf(angle_out_degrees(velocity_after(times)) - angle_in_degrees()) < 1e-9


## Which share of the kinetic energy [param leaving] has; 1 for a ball at rest.
func energy_share(leaving: Vec2) -> float:
	var speed := velocity.length()
	return (leaving.length() / speed) ** 2.0 if speed > 0.0 else 1.0


## Heads, tails, line ends, and the ball where its flight begins and ends.
func places_to_keep_free() -> Array[Vec2]:
	var out := velocity_out()
	return [
		velocity.negated(),
		velocity.scaled(START),
		velocity,
		out,
		out.scaled(END),
		along,
		along.negated(),
	]


## The centre of a ball of [param radius] at [member time], if it leaves with [param leaving].
func ball_centre(radius: float, leaving: Vec2) -> Vec2:
	var centre := facing_normal().scaled(radius)
	centre.add((velocity if time < 0.0 else leaving).scaled(time))
	return centre


## The same for the mistake that is switched on.
func ball_centre_with_mistake(radius: float) -> Vec2:
	if mistake != ReflectionMistakes.REFLECTED_AGAIN or time <= 0.0:
		return ball_centre(radius, velocity_with_mistake())
	var way := ReflectionMistakes.way_reflected_again(velocity, unit_normal(), bounciness, time)
	return facing_normal().scaled(radius).plus(way)


## Turns the line so that its normal points along [param direction]. A zero direction is not taken.
func point_normal(direction: Vec2) -> void:
	var unit := direction.normalized()
	if unit.length() > 0.0:
		along = Vec2.new(unit.y, -unit.x).scaled(along.length())


## Takes the bounciness, 0..1 in steps of 0.05, with which the ball leaves most nearly with the
## velocity [param leaving]. A ball that moves along the line keeps the bounciness as it is.
func fit_bounciness(leaving: Vec2) -> void:
	var into := velocity.dot(unit_normal())
	if into != 0.0:
		bounciness = roundf(20.0 * clampf(-leaving.dot(unit_normal()) / into, 0.0, 1.0)) / 20.0


## Switches a mistake on, or off for 0. With C = 1 the bounciness does nothing, on whichever part it
## acts: that mistake takes a C with which it shows, and gives it back.
func show_mistake(number: int) -> void:
	mistake = number
	if number == ReflectionMistakes.BOUNCY_TANGENT and bounciness == 1.0:
		bounciness = _SHOWING_BOUNCINESS
		_lends_bounciness = true
	elif number != ReflectionMistakes.BOUNCY_TANGENT and _lends_bounciness:
		_lends_bounciness = false
		if bounciness == _SHOWING_BOUNCINESS:
			bounciness = 1.0


## Takes a typed number by its name in the formula lines. "" if it could be taken; else one sentence
## with the value and what is allowed.
func enter(name_in_line: String, value: float) -> String:
	var line := along.copy()
	var too_large := StateCheck.within(name_in_line, value, -LARGEST, LARGEST)
	if too_large:
		return too_large
	match name_in_line:
		"vx":
			velocity.x = value
		"vy":
			velocity.y = value
		"lx":
			line.x = value
		"ly":
			line.y = value
		"C":
			return _enter_bounciness(value)
		"n_length":
			return _enter_normal_length(value)
	if line.length() == 0.0:
		return TranslationServer.translate(
			"The line (0, 0) has no direction: x and y must not both be 0."
		)
	along = line
	return ""


func _enter_bounciness(value: float) -> String:
	if value < 0.0 or value > 1.0:
		var sentence := TranslationServer.translate("C must be within 0..1, but is %s.")
		return sentence % NumberText.short(value)
	bounciness = value
	return ""


func _enter_normal_length(value: float) -> String:
	if value <= 0.0:
		var sentence := TranslationServer.translate("The length of n must be above 0, but is %s.")
		return sentence % NumberText.short(value)
	normal_length = value
	return ""


func to_dictionary() -> Dictionary:
	return {
		"velocity": PackedFloat64Array([velocity.x, velocity.y]),
		"along": PackedFloat64Array([along.x, along.y]),
		"bounciness": bounciness,
		"has_unit_normal": has_unit_normal,
		"normal_length": normal_length,
		"mistake": mistake,
	}


func problem_in(stored: Dictionary) -> String:
	var model := ReflectionModel.new()
	model.from_dictionary(stored)
	return (
		StateCheck
		. first(
			[
				model.enter("vx", model.velocity.x),
				model.enter("vy", model.velocity.y),
				model.enter("lx", model.along.x),
				model.enter("ly", model.along.y),
				model.enter("C", model.bounciness),
				model.enter("n_length", model.normal_length),
				StateCheck.mistake(model.mistake, ReflectionMistakes.infos()),
			]
		)
	)


func from_dictionary(stored: Dictionary) -> void:
	var of_velocity: PackedFloat64Array = stored["velocity"]
	var of_along: PackedFloat64Array = stored["along"]
	velocity.set_xy(of_velocity[0], of_velocity[1])
	along.set_xy(of_along[0], of_along[1])
	bounciness = stored["bounciness"]
	has_unit_normal = stored["has_unit_normal"]
	normal_length = stored["normal_length"]
	mistake = stored["mistake"]
