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

# Takes whether the quick form is wanted, and returns a StabilityResult.
var _trial: Callable


## A case whose [param trial] takes is_quick: bool and returns a [StabilityResult].
func _init(with_title: String, with_criterion: String, trial: Callable) -> void:
	title = with_title
	criterion = with_criterion
	_trial = trial


## The title.
func _to_string() -> String:
	return title


## Says that the full form is long, and what the quick form is.
func with_quick_form(text: String) -> StabilityCase:
	quick_form = text
	is_long = true
	return self


## Tries it; the quick form takes about 50 ms at most.
func run(is_quick: bool = false) -> StabilityResult:
	return _trial.call(is_quick)
