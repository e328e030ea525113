class_name LabTest
extends "res://addons/gut/test.gd"
## The base of every test script of the project: GUT's own asserts, and those that know a Vec2.

## The smallest positive double.
const SMALLEST_SUBNORMAL := 1.0 / 2.0 ** 1000 / 2.0 ** 74

## The largest finite double.
const LARGEST_DOUBLE := (2.0 - 1.0 / 2.0 ** 52) * 2.0 ** 1023

## The distance from 1 to the next larger double.
const EPSILON := 1.0 / 2.0 ** 52

const _DATA_FOLDER := "res://tests/data/"


## Fails unless both components of [param got] are within [param tolerance] pixels of those of
## [param want]. Null and components that are not finite fail.
func assert_vec2(got: Vec2, want: Vec2, tolerance: float, text: String = "") -> void:
	var difference := vec2_difference(got, want, tolerance)
	if difference == "":
		pass_test("%s is as wanted. %s" % [got, text])
	else:
		fail_test("%s %s" % [difference, text])


## Fails if a method has refused what the test handed over: such a method returns a sentence, and ""
## when all went well. See [Refusal].
func assert_no_refusal(refusal: String) -> void:
	assert_eq(refusal, "")


## Fails unless every one of [param values] is at most [param bound]. NaN fails, and so does an
## empty list, which would prove nothing.
func assert_all_at_most(values: PackedFloat64Array, bound: float, text: String = "") -> void:
	var problem := "" if values.size() > 0 else "No value was given."
	for index: int in values.size():
		if problem == "" and not values[index] <= bound:
			var digits := String.num_scientific(values[index])
			problem = "Value %d is %s, above %s." % [index, digits, String.num_scientific(bound)]
	if problem == "":
		pass_test("%d values are at most %s. %s" % [values.size(), bound, text])
	else:
		fail_test("%s %s" % [problem, text])


## What [method assert_vec2] says of a vector that is not as wanted, and "" of one that is.
static func vec2_difference(got: Vec2, want: Vec2, tolerance: float) -> String:
	if got == null or want == null:
		return "Got %s, wanted %s." % [all_digits(got), all_digits(want)]
	# "not <=" instead of ">": a comparison with NaN is always false.
	if not absf(got.x - want.x) <= tolerance or not absf(got.y - want.y) <= tolerance:
		var texts: Array[String] = [all_digits(got), all_digits(want)]
		return "Got %s, wanted %s within " % texts + String.num_scientific(tolerance) + "."
	return ""


## Both components with all the digits that tell one double from the next.
static func all_digits(vector: Vec2) -> String:
	if vector == null:
		return "null"
	return "(%s, %s)" % [String.num_scientific(vector.x), String.num_scientific(vector.y)]


## Whether both are the same double to the last bit: 0.0 and -0.0 differ, NaN equals NaN.
static func same_bits(a: float, b: float) -> bool:
	return _bits(a) == _bits(b)


## Negative zero. It is a function because the compiler makes one constant of 0.0 and -0.0 where
## both are in one function.
static func negative_zero() -> float:
	return -0.0


## The distance from the magnitude of [param value] to the next larger double: one unit in the
## last place.
static func last_place(value: float) -> float:
	var bytes := PackedByteArray()
	bytes.resize(8)
	bytes.encode_s64(0, _bits(absf(value)) + 1)
	return bytes.decode_double(0) - absf(value)


## [param count] vectors with components spread evenly over -largest..largest, with all 53 bits;
## the same ones for the same seed.
static func random_vectors(seed_number: int, count: int, largest: float = 100.0) -> Array[Vec2]:
	var rng := RandomNumberGenerator.new()
	rng.seed = seed_number
	var vectors: Array[Vec2] = []
	for _index: int in count:
		vectors.append(Vec2.new(_random_component(rng, largest), _random_component(rng, largest)))
	return vectors


## The rows of a family in a file of reference values that tools/reference wrote.
static func reference_rows(file_name: String, family: String) -> Array[PackedFloat64Array]:
	var text := FileAccess.get_file_as_string(_DATA_FOLDER + file_name)
	var content: Dictionary = JSON.parse_string(text)
	var families: Dictionary = content["families"]
	var texts: Array = families[family]
	var rows: Array[PackedFloat64Array] = []
	for row: Array in texts:
		rows.append(_doubles(row))
	return rows


static func _doubles(hex_texts: Array) -> PackedFloat64Array:
	var doubles := PackedFloat64Array()
	for hex_digits: String in hex_texts:
		doubles.append(hex_digits.hex_decode().decode_double(0))
	return doubles


static func _bits(value: float) -> int:
	var bytes := PackedByteArray()
	bytes.resize(8)
	bytes.encode_double(0, value)
	return bytes.decode_s64(0)


static func _random_component(rng: RandomNumberGenerator, largest: float) -> float:
	# Godot's own randf gives the 24 bits of a 32-bit float.
	var share := (rng.randi() * 2.0 ** 21 + (rng.randi() >> 11)) / 2.0 ** 53
	return (2.0 * share - 1.0) * largest
