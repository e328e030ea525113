class_name BankShotFormula
extends RefCounted
## The formula of the lesson on bank shots: its lines, and what each name in them is.
##
## Names with a number belong to the walls of the way in the order of mirroring: 1 is the last wall.
## Those of fields, such as `ax1`, belong to the wall with that number on screen.

var _formula: Formula


## Writes into [param formula].
func _init(formula: Formula) -> void:
	_formula = formula


## Shows the lines of [param step] with the numbers of [param model].
func show_model(model: BankShotModel, step: BankShotModel.Step) -> void:
	_put_what_is_typed(model)
	var way := model.answer().way
	# Worked out as the lines say. The core counts from the start, which rounds otherwise.
	var image := model.board.target
	for place in way.images.size() - 1:
		image = _put_mirror(model, place + 1, image)
	if not way.images.is_empty():
		_put_bounces(model, way)
	_formula.put_symbol("wrong", tr("mistake"), Palette.Role.WRONG)
	_formula.put_vector("wrong_pair", model.answer().wrong_direction, Palette.Role.WRONG)
	_formula.show_lines(_lines(model, way, step))


func _lines(model: BankShotModel, way: BankWay, step: BankShotModel.Step) -> PackedStringArray:
	var found: PackedStringArray = [
		"{S} = ( {sx} , {sy} )   {T} = ( {tx} , {ty} )", "r = {r}   C = {C}"
	]
	if step == BankShotModel.Step.TASK:
		return found + _lines_of_walls(model)
	if step >= BankShotModel.Step.ORDERS:
		return found + _lines_of_shot(model, way)
	for place in range(1, way.images.size()):
		var line := "{n%d} = {n_pair%d}   {o%d} = {a_pair%d} + r {n%d} = {o_pair%d}"
		found.append(line.replace("%d", str(place)))
		if step >= BankShotModel.Step.IMAGE:
			found.append_array(_lines_of_image(place))
	if step == BankShotModel.Step.BOUNCE and not way.images.is_empty():
		found.append_array(_lines_of_bounces(way))
		found.append_array(_lines_of_direction(model, way))
	return found


func _lines_of_walls(model: BankShotModel) -> PackedStringArray:
	var found: PackedStringArray = []
	for number in range(1, model.board.walls.size() + 1):
		var line := tr("%d: ( {ax} , {ay} ) to ( {bx} , {by} )") % number
		for name_of_end: String in ["ax", "ay", "bx", "by"]:
			line = line.replace("{%s}" % name_of_end, "{%s%d}" % [name_of_end, number])
		found.append(line)
	return found


# Where the student only looks at what the shot does.
func _lines_of_shot(model: BankShotModel, way: BankWay) -> PackedStringArray:
	if way.images.is_empty():
		return []
	var found: PackedStringArray = [
		"{image%d} = {image_pair%d}".replace("%d", str(way.walls.size()))
	]
	return found + _lines_of_direction(model, way)


func _lines_of_image(place: int) -> PackedStringArray:
	var mirrored := "{T}" if place == 1 else "{image%d}" % (place - 1)
	return [
		"{d_symbol%d} = {n%d} · (%s − {o%d}) = {d%d}".replace("%d", str(place)).replace(
			"%s", mirrored
		),
		(
			"{image%d} = %s − (1 + 1/C) {d_symbol%d} {n%d} = {image_pair%d}"
			. replace("%d", str(place))
			. replace("%s", mirrored)
		),
	]


func _lines_of_bounces(way: BankWay) -> PackedStringArray:
	var last := str(way.walls.size())
	var found: PackedStringArray = []
	if not way.bounces.is_empty():
		found.append(
			"e = {n%d} · ({S} − {o%d}) = {e}   f = {n%d} · ({image%d} − {o%d}) = {f}".replace(
				"%d", last
			)
		)
		found.append("s = e / (e − f) = {s}")
		found.append("{bounce1} = {S} + s ({image%d} − {S}) = {bounce_pair1}".replace("%d", last))
	for number in range(2, way.bounces.size() + 1):
		found.append("{bounce%d} = {bounce_pair%d}".replace("%d", str(number)))
	return found


func _lines_of_direction(model: BankShotModel, way: BankWay) -> PackedStringArray:
	var last := str(way.walls.size())
	var found: PackedStringArray = [
		"({image%d} − {S}) / |{image%d} − {S}| = {direction}".replace("%d", last)
	]
	if model.mistake != 0 and not model.answer().wrong_corners.is_empty():
		found.append("{wrong}: {wrong_pair}")
	return found


# Each of these has its counterpart in BankShotModel.enter.
func _put_what_is_typed(model: BankShotModel) -> void:
	_formula.put_symbol("S", "S", Palette.Role.A)
	_formula.put_symbol("T", "T", Palette.Role.B)
	_formula.put_number("sx", model.board.start.x, Palette.Role.A, tr("x of S"))
	_formula.put_number("sy", model.board.start.y, Palette.Role.A, tr("y of S"))
	_formula.put_number("tx", model.board.target.x, Palette.Role.B, tr("x of T"))
	_formula.put_number("ty", model.board.target.y, Palette.Role.B, tr("y of T"))
	_formula.put_number("r", model.board.radius, Palette.Role.INK, tr("radius of the ball"))
	_formula.put_number(
		"C", model.board.bounciness, Palette.Role.INK, tr("bounciness C, 0.05 to 1")
	)
	for place in model.board.walls.size():
		var wall := model.board.walls[place]
		var number := place + 1
		_put_end("ax%d" % number, wall.start.x, tr("x of the start of wall %d") % number)
		_put_end("ay%d" % number, wall.start.y, tr("y of the start of wall %d") % number)
		_put_end("bx%d" % number, wall.end.x, tr("x of the end of wall %d") % number)
		_put_end("by%d" % number, wall.end.y, tr("y of the end of wall %d") % number)


func _put_end(name_in_line: String, value: float, title: String) -> void:
	_formula.put_number(name_in_line, value, Palette.Role.INK, title)


# Returns the image of `mirrored` in the wall that comes at `place` from the last one.
func _put_mirror(model: BankShotModel, place: int, mirrored: Vec2) -> Vec2:
	var way := model.answer().way
	var count := way.walls.size()
	var index := count - place
	var wall := model.board.walls[way.walls[index]]
	var normal := wall.normal().scaled(way.sides[index])
	var away := normal.scaled(model.board.radius)
	var moved := wall.start.plus(away)
	var image := BankShotMistakes.image_of(
		mirrored, wall, way.sides[index], model.board.radius, model.board.bounciness
	)
	var key := str(place)
	_formula.put_symbol("n" + key, BankShotTexts.numbered("n̂", place, count), Palette.Role.UNIT)
	_formula.put_symbol("o" + key, BankShotTexts.numbered("o", place, count), Palette.Role.INK)
	_formula.put_symbol(
		"d_symbol" + key, BankShotTexts.numbered("d", place, count), Palette.Role.INK
	)
	_formula.put_symbol(
		"image" + key, BankShotTexts.image_symbol(place, count), Palette.Role.PROJECTION
	)
	_formula.put_vector("n_pair" + key, normal, Palette.Role.UNIT)
	_formula.put_vector("a_pair" + key, wall.start, Palette.Role.INK)
	var sizes := _sizes_of(wall.start, away)
	_formula.put_vector_sum("o_pair" + key, moved, sizes, Palette.Role.INK)
	var height := normal.dot(mirrored.minus(moved))
	var size := _size_of([mirrored, wall.start, away])
	_formula.put_sum("d" + key, height, size, Palette.Role.INK)
	var way_back := normal.scaled((1.0 + 1.0 / model.board.bounciness) * size)
	_formula.put_vector_sum(
		"image_pair" + key, image, _sizes_of(mirrored, way_back), Palette.Role.PROJECTION
	)
	return image


func _put_bounces(model: BankShotModel, way: BankWay) -> void:
	var wall := model.board.walls[way.walls[0]]
	var normal := wall.normal().scaled(way.sides[0])
	var away := normal.scaled(model.board.radius)
	var moved := wall.start.plus(away)
	var size := _size_of([model.board.start, wall.start, away, way.images[0]])
	var before := normal.dot(model.board.start.minus(moved))
	_formula.put_sum("e", before, size, Palette.Role.INK)
	var behind := normal.dot(way.images[0].minus(moved))
	_formula.put_sum("f", behind, size, Palette.Role.INK)
	_formula.put_sum(
		"s", before / (before - behind), size / absf(before - behind), Palette.Role.INK
	)
	var scales := _sizes_of(model.board.start, way.images[0])
	for place in way.bounces.size():
		var key := str(place + 1)
		var symbol := BankShotTexts.numbered("B", place + 1, way.walls.size())
		_formula.put_symbol("bounce" + key, symbol, Palette.Role.A)
		_formula.put_vector_sum("bounce_pair" + key, way.bounces[place], scales, Palette.Role.A)
	_formula.put_vector("direction", way.direction, Palette.Role.A)


static func _size_of(terms: Array[Vec2]) -> float:
	var size := 0.0
	for term in terms:
		size += absf(term.x) + absf(term.y)
	return size


# Of a sum of two vectors, each component.
static func _sizes_of(one: Vec2, other: Vec2) -> Vec2:
	return Vec2.new(absf(one.x) + absf(other.x), absf(one.y) + absf(other.y))
