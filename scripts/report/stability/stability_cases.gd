class_name StabilityCases
extends RefCounted
## All stiff and extreme cases, in the order of the table.


## New cases, none of them tried yet.
static func all() -> Array[StabilityCase]:
	var families: Array[StabilityFamily] = [
		PiStability.new(),
		WedgeStability.new(),
		ZenoStability.new(),
		RestStability.new(),
		ShotStability.new(),
		ScaleStability.new(),
		SeamStability.new(),
		CoincidenceStability.new(),
		OverlapStability.new(),
		RefusalStability.new(),
	]
	var found: Array[StabilityCase] = []
	for family in families:
		found.append_array(family.cases())
	return found
