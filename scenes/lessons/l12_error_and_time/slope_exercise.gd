class_name SlopeExercise
extends Exercise
## Asks for what can be read from a plot of error over run time: the order of a method, the run time
## of a smaller error, the number of methods on the frontier.

## What is asked for.
enum Kind { ORDER, COST, FRONTIER }

## The points of the question: run time in µs and error in px of the first one, then of the next.
var points: PackedFloat64Array = []

var _solution := ""


## A question with numbers drawn from [param rng].
static func fresh(kind: Kind, rng: RandomNumberGenerator) -> SlopeExercise:
	var exercise := new()
	match kind:
		Kind.ORDER:
			exercise._ask_order(rng)
		Kind.COST:
			exercise._ask_cost(rng)
		Kind.FRONTIER:
			exercise._ask_frontier(rng)
	return exercise


func solution() -> String:
	return _solution


func _ask_order(rng: RandomNumberGenerator) -> void:
	var order: int = [1, 2, 4][rng.randi_range(0, 2)]
	var slower: int = [2, 10][rng.randi_range(0, 1)]
	var time := rng.randi_range(2, 9) * 10.0
	var least := rng.randi_range(1, 9) / 1000.0
	var most := least * slower ** order
	points = [time, most, time * slower, least]
	prompt = (
		(
			tr("A method takes %s µs for an error of %s px, and with a smaller step %s µs ")
			+ tr("for %s px. What is its order p?")
		)
		% _texts(points)
	)
	answer_titles = ["p ="]
	right_answer = [order]
	_solution = (
		tr("%s times the run time leaves 1/%s of the error: p = log %s / log %s = %s.")
		% _texts([slower, slower ** order, slower ** order, slower, order])
	)
	add_mistake(
		[slower ** order],
		tr("That is the ratio of the errors. It is the ratio of the run times to the power p.")
	)
	add_mistake([-order], tr("The error falls while the run time grows: that is a positive order."))
	if order > 1:
		var sentence := tr("Upside down: it is log of the errors over log of the run times.")
		add_mistake_of_either_sign([1.0 / order], sentence)


func _ask_cost(rng: RandomNumberGenerator) -> void:
	var order := rng.randi_range(1, 2)
	var root: int = [4, 5, 10][rng.randi_range(0, 2)]
	var closer := root * root
	var time := rng.randi_range(2, 9) * 1.0
	prompt = (
		(
			tr("A method of order %d takes %s µs for an error of 1 px. ")
			+ tr("How many µs does it take for 1/%d px?")
		)
		% [order, NumberText.short(time), closer]
	)
	answer_titles = ["t ="]
	right_answer = [time * (closer if order == 1 else root)]
	points = [time, 1.0, right_answer[0], 1.0 / closer]
	_solution = (
		tr("Order %s: 1/%s of the error takes %s times the run time, %s µs.")
		% _texts([order, closer, right_answer[0] / time, right_answer[0]])
	)
	if order == 1:
		add_mistake(
			[time * root], tr("That is order 2: with order 1 twice the time halves the error.")
		)
	else:
		add_mistake([time * closer], tr("That is order 1: with order 2 twice the time leaves 1/4."))
	add_mistake(
		[time * closer ** 2], tr("That is order 1/2: four times the time for half of the error.")
	)
	add_mistake([time], tr("A smaller error takes more time."))


func _ask_frontier(rng: RandomNumberGenerator) -> void:
	var fastest := rng.randi_range(1, 5) * 10.0
	var error := rng.randi_range(4, 9) * 1.0
	var has_three := rng.randi_range(0, 1) == 1
	var second := error / 2.0 if has_three else error + 2.0
	var third := second + 1.0
	points = [fastest, error, 2.0 * fastest, second, 3.0 * fastest, third, 5.0 * fastest, 0.1]
	prompt = (
		(
			tr("A takes %s µs for an error of %s px, B %s µs for %s px, C %s µs for %s px, ")
			+ tr("D %s µs for %s px. How many of them are on the frontier?")
		)
		% _texts(points)
	)
	answer_titles = ["n ="]
	right_answer = [3.0 if has_three else 2.0]
	_solution = (
		tr("3: A, B and D. C is slower than B and has a larger error.")
		if has_three
		else tr("2: A and D. B and C are slower than A and have larger errors.")
	)
	if has_three:
		add_mistake([2.0], tr("B, too: nobody is both faster and closer than B."))
	else:
		add_mistake([3.0], tr("A is faster than B and C, and closer than both."))
	add_mistake([4.0], tr("C is not on it: another one is both faster and closer."))
	add_mistake(
		[1.0],
		tr("It holds every method for which none is both faster and closer: more than one here.")
	)


static func _texts(numbers: PackedFloat64Array) -> Array[String]:
	var texts: Array[String] = []
	for number in numbers:
		texts.append(NumberText.short(number))
	return texts
