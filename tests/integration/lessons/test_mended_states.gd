extends ScreenTest
## States in which a lesson has once said something false: now all that it says in them holds.

const _LINKS: Array[String] = [
	"ballistic_aim?target=0.00673,0.0199&velocity=-1,-3&gravity=1e-12&mistake=105&step=4",
	"ballistic_aim?target=0,-120&speed=1&gravity=1e-12&falls=true&mistake=104&step=4",
	(
		"ballistic_aim?target=0,-120&velocity=-240,300&speed=1&gravity=1e-12&falls=true&arc=3"
		+ "&mistake=104&step=4"
	),
	"ballistic_aim?target=1e-12,48&velocity=-11,-23.1&gravity=0.001&arc=2&step=5",
	(
		"ballistic_aim?target=-6,99.04&velocity=-240.78086880968306,299.3753049527456&speed=2"
		+ "&gravity=200&falls=true&arc=1&mistake=101&step=6"
	),
]


func test_all_that_is_said_holds(link: String = use_parameters(_LINKS)) -> void:
	var id := link.get_slice("?", 0)
	await open_lesson(LessonIndex.find(id))
	assert_eq(frame().link.open(link.get_slice("?", 1)), "")
	await student.settle()
	var truth := LessonTruth.new(frame())
	truth.look()
	assert_eq(truth.read_count, 1)
	for finding in truth.findings:
		fail_test(finding.text())
