class_name MotionTable
extends RefCounted
## The reference answers of tests/data/reference_motion: rows of doubles, and how an answer is
## judged by them.

const FOLDER := "res://tests/data/reference_motion/"

var _columns: Array = []
var _families: Array = []
var _numbers: PackedFloat64Array = []
var _places: Dictionary[String, int] = {}


func _init(table: String) -> void:
	var content: Dictionary = JSON.parse_string(
		FileAccess.get_file_as_string(FOLDER + "columns.json")
	)
	var families: Dictionary = content["families"]
	_columns = content[table]
	_families = families[table]
	_numbers = FileAccess.get_file_as_bytes(FOLDER + table + ".f64").to_float64_array()
	for place: int in _columns.size():
		_places[_columns[place]] = place


## How many rows there are.
func size() -> int:
	return floori(_numbers.size() / float(_columns.size()))


## The number in a row and a column.
func at(row: int, column: String) -> float:
	return _numbers[row * _columns.size() + _places[column]]


## Whether the table has that column.
func has(column: String) -> bool:
	return _places.has(column)


## The vector in two columns of a row, such as `sx` and `sy`.
func vector(row: int, x_column: String, y_column: String) -> Vec2:
	return Vec2.new(at(row, x_column), at(row, y_column))


## The name of the row's family.
func family(row: int) -> String:
	return _families[int(at(row, "family"))]


## The error of a number as reference_motion/README.md defines it.
func error(row: int, number: float, column: String, condition := "condition") -> float:
	var wanted := at(row, column)
	if number == wanted:
		return 0.0
	return absf(number - wanted) / (ImpactTable.EPSILON * maxf(at(row, condition), absf(wanted)))


## The error of a direction, in the same sense.
func aim_error(row: int, direction: Vec2, wanted: Vec2, condition := "condition_aim") -> float:
	return direction.distance_to(wanted) / (ImpactTable.EPSILON * maxf(at(row, condition), 1.0))


## The error of a velocity, in the same sense: with lengths.
func velocity_error(row: int, velocity: Vec2, wanted: Vec2, condition: String) -> float:
	var distance := velocity.distance_to(wanted)
	if distance == 0.0:
		return 0.0
	return distance / (ImpactTable.EPSILON * maxf(at(row, condition), wanted.length()))


## The error of the normal of an impact, as [ImpactTable] judges it; [param lengths] are those of
## the relative velocity, the position and what is touched.
func normal_error(row: int, normal: Vec2, radius: float, lengths: PackedFloat64Array) -> float:
	var wanted := vector(row, "nx", "ny")
	return ImpactTable.normal_error_by(at(row, "condition"), normal, wanted, radius, lengths)


## Whether there is a hit in that row.
func is_hit(row: int) -> bool:
	return at(row, "hit") == 1.0
