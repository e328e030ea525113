class_name BankShotProblem
extends ReportProblem
## The tenth problem: where to aim over walls.

## Every order of walls, each followed to the end.
const CAREFUL := "mirror images, followed"
## The nearest image.
const BY_THE_SLIDE := "mirror image, slide"
## See [TriedDirections].
const TRIED := "directions tried"

const _DIRECTIONS: PackedInt32Array = [360, 3600]
const _QUICK_DIRECTIONS: PackedInt32Array = [360]


func _init() -> void:
	id = "bank_shot"
	champion = CAREFUL
	title = "A shot over walls"
	question = (
		"Where to aim so that a ball comes to a place after one bounce, or after two in a room. The"
		+ " error is the largest miss: the ball is followed with 106 bits, bounce by bounce."
	)
	run_time_axis = "run time, µs per shot"
	error_axis = "largest miss, px"


## See [method ReportProblem.cases].
func cases(is_quick: bool) -> Array[MeasuredCase]:
	var found: Array[MeasuredCase] = []
	for situation in BankQuestions.SITUATIONS:
		var asked := BankQuestions.of(situation, is_quick)
		found.append(_case(situation, asked, BankQuestions.careful).named(CAREFUL))
		found.append(_case(situation, asked, _by_the_slide).named(BY_THE_SLIDE))
		for count in _QUICK_DIRECTIONS if is_quick else _DIRECTIONS:
			var solver := TriedDirections.best.bind(count)
			var case := AimCase.new(id, situation, asked, solver, _miss_of_direction)
			found.append(case.named(TRIED, str(count)))
	return found


func _case(situation: String, asked: Array[BankQuestion], solver: Callable) -> AimCase:
	return AimCase.new(id, situation, asked, solver, _miss)


static func _miss(asked: BankQuestion, way: BankWay) -> float:
	return asked.miss_of(way)


static func _miss_of_direction(asked: BankQuestion, direction: Vec2) -> float:
	return asked.miss(direction)


static func _by_the_slide(asked: BankQuestion) -> BankWay:
	return BankAim.first_by_the_slide(
		asked.start, asked.target, asked.radius, asked.bounciness, asked.walls, asked.bounces
	)
