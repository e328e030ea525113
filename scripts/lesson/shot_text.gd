class_name ShotText
extends RefCounted
## What lessons on aiming say of a shot: by how much it misses, and how far rounding alone may move
## it. A miss is the smallest distance of both centres.


## A right shot, in two lines, translated: it misses by [param miss] pixels, and
## [param from_rounding] is what [ShotCondition] says of it, times its epsilon.
static func of_right(miss: float, from_rounding: float) -> PackedStringArray:
	return [
		LabText.translate("miss %s px") % NumberText.size(miss),
		(
			LabText.translate("rounding alone: up to %s px (ε × condition)")
			% NumberText.size(from_rounding)
		)
	]


## A shot that misses by [param miss] pixels, translated.
static func of_wrong(miss: float) -> String:
	return LabText.translate("misses by %s px") % NumberText.short(miss, 3)
