extends RefCounted
## What benchmarks/vec2.gd measures: a loop, and the statements that are put into it.

## The loop and what the statements work with: the vectors v and w and the unit vector n as Vec2;
## the same as Vector2, called g, h and m; and as plain numbers, x and y to ny. The others take
## results.
const LOOP := """extends RefCounted

static func run(count: int, rng: RandomNumberGenerator) -> int:
	var v := Vec2.new(3.0, 4.0)
	var w := Vec2.new(-5.5, 2.5)
	var n := Vec2.new(0.6, 0.8)
	var g := Vector2(3.0, 4.0)
	var h := Vector2(-5.5, 2.5)
	var m := Vector2(0.6, 0.8)
	var x := 3.0
	var y := 4.0
	var wx := -5.5
	var wy := 2.5
	var nx := 0.6
	var ny := 0.8
	var rx := 0.0
	var ry := 0.0
	var a := 0.0
	var b := 0.0
	var c := 0.0
	var angle := 0.3
	var degrees := 17.0
	var flag := false
	var vector := v
	var engine_vector := g
	var started := Time.get_ticks_usec()
	for _index: int in count:
		%s
	return Time.get_ticks_usec() - started
"""

## Method: the statement for Vec2, the one for Vector2 ("" if there is none), and the arithmetic
## with plain numbers. Where a method acts only at times, all three first set the stage alike.
const STATEMENTS: Dictionary[String, Array] = {
	"zero": ["vector = Vec2.zero()", "engine_vector = Vector2.ZERO", "rx = 0.0; ry = 0.0"],
	"copy": ["vector = v.copy()", "engine_vector = g", "rx = x; ry = y"],
	"set_xy": ["v.set_xy(x, y)", "g = Vector2(x, y)", "rx = x; ry = y"],
	"add": ["v.add(w)", "g += h", "x += wx; y += wy"],
	"subtract": ["v.subtract(w)", "g -= h", "x -= wx; y -= wy"],
	"scale": ["v.scale(a)", "g *= a", "x *= a; y *= a"],
	"plus": ["vector = v.plus(w)", "engine_vector = g + h", "rx = x + wx; ry = y + wy"],
	"minus": ["vector = v.minus(w)", "engine_vector = g - h", "rx = x - wx; ry = y - wy"],
	"scaled": ["vector = v.scaled(a)", "engine_vector = g * a", "rx = x * a; ry = y * a"],
	"divided": ["vector = v.divided(wy)", "engine_vector = g / wy", "rx = x / wy; ry = y / wy"],
	"negated": ["vector = v.negated()", "engine_vector = -g", "rx = -x; ry = -y"],
	"length": ["a = v.length()", "a = g.length()", "a = sqrt(x * x + y * y)"],
	"length_squared": ["a = v.length_squared()", "a = g.length_squared()", "a = x * x + y * y"],
	"distance_to":
	[
		"a = v.distance_to(w)",
		"a = g.distance_to(h)",
		"rx = x - wx; ry = y - wy; a = sqrt(rx * rx + ry * ry)",
	],
	"normalize": ["v.normalize()", "g = g.normalized()", "a = sqrt(x * x + y * y); x /= a; y /= a"],
	"normalized":
	[
		"vector = v.normalized()",
		"engine_vector = g.normalized()",
		"a = sqrt(x * x + y * y); rx = x / a; ry = y / a",
	],
	"normal":
	[
		"vector = v.normal()",
		"engine_vector = -g.orthogonal().normalized()",
		"a = sqrt(x * x + y * y); rx = -y / a; ry = x / a",
	],
	"set_length":
	[
		"v.set_length(7.0)",
		"g = g.normalized() * 7.0",
		"a = 7.0 / sqrt(x * x + y * y); x *= a; y *= a",
	],
	"limit_length":
	[
		"v.x = 30.0; v.limit_length(7.0)",
		"g.x = 30.0; g = g.limit_length(7.0)",
		"x = 30.0; a = sqrt(x * x + y * y); b = 7.0 / a if a > 7.0 else 1.0; x *= b; y *= b",
	],
	"dot": ["a = v.dot(w)", "a = g.dot(h)", "a = x * wx + y * wy"],
	"cross": ["a = v.cross(w)", "a = g.cross(h)", "a = x * wy - y * wx"],
	"scalar_projection":
	[
		"a = v.scalar_projection(w)",
		"a = g.dot(h.normalized())",
		"a = (x * wx + y * wy) / sqrt(wx * wx + wy * wy)",
	],
	"vector_projection":
	[
		"vector = v.vector_projection(w)",
		"engine_vector = g.project(h)",
		"a = (x * wx + y * wy) / (wx * wx + wy * wy); rx = wx * a; ry = wy * a",
	],
	"rejection":
	[
		"vector = v.rejection(w)",
		"engine_vector = g.slide(h.normalized())",
		"a = (y * wx - x * wy) / (wx * wx + wy * wy); rx = -wy * a; ry = wx * a",
	],
	"reflect":
	["v.reflect(n)", "g = g.bounce(m)", "a = 2.0 * (x * nx + y * ny); x -= a * nx; y -= a * ny"],
	"reflected":
	[
		"vector = v.reflected(n)",
		"engine_vector = g.bounce(m)",
		"a = 2.0 * (x * nx + y * ny); rx = x - a * nx; ry = y - a * ny",
	],
	"unit_radians":
	[
		"vector = Vec2.unit_radians(angle)",
		"engine_vector = Vector2.from_angle(angle)",
		"rx = cos(angle); ry = sin(angle)",
	],
	"unit_degrees":
	[
		"vector = Vec2.unit_degrees(degrees)",
		"engine_vector = Vector2.from_angle(deg_to_rad(degrees))",
		"a = deg_to_rad(degrees); rx = cos(a); ry = sin(a)",
	],
	"random_unit":
	[
		"vector = Vec2.random_unit(rng)",
		"engine_vector = Vector2.from_angle(TAU * rng.randf())",
		"a = TAU * rng.randf(); rx = cos(a); ry = sin(a)",
	],
	"rotate_radians":
	[
		"v.rotate_radians(angle)",
		"g = g.rotated(angle)",
		"b = cos(angle); c = sin(angle); rx = x * b - y * c; y = x * c + y * b; x = rx",
	],
	"rotate_degrees":
	[
		"v.rotate_degrees(degrees)",
		"g = g.rotated(deg_to_rad(degrees))",
		(
			"a = deg_to_rad(degrees); b = cos(a); c = sin(a); rx = x * b - y * c;"
			+ " y = x * c + y * b; x = rx"
		),
	],
	"rotate_around_radians":
	[
		"v.rotate_around_radians(w, angle)",
		"g = h + (g - h).rotated(angle)",
		(
			"b = cos(angle); c = sin(angle); rx = x - wx; ry = y - wy;"
			+ " x = wx + rx * b - ry * c; y = wy + rx * c + ry * b"
		),
	],
	"rotate_around_degrees":
	[
		"v.rotate_around_degrees(w, degrees)",
		"g = h + (g - h).rotated(deg_to_rad(degrees))",
		(
			"a = deg_to_rad(degrees); b = cos(a); c = sin(a); rx = x - wx; ry = y - wy;"
			+ " x = wx + rx * b - ry * c; y = wy + rx * c + ry * b"
		),
	],
	"set_angle_radians":
	[
		"v.set_angle_radians(angle)",
		"g = Vector2.from_angle(angle) * g.length()",
		"a = sqrt(x * x + y * y); x = a * cos(angle); y = a * sin(angle)",
	],
	"set_angle_degrees":
	[
		"v.set_angle_degrees(degrees)",
		"g = Vector2.from_angle(deg_to_rad(degrees)) * g.length()",
		"a = sqrt(x * x + y * y); b = deg_to_rad(degrees); x = a * cos(b); y = a * sin(b)",
	],
	"angle_radians": ["a = v.angle_radians()", "a = g.angle()", "a = atan2(y, x)"],
	"angle_degrees":
	["a = v.angle_degrees()", "a = rad_to_deg(g.angle())", "a = rad_to_deg(atan2(y, x))"],
	"angle_to":
	[
		"a = v.angle_to(w)",
		"a = g.angle_to(h)",
		"a = atan2(x * wy - y * wx, x * wx + y * wy)",
	],
	"lerped":
	[
		"vector = v.lerped(w, 0.3)",
		"engine_vector = g.lerp(h, 0.3)",
		"rx = x + (wx - x) * 0.3; ry = y + (wy - y) * 0.3",
	],
	"moved_toward":
	[
		"vector = v.moved_toward(w, 2.0)",
		"engine_vector = g.move_toward(h, 2.0)",
		"rx = wx - x; ry = wy - y; a = 2.0 / sqrt(rx * rx + ry * ry); rx = x + rx * a; ry = y + ry * a",
	],
	"equals_approx":
	[
		"flag = v.equals_approx(w, 1e-9)",
		"flag = g.is_equal_approx(h)",
		"flag = absf(x - wx) <= 1e-9 and absf(y - wy) <= 1e-9",
	],
	"is_finite":
	["flag = v.is_finite()", "flag = g.is_finite()", "flag = is_finite(x) and is_finite(y)"],
	"to_vector2": ["engine_vector = v.to_vector2()", "", "engine_vector = Vector2(x, y)"],
	"from_vector2": ["vector = Vec2.from_vector2(g)", "", "rx = g.x; ry = g.y"],
	"deg_to_rad": ["a = Vec2.deg_to_rad(degrees)", "", "a = degrees * (PI / 180.0)"],
	"rad_to_deg": ["a = Vec2.rad_to_deg(angle)", "", "a = angle * (180.0 / PI)"],
}
