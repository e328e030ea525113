class_name StabilityCase
extends RefCounted
## One stiff or extreme case: its title, its criterion, and the trial itself.

## What is tried, in the language of the user interface.
var title: String
## What must hold, in the language of the user interface.
var criterion: String
## Whether the full form takes more than about half a second. The tests and the lesson try the quick
## form then.
var is_long := false
## What the quick form of a long case tries, such as "200 random shots", in the language of the user
## interface; "" where it would only repeat another case, and so there is none.
var quick_title := ""

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


## Marks the full form as long. The quick form tries what [param its_title] says, by the same
## criterion. Returns the case itself.
func with_quick_form(its_title: String) -> StabilityCase:
	quick_title = its_title
	is_long = true
	return self


## Marks the full form as long. There is no quick form: it would repeat another case. Returns the
## case itself.
func without_quick_form() -> StabilityCase:
	is_long = true
	return self


## Whether the case can be tried where there is little time.
func has_quick_form() -> bool:
	return not is_long or quick_title != ""


## What is tried where there is little time: the quick form of a long case, else the case itself.
func title_in_brief() -> String:
	return quick_title if is_long and quick_title else title


## Runs the trial. The quick form takes about 50 ms at most.
func run(is_quick: bool = false) -> StabilityResult:
	return _trial.call(is_quick)
