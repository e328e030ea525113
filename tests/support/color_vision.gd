class_name ColorVision
## How colours look: contrast, and what is left of a difference for colour-blind readers.
##
## Contrast: Web Content Accessibility Guidelines 2.1, "relative luminance" and "contrast ratio".
## Colour blindness: Machado, Oliveira and Fernandes 2009, full severity, on linear RGB.
## Difference: CIE 1976, the distance in L*a*b* under D65.

## A kind of colour blindness, or none.
enum Kind { USUAL, PROTANOPIA, DEUTERANOPIA, TRITANOPIA }

# Rows for red, green and blue.
const _MATRICES: Dictionary[Kind, Array] = {
	Kind.USUAL: [Vector3(1, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1)],
	Kind.PROTANOPIA:
	[
		Vector3(0.152286, 1.052583, -0.204868),
		Vector3(0.114503, 0.786281, 0.099216),
		Vector3(-0.003882, -0.048116, 1.051998),
	],
	Kind.DEUTERANOPIA:
	[
		Vector3(0.367322, 0.860646, -0.227968),
		Vector3(0.280085, 0.672501, 0.047413),
		Vector3(-0.011820, 0.042940, 0.968881),
	],
	Kind.TRITANOPIA:
	[
		Vector3(1.255528, -0.076749, -0.178779),
		Vector3(-0.078411, 0.930809, 0.147602),
		Vector3(0.004733, 0.691367, 0.303900),
	],
}


## From 1 for two equal colours to 21 for black on white.
static func contrast(one: Color, other: Color) -> float:
	var lighter := maxf(_luminance(one), _luminance(other))
	var darker := minf(_luminance(one), _luminance(other))
	return (lighter + 0.05) / (darker + 0.05)


## How different two colours look; below about 2 nobody tells them apart side by side.
static func difference(one: Color, other: Color, kind: Kind) -> float:
	return _lab(_seen(one, kind)).distance_to(_lab(_seen(other, kind)))


static func _seen(color: Color, kind: Kind) -> Color:
	var linear := color.srgb_to_linear()
	var rgb := Vector3(linear.r, linear.g, linear.b)
	var rows: Array = _MATRICES[kind]
	var seen := PackedFloat64Array()
	for row: Vector3 in rows:
		seen.append(clampf(row.dot(rgb), 0.0, 1.0))
	return Color(seen[0], seen[1], seen[2])


static func _luminance(color: Color) -> float:
	var linear := color.srgb_to_linear()
	return 0.2126 * linear.r + 0.7152 * linear.g + 0.0722 * linear.b


# From linear RGB by way of XYZ, each relative to the white of D65.
static func _lab(linear: Color) -> Vector3:
	var x := 0.4124564 * linear.r + 0.3575761 * linear.g + 0.1804375 * linear.b
	var y := 0.2126729 * linear.r + 0.7151522 * linear.g + 0.0721750 * linear.b
	var z := 0.0193339 * linear.r + 0.1191920 * linear.g + 0.9503041 * linear.b
	var fx := _lab_root(x / 0.95047)
	var fy := _lab_root(y)
	var fz := _lab_root(z / 1.08883)
	return Vector3(116.0 * fy - 16.0, 500.0 * (fx - fy), 200.0 * (fy - fz))


static func _lab_root(share: float) -> float:
	return (
		pow(share, 1.0 / 3.0) if share > 216.0 / 24389.0 else (841.0 / 108.0 * share + 4.0 / 29.0)
	)
