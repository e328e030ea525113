class_name StabilityCase
extends RefCounted
## One stiff or extreme case: its title, its criterion, and the trial itself.

## What is tried, in the language of the user interface.
var title: String
## What must hold, in the language of the user interface.
var criterion: String
## Whether the full form takes more than about half a second. The tests run the quick form then.
var is_long := false
## How the quick form differs, such as "1000 shots"; "" where both are the same.
var quick_form := ""

# Takes is_quick: bool and returns a StabilityResult.
var _trial: Callable


## A case whose [param trial] takes is_quick: bool and returns a [StabilityResult].
func _init(with_title: String, with_criterion: String, trial: Callable) -> void:
	title = with_title
	criterion = with_criterion
	_trial = trial


## The title.
func _to_string() -> String:
	return title


## Marks the full form as long and describes the quick form. Returns the case itself.
func with_quick_form(text: String) -> StabilityCase:
	quick_form = text
	is_long = true
	return self


## Runs the trial. The quick form takes about 50 ms at most.
func run(is_quick: bool = false) -> StabilityResult:
	return _trial.call(is_quick)
