class_name ProjectionProofTexts
extends RefCounted
## The sentences of the proof, step by step.

## The steps, counted from 0.
enum Step { WANTED, TURN, READ_OFF, EXPAND, TRIANGLE, PUT_IN, COMPARE }

## The unit vector along b.
const UNIT := "b\u0302"


## One sentence a step, translated.
static func sentences(model: ProjectionProofModel) -> PackedStringArray:
	if not model.has_direction():
		var refusal := LabText.translate(
			"b is zero: it has no direction, so there is no β. Drag b away."
		)
		var refusals: PackedStringArray = []
		refusals.resize(Step.size())
		refusals.fill(refusal)
		return refusals
	return [
		_first_sentence(model),
		LabText.translate("Turn both by −β until b lies on the x axis. No length changes."),
		LabText.translate("Now the shadow lies on the x axis: its signed length is the x of a′."),
		LabText.translate("Turning by −β gives a′.x. Use cos(−β) = cos β and sin(−β) = −sin β."),
		LabText.translate("The triangle of b holds cos β and sin β: its sides divided by |b|."),
		LabText.translate("Put them in: what comes out is a · b̂. No angle is left in it."),
		LabText.translate("Both sides, computed in two ways: do they agree to the last bit?"),
	]


## What is asked before the turn, translated.
static func question_on_turn() -> String:
	return LabText.translate(
		"Both turn until b lies on the x axis. Where does the head of a go? Drag the “?” there."
	)


## What is asked before the shadow is read off, translated.
static func question_on_shadow() -> String:
	return LabText.translate("What is the signed length of the shadow p now?")


## The answers to [method question_on_shadow]; the first is right.
static func choices() -> PackedStringArray:
	return [
		LabText.translate("the x of a′"),
		LabText.translate("the x of a"),
		LabText.translate("the length of a′")
	]


## The place of the right one of [method choices]; -1 where another one is as long, or b is zero.
static func right_choice(model: ProjectionProofModel) -> int:
	var right := model.x_of_turned_a()
	var nearly := 1e-9 * model.a.length()
	for wrong: float in [model.a.x, model.a.length()]:
		if absf(wrong - right) <= nearly:
			return -1
	return 0 if model.has_direction() else -1


# While time runs at the first step, the turn is under way already.
static func _first_sentence(model: ProjectionProofModel) -> String:
	if model.turned_share > 0.0:
		return LabText.translate("Both turn by −β until b lies on the x axis.")
	return LabText.translate(
		"Wanted: p, the shadow of a on b. What is its signed length, the scalar projection?"
	)


## Both sides with all their digits, and in words how far they are apart, translated.
static func comparison(model: ProjectionProofModel) -> PackedStringArray:
	if not model.has_direction():
		return [LabText.translate("b is zero: no direction, no shadow")]
	return [
		"a′.x = %s" % NumberText.all_digits(model.x_of_turned_a()),
		"a · %s = %s" % [UNIT, NumberText.all_digits(model.dot_with_unit())],
		_agreement(model),
	]


static func _agreement(model: ProjectionProofModel) -> String:
	# Below a power of 2 the doubles are twice as close: half a unit is the least there.
	var units := ceilf(model.units_apart())
	if units == 0.0:
		return LabText.translate("equal to the last bit")
	if units == 1.0:
		return LabText.translate("1 unit in the last place apart")
	if model.is_rounding():
		return LabText.translate("Both mean 0: only rounding is left")
	return LabText.translate("%s units in the last place apart") % NumberText.short(units)
