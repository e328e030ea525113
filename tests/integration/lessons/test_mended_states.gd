extends ScreenTest
## States in which a lesson has once said something false: now all that it says in them holds.

const _ON_CIRCLE := (
	"timed_shot?kind=1&muzzle=-95.87068649108613,229.8&bullet=-5,-3&target=100,-50"
	+ "&centre=2.064656754456937,89.9&radius=12.4"
)
const _LINKS: Array[String] = [
	# The nozzle is 1e-12 px and less below the hull, which is no rounding.
	"aim_at?hull=-2000,0&hull_degrees=1e-12&step=1",
	"aim_at?hull=-80,0&hull_degrees=1e-12&length=1&step=1",
	# The target is in the shooter's place but for a few 1e-13 px.
	"lead_target?target=-119.999999999999,-90&velocity=11,90&step=1",
	"lead_target?target=-119.999999999999,-90&own=7,3&velocity=-11,90&mistake=103&step=6",
	(
		"lead_target?target=-120.0000000000003,-90.0000000000004&own=7,3&velocity=-11,90"
		+ "&mistake=104&step=5"
	),
	# Speeds that are equal but for 1e-10 px/s.
	"lead_target?target=-0.8,-0.6&velocity=-90,120&speed=150.0000000001&mistake=103&step=4",
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
	# The muzzle is where the target passes, and the bullet leaves its circle.
	_ON_CIRCLE + "&step=2",
	_ON_CIRCLE + "&step=3",
	_ON_CIRCLE + "&step=4",
	_ON_CIRCLE + "&step=5",
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
