class_name BankShotMistakes
extends RefCounted
## Four ways in which a bank shot is aimed wrong. The right way is in `scripts/aiming/bank_aim.gd`.

## Mirrored in the wall itself, as if the ball were a point.
const RADIUS_FORGOTTEN := 101
## Aimed at the middle of the wall between start and target.
const MIDPOINT := 102
## Mirrored as for C = 1, whatever C is.
const PLAIN_MIRROR := 103
## Mirrored in the first wall first.
const WRONG_ORDER := 104


## In which direction the mistake with this number shoots, where [param way] would be the right one;
## zero where it aims at the start itself.
static func direction(number: int, board: BankBoard, way: BankWay) -> Vec2:
	match number:
		RADIUS_FORGOTTEN:
			return _at_image(board, way, 0.0, board.bounciness)
		MIDPOINT:
			return _at_middle(board, way)
		PLAIN_MIRROR:
			return _at_image(board, way, board.radius, 1.0)
		WRONG_ORDER:
			return _at_image_of_other_order(board, way)
	return way.direction


## The image of [param point] in the wall that is moved by [param radius] to its [param side].
static func image_of(
	point: Vec2, wall: LineSegment, side: float, radius: float, bounciness: float
) -> Vec2:
	var normal := wall.normal().scaled(side)
	var height := point.minus(wall.start).dot(normal) - radius
	return point.minus(normal.scaled((1.0 + 1.0 / bounciness) * height))


static func _at_image(board: BankBoard, way: BankWay, radius: float, bounciness: float) -> Vec2:
	var image := board.target
	for place in range(way.walls.size() - 1, -1, -1):
		var wall := board.walls[way.walls[place]]
		image = image_of(image, wall, way.sides[place], radius, bounciness)
	return image.minus(board.start).normalized()


static func _at_image_of_other_order(board: BankBoard, way: BankWay) -> Vec2:
	var image := board.target
	for place in way.walls.size():
		var wall := board.walls[way.walls[place]]
		image = image_of(image, wall, way.sides[place], board.radius, board.bounciness)
	return image.minus(board.start).normalized()


# Halfway between the feet of the start and of what the ball flies at after the first bounce.
static func _at_middle(board: BankBoard, way: BankWay) -> Vec2:
	var wall := board.walls[way.walls[0]]
	var normal := wall.normal().scaled(way.sides[0])
	var middle := board.start.lerped(way.images[1], 0.5)
	var height := middle.minus(wall.start).dot(normal) - board.radius
	return middle.minus(normal.scaled(height)).minus(board.start).normalized()


## What the bug gallery says of each, translated.
static func infos() -> Array[MistakeInfo]:
	return [
		MistakeInfo.new(
			RADIUS_FORGOTTEN,
			LabText.translate("mirrored in the wall itself"),
			LabText.translate("The centre bounces a radius before the wall: move the wall by r."),
			"test_bank_shot_mistakes.test_the_radius_forgotten_misses_by_20",
			LabText.translate("The test shoots with r = 20 and wants the ball to reach T.")
		),
		MistakeInfo.new(
			MIDPOINT,
			LabText.translate("halfway along the wall"),
			LabText.translate(
				"Halfway is right only where S and T are equally far from the wall, and C = 1."
			),
			"test_bank_shot_mistakes.test_the_middle_misses_by_29",
			LabText.translate("The test has T nearer to the wall than S.")
		),
		MistakeInfo.new(
			PLAIN_MIRROR,
			LabText.translate("mirrored as for C = 1"),
			LabText.translate(
				"With a loss the ball leaves flatter: the image is 1/C times as deep."
			),
			"test_bank_shot_mistakes.test_the_plain_mirror_misses_by_48",
			LabText.translate("The test shoots with C = 0.5.")
		),
		MistakeInfo.new(
			WRONG_ORDER,
			LabText.translate("mirrored in the first wall first"),
			LabText.translate(
				"Mirror in the last wall first: T′ is what the ball flies at before that bounce."
			),
			"test_bank_shot_mistakes.test_the_wrong_order_misses_where_walls_are_slanted",
			LabText.translate("The test has two slanted walls. A right angle would hide it.")
		),
	]
