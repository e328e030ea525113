class_name CollisionFrictionCode
extends RefCounted
## The lines of GDScript that compute what each step of the lesson on friction at a bounce shows.


## The lines of [param step].
static func lines(contact: FrictionContact, step: int) -> PackedStringArray:
	match step:
		CollisionFrictionModel.Step.MEET:
			return (
				["var bounced := velocity.reflected(normal, bounciness)"]
				if _is_line(contact)
				else []
			)
		CollisionFrictionModel.Step.SLIP:
			return [
				"var tangent := Vec2.new(-normal.y, normal.x)",
				"var slip := velocity.dot(tangent) - radius * spin",
			]
		CollisionFrictionModel.Step.PUSH:
			return ["var push := -(1.0 + bounciness) * velocity.dot(normal)"]
		CollisionFrictionModel.Step.CONE:
			return _lines_on_cone(contact)
		CollisionFrictionModel.Step.AFTER:
			return _lines_on_after(contact)
		CollisionFrictionModel.Step.LEDGER:
			return ["var inertia := mass * radius * radius / 2.0"]
	return ["var place := start.plus(leaving.scaled(seconds))"]


static func _is_line(contact: FrictionContact) -> bool:
	return contact.other == null


static func _lines_on_cone(contact: FrictionContact) -> PackedStringArray:
	var found: PackedStringArray = ["var sticks := absf(slip) <= 3.0 * friction * push"]
	if contact.regime() == Friction.Regime.STICK:
		found.append("var grip := -slip / 3.0")
	else:
		found.append("var grip := -signf(slip) * friction * push")
	found.append("var impulse := normal.scaled(push).plus(tangent.scaled(grip))")
	return found


static func _lines_on_after(contact: FrictionContact) -> PackedStringArray:
	if contact.other:
		return [
			"var leaving_1 := velocity.plus(impulse.scaled(0.5))",
			"var leaving_2 := impulse.scaled(-0.5)",
			"var spin_1 := spin - grip / radius",
			"var spin_2 := -grip / radius",
		]
	return ["velocity.add(impulse)", "var spin_after := spin - 2.0 * grip / radius"]


## The values of the names in the lines.
static func inputs(contact: FrictionContact, flight: ContactFlight) -> Dictionary[String, Variant]:
	var push := contact.normal.scaled(contact.push())
	var leaving := contact.after()[flight.compared_ball()]
	return {
		"velocity": contact.ball.velocity,
		"spin": contact.ball.spin,
		"radius": contact.ball.radius,
		"mass": contact.ball.mass,
		"normal": contact.normal,
		"tangent": contact.tangent,
		"bounciness": contact.bounciness,
		"friction": contact.friction,
		"slip": contact.slip(),
		"push": contact.push(),
		"grip": contact.grip(),
		"impulse": push.plus(contact.tangent.scaled(contact.grip())),
		"start": leaving.position,
		"leaving": leaving.velocity,
		"seconds": flight.compared_after,
	}
