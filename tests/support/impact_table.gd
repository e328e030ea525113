class_name ImpactTable
extends RefCounted
## The reference impacts of tests/data/reference: rows of doubles, and how an answer is judged by
## them. The columns are read from the file, so that another table of the same form can take its
## place.

const FOLDER := "res://tests/data/reference/"

## The distance from 1 to the next larger double.
const EPSILON := 1.0 / 2.0 ** 52

var _columns: Array = []
var _families: Array = []
var _numbers: PackedFloat64Array = []
var _places: Dictionary[String, int] = {}


func _init(table: String) -> void:
	var text := FileAccess.get_file_as_string(FOLDER + "columns.json")
	var content: Dictionary = JSON.parse_string(text)
	_columns = content[table]
	_families = content["families"]
	_numbers = FileAccess.get_file_as_bytes(FOLDER + table + ".f64").to_float64_array()
	for place: int in _columns.size():
		_places[_columns[place]] = place


## How many rows there are.
func size() -> int:
	return floori(_numbers.size() / float(_columns.size()))


## The number in a row and a column.
func at(row: int, column: String) -> float:
	return _numbers[row * _columns.size() + _places[column]]


## Whether the ball hits in that row.
func is_hit(row: int) -> bool:
	return at(row, "hit") == 1.0


## The name of the row's family, or the number of its kind.
func family(row: int) -> String:
	if _places.has("family"):
		return _families[int(at(row, "family"))]
	return "kind %d" % int(at(row, "kind"))


## The error of a time as reference/README.md defines it: in units that no double can beat by much.
func time_error(row: int, time: float) -> float:
	var wanted := at(row, "t")
	if time == wanted:
		return 0.0
	return absf(time - wanted) / (EPSILON * maxf(at(row, "condition"), wanted))


## The error of a normal, in the same sense; [param speed], [param place] and [param other] are the
## lengths of velocity, position and what is touched.
func normal_error(row: int, normal: Vec2, radius: float, lengths: PackedFloat64Array) -> float:
	var wanted := Vec2.new(at(row, "nx"), at(row, "ny"))
	return normal_error_by(at(row, "condition"), normal, wanted, radius, lengths)


## The same for a table of another form, with the condition of the time.
static func normal_error_by(
	condition: float, normal: Vec2, wanted: Vec2, radius: float, lengths: PackedFloat64Array
) -> float:
	var scale := lengths[0] * condition + lengths[1] + lengths[2]
	return normal.distance_to(wanted) / (EPSILON * (1.0 + scale / radius))
