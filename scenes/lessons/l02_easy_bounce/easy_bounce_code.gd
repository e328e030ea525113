class_name EasyBounceCode
## The lines of GDScript that compute what the formula of the lesson on the easy bounce shows: by
## one coordinate on a level or upright line, by the normal on a tilted one.

const _SHORTEST := "var shortest := p.minus(l).dot(unit_normal)"


## The lines at [param step] of [EasyBounceTexts] for the ball [param moved] of [param model]; none
## for what is done only after a hit where there is none.
static func lines(model: EasyBounceModel, moved: Ball, step: int) -> PackedStringArray:
	match step:
		EasyBounceTexts.Step.MOVE:
			return ["var p := before.plus(v)"]
		EasyBounceTexts.Step.DETECT:
			return _detect(model)
		EasyBounceTexts.Step.PUT_BACK:
			return _put_back(model) if model.right_detects(moved) else PackedStringArray()
		EasyBounceTexts.Step.FLIP:
			return _flip(model) if model.right_reflects(moved) else PackedStringArray()
	if model.right_reflects(moved):
		return _detect(model) + _put_back(model) + _flip(model)
	return _detect(model)


## What the names in [method lines] stand for.
static func inputs(model: EasyBounceModel, moved: Ball) -> Dictionary[String, Variant]:
	return {
		before = moved.position.minus(moved.velocity),
		p = moved.position,
		v = moved.velocity,
		r = moved.radius,
		floor_y = model.line_at(moved.position),
		wall_x = model.line_at(moved.position),
		l = model.line().start,
		unit_normal = model.normal(),
	}


static func _detect(model: EasyBounceModel) -> PackedStringArray:
	if not model.is_level():
		return [_SHORTEST, "var is_hit := shortest < r"]
	var difference := "wall_x - p.x" if model.is_wall else "floor_y - p.y"
	return ["var straight := " + difference, "var is_hit := straight < r"]


static func _put_back(model: EasyBounceModel) -> PackedStringArray:
	if not model.is_level():
		return [
			"var depth := r - p.minus(l).dot(unit_normal)",
			"var back := p.plus(unit_normal.scaled(depth))"
		]
	if model.is_wall:
		return ["var back := Vec2.new(wall_x - r, p.y)"]
	return ["var back := Vec2.new(p.x, floor_y - r)"]


static func _flip(model: EasyBounceModel) -> PackedStringArray:
	if not model.is_level():
		return ["v.reflect(unit_normal)"]
	return ["var flipped := Vec2.new(%s)" % ("-v.x, v.y" if model.is_wall else "v.x, -v.y")]
