extends LabTest
## The exact moment of a hit, against the reference table, whose answers have 60 digits.

# Of the families in which numbers are too large or too small for the products.
const _EXTREME := 1e60

var _table := MotionTable.new("aim_lead")


func test_every_row_is_exact() -> void:
	var worst: PackedFloat64Array = []
	for row: int in _table.size():
		var wanted := _table.at(row, "t")
		if _table.at(row, "hit") == 1.0 and wanted > 0.0 and _is_usual(row):
			var off := absf(_lead(row).root_near(_first(row)).to_float() - wanted)
			worst.append(off / last_place(wanted))
	assert_gt(worst.size(), 500)
	assert_all_at_most(worst, 1.0)


func test_the_error_has_a_sign() -> void:
	var lead := ExactLead.new(
		Vec2.zero(), Vec2.zero(), Vec2.new(240, 0), Vec2.new(0, 90), 150.0, 0.0
	)
	assert_eq(lead.error_of(2.5, 2.0), 0.5)
	assert_eq(lead.error_of(1.5, 2.0), -0.5)
	assert_eq(lead.root_near(-1.9).to_float(), -2.0)


func _lead(row: int) -> ExactLead:
	return ExactLead.new(
		_table.vector(row, "sx", "sy"),
		_table.vector(row, "ux", "uy"),
		_table.vector(row, "tx", "ty"),
		_table.vector(row, "vx", "vy"),
		_table.at(row, "speed"),
		_table.at(row, "radius")
	)


func _first(row: int) -> float:
	var target := AimTarget.new(
		_table.vector(row, "tx", "ty"),
		_table.vector(row, "vx", "vy"),
		Vec2.zero(),
		_table.at(row, "radius")
	)
	var own := _table.vector(row, "ux", "uy")
	var shooter := _table.vector(row, "sx", "sy")
	return LeadAim.first(shooter, target, _table.at(row, "speed"), own).time


func _is_usual(row: int) -> bool:
	for column: String in ["tx", "ty", "sx", "sy", "vx", "vy", "ux", "uy", "speed", "radius", "t"]:
		var size := absf(_table.at(row, column))
		if size > _EXTREME or size > 0.0 and size < 1.0 / _EXTREME:
			return false
	return true
