class_name DotProductCode
## The lines of GDScript that compute what the formula of the lesson on the dot product shows.


## The lines at [param step] of [DotProductTexts]; none where [param model] has no direction for
## them.
static func lines(model: DotProductModel, step: int) -> PackedStringArray:
	var needs_both := step > DotProductTexts.Step.SURE
	var has_none := not model.onto().length() or needs_both and not model.shadowed().length()
	if step > DotProductTexts.Step.VECTORS and has_none:
		return []
	var names := {
		u = DotProductTexts.shadowed_symbol(model), w = DotProductTexts.onto_symbol(model)
	}
	var found: PackedStringArray = []
	for line in _lines(step, model.normalizes):
		found.append(line.format(names))
	return found


## What the names in [method lines] stand for.
static func inputs(model: DotProductModel) -> Dictionary[String, Variant]:
	return {
		a = model.a(),
		b = model.b(),
		a_tail = model.a_tail,
		a_head = model.a_head,
		b_tail = model.b_tail,
		b_head = model.b_head,
	}


static func _lines(step: int, normalizes: bool) -> PackedStringArray:
	match step:
		DotProductTexts.Step.VECTORS:
			return ["var a := a_head.minus(a_tail)", "var b := b_head.minus(b_tail)"]
		DotProductTexts.Step.BOTH:
			return _lines_on_both(normalizes)
		DotProductTexts.Step.ANGLE:
			return [
				"var cosine := a.normalized().dot(b.normalized())",
				"var product := a.length() * b.length() * cosine",
			]
		DotProductTexts.Step.PRIMITIVE:
			return [
				"var alpha := {u}.angle_radians()",
				"var beta := {w}.angle_radians()",
				"var scalar := {u}.length() * cos(alpha - beta)",
			]
	return _lines_on_shadow(step) if normalizes else _wrong_lines_on_shadow(step)


static func _lines_on_shadow(step: int) -> PackedStringArray:
	var unit := "var unit_{w} := {w}.normalized()"
	var scalar := "var scalar := {u}.dot(unit_{w})"
	match step:
		DotProductTexts.Step.UNIT:
			return [unit]
		DotProductTexts.Step.SCALAR:
			return [unit, scalar]
		DotProductTexts.Step.PROJECTION:
			return [unit, scalar, "var p := unit_{w}.scaled(scalar)"]
		DotProductTexts.Step.REJECTION:
			return ["var p := {u}.vector_projection({w})", "var rest := {u}.minus(p)"]
	return ["var p := {u}.vector_projection({w})", "var measured := p.length()"]


static func _wrong_lines_on_shadow(step: int) -> PackedStringArray:
	var dot := "var dot := {u}.dot({w})"
	var p := "var p := {w}.scaled(dot)"
	match step:
		DotProductTexts.Step.UNIT:
			return ["var length := {w}.length()"]
		DotProductTexts.Step.SCALAR:
			return [dot]
		DotProductTexts.Step.PROJECTION:
			return [dot, p]
		DotProductTexts.Step.REJECTION:
			return [dot, p, "var rest := {u}.minus(p)"]
	return [dot, p, "var measured := p.length()"]


static func _lines_on_both(normalizes: bool) -> PackedStringArray:
	if normalizes:
		return ["var p := {u}.dot({w}.normalized())", "var q := {w}.dot({u}.normalized())"]
	return ["var p := {u}.dot({w})", "var q := {w}.dot({u})"]
