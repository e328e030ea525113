class_name BankShotTexts
extends RefCounted
## The sentences and the verdict of the lesson on bank shots.

const _PRIME := "′"
const _DIGITS := "₀₁₂₃"


## The name of what is mirrored in the wall that comes at [param place] of [param count], counted
## from the last one: T′, or T₁ in the last of several walls.
static func image_symbol(place: int, count: int) -> String:
	return "T" + (_PRIME if count == 1 else _DIGITS[place])


## [param symbol] with the number [param place], counted from 1, where there are several.
static func numbered(symbol: String, place: int, count: int) -> String:
	return symbol + (_DIGITS[place] if count > 1 else "")


## One sentence a step, translated.
static func sentences(model: BankShotModel) -> PackedStringArray:
	var found: PackedStringArray = [_on_task(model)]
	if model.answer().way.images.is_empty():
		found.resize(BankShotModel.Step.size())
		for step in range(1, found.size()):
			found[step] = _as_sentence(reason(model.answer().way))
		return found
	found.append(
		LabText.translate(
			"The centre turns back a radius before the wall. Move the wall by r to the ball's side."
		)
	)
	found.append_array([_on_image(model), _on_bounce(model), _on_orders(model), _on_fire(model)])
	return found


## What is asked before the image is shown, translated.
static func question_on_image() -> String:
	return LabText.translate("Where on the moved wall do you aim?")


## The answers to [method question_on_image], translated.
static func choices() -> PackedStringArray:
	return [
		LabText.translate("halfway between S and T"),
		LabText.translate("where the line to the mirror image of T crosses it"),
		LabText.translate("at its point nearest to T")
	]


## What is asked before the bounce is shown, translated.
static func question_on_bounce() -> String:
	return LabText.translate(
		"Where is the ball's centre when it bounces first? Drag the “?” there."
	)


## Why [param refused] is no way, translated, without a full stop; "" for a hit.
static func reason(refused: BankWay) -> String:
	var wall := BankShotAnswer.failing_wall(refused) + 1
	match refused.outcome:
		BankWay.Outcome.NONE:
			return LabText.translate("S and T are on different sides of wall %d") % wall
		BankWay.Outcome.BEHIND:
			return LabText.translate("the ball would be on the wrong side of wall %d") % wall
		BankWay.Outcome.NOT_REACHED:
			return LabText.translate("the ball would not come to wall %d") % wall
		BankWay.Outcome.BESIDE:
			return LabText.translate("it would bounce beside an end of wall %d") % wall
		BankWay.Outcome.BLOCKED:
			return LabText.translate("a wall is in the way")
	return ""


## What the list of orders shows, translated: first the way that arrives first, then each order with
## what becomes of it.
static func orders(model: BankShotModel) -> PackedStringArray:
	var found: PackedStringArray = [LabText.translate("Order: first to arrive")]
	for way in model.answer().ways:
		var names: PackedStringArray = []
		for wall in way.walls:
			names.append(str(wall + 1))
		var words := LabText.translate("hits") if way.hit else reason(way)
		found.append("%s: %s" % [" → ".join(names), words])
	return found


## What was found, in up to three lines, translated.
static func verdict(model: BankShotModel, step: BankShotModel.Step) -> PackedStringArray:
	var answer := model.answer()
	if answer.overlapped >= 0:
		var sentence := LabText.translate("at S or T the ball overlaps wall %d: make room")
		return [sentence % (answer.overlapped + 1)]
	var words: PackedStringArray = []
	if step == BankShotModel.Step.FIRE and answer.way.hit:
		words = _on_miss(answer)
	elif answer.way.hit:
		words = [_on_length(model)]
	else:
		words = [reason(answer.way)]
		if not model.order:
			words.append(LabText.translate("no order of walls leads to T"))
	if model.mistake != 0:
		words.append(_on_mistake(answer))
	return words


static func _on_task(model: BankShotModel) -> String:
	if model.board.bounces == 1:
		return LabText.translate(
			"The ball at S is to come to T after exactly one bounce. Where to?"
		)
	var sentence := LabText.translate(
		"The ball at S is to come to T after exactly %d bounces. Where to?"
	)
	return sentence % model.board.bounces


static func _on_image(model: BankShotModel) -> String:
	if model.board.bounces > 1:
		return (
			(
				LabText
				. translate(
					"Mirror T in the last wall first, then go backwards to the first one: %s is the image."
				)
			)
			% image_symbol(model.board.bounces, model.board.bounces)
		)
	if model.board.bounciness == 1.0:
		return LabText.translate(
			"Mirror T in the moved wall: T′ is as far behind it as T is before it."
		)
	return (
		LabText
		. translate(
			"The bounce keeps only C of the speed along n̂: T′ is 1/C times as far behind as T is before."
		)
	)


static func _on_bounce(model: BankShotModel) -> String:
	var answer := model.answer()
	var image := image_symbol(model.board.bounces, model.board.bounces)
	if not answer.way.hit:
		var refusal := LabText.translate("Straight at %s? Not here: %s.")
		return refusal % [image, reason(answer.way)]
	if model.board.bounces == 1:
		return LabText.translate(
			"Shoot straight at T′. Where this line crosses the moved wall, the ball bounces to T."
		)
	var sentence := LabText.translate(
		"Shoot straight at %s. At each bounce the ball turns to the next image, at last to T."
	)
	return sentence % image


static func _on_orders(model: BankShotModel) -> String:
	var answer := model.answer()
	var hits := answer.ways.filter(func(way: BankWay) -> bool: return way.hit).size()
	var sentence := LabText.translate(
		"Orders of walls that lead to T: %d of %d. The list says why the others do not."
	)
	return sentence % [hits, answer.ways.size()]


static func _on_fire(model: BankShotModel) -> String:
	var answer := model.answer()
	if not answer.way.hit:
		return LabText.translate("There is nothing to fire: %s.") % reason(answer.way)
	if answer.mistake_shows():
		return LabText.translate("Play: the right ball flies, and that of the mistake beside it.")
	return LabText.translate("Play: the shot flies. Its miss is the smallest distance from T.")


static func _on_miss(answer: BankShotAnswer) -> PackedStringArray:
	var miss := NumberText.size(answer.miss())
	if is_nan(answer.bound):
		return [LabText.translate("miss %s px") % miss]
	var numbers := [miss, NumberText.size(answer.bound)]
	var words: PackedStringArray = [LabText.translate("miss %s px; ε × condition %s px") % numbers]
	# Beside the miss of a mistake there is no room for more.
	if not answer.mistake_shows():
		words.append(LabText.translate("so far rounding alone may move it"))
	return words


static func _on_length(model: BankShotModel) -> String:
	var image := image_symbol(model.board.bounces, model.board.bounces)
	var length := NumberText.short(model.answer().way.distance)
	if model.board.bounciness == 1.0:
		return LabText.translate("the way is %s px long, as the line to %s") % [length, image]
	return LabText.translate("as late as on a straight way of %s px") % length


static func _on_mistake(answer: BankShotAnswer) -> String:
	if answer.wrong_corners.is_empty():
		return LabText.translate("the mistake has nothing to aim at here")
	if not answer.mistake_shows():
		return LabText.translate("the mistake changes nothing here")
	var miss := NumberText.short(answer.wrong_miss(), 3)
	return LabText.translate("with the mistake it misses by %s px") % miss


static func _as_sentence(phrase: String) -> String:
	return phrase[0].to_upper() + phrase.substr(1) + "."
