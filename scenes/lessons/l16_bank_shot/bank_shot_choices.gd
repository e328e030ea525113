class_name BankShotChoices
extends RefCounted
## The two lists of the lesson on bank shots: how many bounces there have to be, and over which
## walls in which order, each order with what becomes of it.

const _BOUNCES := "bounces"
const _ORDER := "order"

## Where the lists are.
var options: LessonOptions


## Adds the lists to [param its_options].
func _init(its_options: LessonOptions) -> void:
	options = its_options
	var counts: PackedStringArray = [tr("1 bounce"), tr("2 bounces"), tr("3 bounces")]
	options.add_choice(_BOUNCES, tr("Bounces"), counts)
	options.add_choice(_ORDER, tr("Order of walls"), [])


## Takes into [param model] what was chosen in the list [param key] at [param place]. "" or a
## sentence; then nothing has changed.
func choose(model: BankShotModel, key: String, place: int) -> String:
	if key == _BOUNCES:
		return model.take({"bounces": place + 1, "order": ""})
	return model.take({"order": model.board.orders()[place - 1] if place > 0 else ""})


## Shows what is chosen in [param model]; the orders from the step on that is about them.
func show_model(model: BankShotModel, step: BankShotModel.Step) -> void:
	options.show_choice(_BOUNCES, model.board.bounces - 1)
	options.reveal_choice(_ORDER, step >= BankShotModel.Step.ORDERS)
	options.fill_choice(_ORDER, BankShotTexts.orders(model))
	options.show_choice(_ORDER, model.board.orders().find(model.order) + 1)
