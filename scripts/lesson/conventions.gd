class_name Conventions
extends RefCounted
## How the whole lab shows angles and the y axis, as the student has chosen: in degrees or radians,
## signed or from 0 to a full turn, y down or up.
##
## Numbers are shown otherwise, never computed otherwise: [Vec2] returns angles in (-180, 180], and
## y of a vector stays what it is.

## What can be chosen. Without a choice: degrees, y down, angles from -180 to 180.
enum Choice { RADIANS, Y_UP, FULL_TURN }

const _KEYS: Dictionary[Choice, String] = {
	Choice.RADIANS: "angles_in_radians",
	Choice.Y_UP: "y_up",
	Choice.FULL_TURN: "angles_to_full_turn"
}
# An angle this close to a multiple of 5 degrees is that multiple: what is left is rounding.
const _SAME_DEGREES := 2e-13
# A multiple of 5 degrees is a whole number of these shares of pi.
const _SHARES_OF_PI := 36
const _LARGEST_SHARE := 3600.0
# An angle that is written in a text, without its sign.
const _WRITTEN := "(\\d+(?:\\.\\d+)?)°"

# What a link has asked for; it is not kept.
static var _for_now: Dictionary[Choice, bool] = {}
static var _teller := Teller.new()
static var _finder := RegEx.create_from_string(_WRITTEN)


## Tells of changes.
class Teller:
	extends RefCounted
	## Something else was chosen.
	signal changed


## The signal that something else was chosen: what is shown has to be shown anew.
static func changed() -> Signal:
	return _teller.changed


## Whether angles are in radians.
static func uses_radians() -> bool:
	return is_chosen(Choice.RADIANS)


## Whether y points up where a lesson lets it.
static func is_y_up() -> bool:
	return is_chosen(Choice.Y_UP)


## Whether the angles of vectors and turns go from 0 to 360 degrees.
static func has_full_turn() -> bool:
	return is_chosen(Choice.FULL_TURN)


## Whether [param choice] differs from what is shown without a choice. The editor has no choices.
static func is_chosen(choice: Choice) -> bool:
	if Engine.is_editor_hint():
		return false
	if _for_now.has(choice):
		return _for_now[choice]
	return KeptChoices.value(_KEYS[choice], false)


## The student has chosen; it is kept for the next time.
static func choose(choice: Choice, on: bool) -> void:
	_for_now.erase(choice)
	KeptChoices.keep(_KEYS[choice], on)
	_teller.changed.emit()


## The same as long as the lab runs, or until the student chooses: a link has asked for it.
static func choose_for_now(choice: Choice, on: bool) -> void:
	if is_chosen(choice) != on:
		_for_now[choice] = on
		_teller.changed.emit()


## The angle of a vector, or a turn, as it is shown: from 0 on where a full turn is chosen.
static func in_range(degrees: float) -> float:
	return fposmod(degrees, 360.0) if has_full_turn() else degrees


## The number that is shown for [param degrees]: itself, or radians.
static func shown(degrees: float) -> float:
	return Vec2.deg_to_rad(degrees) if uses_radians() else degrees


## The degrees of an angle that a student has typed in the unit that is shown.
static func typed(angle: float) -> float:
	return Vec2.rad_to_deg(angle) if uses_radians() else angle


## [param degrees] as a share of pi, such as `−3π/4`, where radians are shown and it is one: a
## multiple of 5 degrees, and not 0; else "".
static func share_of_pi(degrees: float) -> String:
	var fives := roundf(degrees / 5.0)
	if not uses_radians() or fives == 0.0 or absf(degrees) > _LARGEST_SHARE:
		return ""
	if absf(degrees - fives * 5.0) > _SAME_DEGREES:
		return ""
	var shares := absi(int(fives))
	var common := _common_divisor(shares, _SHARES_OF_PI)
	var above := roundi(float(shares) / common)
	var below := roundi(float(_SHARES_OF_PI) / common)
	var text := "π" if above == 1 else "%dπ" % above
	if below > 1:
		text += "/%d" % below
	return NumberText.MINUS + text if fives < 0.0 else text


## [param degrees] with its unit, at most [param digits] significant digits: `53.13°`, `0.9273 rad`,
## `π/2`.
static func angle_text(degrees: float, digits: int = 4) -> String:
	var text := mark_text(degrees, digits)
	return text + " rad" if uses_radians() and not text.contains("π") else text


## The same for an arc or an axis, where there is little room: radians without their unit.
static func mark_text(degrees: float, digits: int = 4) -> String:
	var share := share_of_pi(degrees)
	var text := share if share else NumberText.short(shown(degrees), digits)
	return text if uses_radians() else text + "°"


## [param text], in which angles are written in degrees, such as `above 90°`, in the unit that is
## shown: `above π/2`.
static func in_unit(text: String) -> String:
	if not uses_radians():
		return text
	var found := ""
	var at := 0
	for angle in _finder.search_all(text):
		found += text.substr(at, angle.get_start() - at)
		found += angle_text(angle.get_string(1).to_float())
		at = angle.get_end()
	return found + text.substr(at)


static func _common_divisor(one: int, other: int) -> int:
	while other != 0:
		var rest := one % other
		one = other
		other = rest
	return one
