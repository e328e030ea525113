class_name ShotText
extends RefCounted
## What lessons on aiming say of a shot: by how much it misses, and how far rounding alone may move
## it. A miss is the smallest distance of both centres.


## A right shot, in one line, translated: it misses by [param miss] pixels, and rounding alone may
## move it by [param from_rounding], which is the epsilon of [ShotCondition] times its condition.
static func of_right(miss: float, from_rounding: float) -> String:
	var sentence := LabText.translate("miss %s px; ε × condition %s px")
	# The product is one thing: no line ends in it.
	sentence = sentence.replace("ε × ", "ε\u00a0×\u00a0")
	return sentence % [NumberText.size(miss), NumberText.size(from_rounding)]


## A shot that misses by [param miss] pixels, translated.
static func of_wrong(miss: float) -> String:
	return LabText.translate("misses by %s px") % NumberText.short(miss, 3)
