class_name BankShotCode
extends RefCounted
## The lines of GDScript that compute what each step of the lesson on bank shots shows: for the last
## wall of the way, in which T is mirrored first, and then by the core of the lab.


## The lines of [param step]; none where there is nothing to compute.
static func lines(model: BankShotModel, step: BankShotModel.Step) -> PackedStringArray:
	var way := model.answer().way
	if way.images.is_empty() or step == BankShotModel.Step.TASK:
		return []
	var moved: PackedStringArray = [
		"var n := wall.normal()" + ("" if way.sides[-1] > 0.0 else ".negated()"),
		"var o := wall.start.plus(n.scaled(radius))",
	]
	match step:
		BankShotModel.Step.MOVED_WALL:
			return moved
		BankShotModel.Step.IMAGE:
			moved.append("var d := n.dot(target.minus(o))")
			moved.append("var image := target.minus(n.scaled((1.0 + 1.0 / bounciness) * d))")
			return moved
	if not way.hit or model.order:
		return []
	return [
		"var way := BankAim.first(start, target, radius, bounciness, walls, bounces)",
		"var direction := way.direction",
	]


## The values of the names in the lines.
static func inputs(model: BankShotModel) -> Dictionary[String, Variant]:
	var way := model.answer().way
	return {
		"BankAim": BankAim,
		"wall": model.board.walls[way.walls[-1]],
		"walls": model.board.walls,
		"start": model.board.start,
		"target": model.board.target,
		"radius": model.board.radius,
		"bounciness": model.board.bounciness,
		"bounces": model.board.bounces,
	}
