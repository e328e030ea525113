class_name OwnPictures
extends RefCounted
## The pictures of the student's answers, by the lessons on whose boards they are drawn.


## The picture for the lesson with this id; null where there is none.
static func of_lesson(id: String) -> OwnPicture:
	match id:
		"normals":
			return OwnNormals.new()
		"dot_product":
			return OwnDotProduct.new()
		"line_distance":
			return OwnLineDistance.new()
		"point_of_impact":
			return OwnPointOfImpact.new()
		"reflection":
			return OwnReflection.new()
		"line_ends":
			return OwnLineEnds.new()
		"lead_target":
			return OwnLeadTarget.new()
		"ballistic_aim":
			return OwnBallisticAim.new()
		"bank_shot":
			return OwnBankShot.new()
	return null
