class_name StabilityCase
extends RefCounted
## One stiff or extreme case: what is tried, what must hold, and the trial itself.

## What is tried, in the student's language.
var title: String
## What must hold, in the student's language.
var criterion: String
## Whether the full form takes more than about half a second. The tests run the quick form then.
var is_long := false
## How the quick form differs, such as "1000 shots"; "" where both are the same.
var quick_form := ""

var _family: StabilityFamily
# Takes whether the quick form is wanted, and returns a StabilityResult.
var _trial: Callable


## A case of [param family] whose trial is [param trial]: a method of that family, or one with
## arguments bound, that takes is_quick: bool and returns a [StabilityResult].
func _init(
	with_title: String, with_criterion: String, family: StabilityFamily, trial: Callable
) -> void:
	title = with_title
	criterion = with_criterion
	_family = family
	_trial = trial


## The title.
func _to_string() -> String:
	return title


## Says that the full form is long, and what the quick form is.
func with_quick_form(text: String) -> StabilityCase:
	quick_form = text
	is_long = true
	return self


## Tries it; the quick form takes about 50 ms at most. A world that refused something on the way
## has failed, and its sentence is the figure.
func run(is_quick: bool = false) -> StabilityResult:
	_family.refusal = ""
	var result: StabilityResult = _trial.call(is_quick)
	if _family.refusal:
		return StabilityResult.new(_family.refusal, false)
	return result
