class_name MyVec2

var x
var y

func _init(a = 0, b = 0):
	x = a
	y = b

func length():
	return sqrt(pow(x, 2) + pow(y, 2))

func rotate(angle):
	var new_x = x * cos(angle) - y * sin(angle)
	var new_y = x * sin(angle) + y * cos(angle)
	x = new_x
	y = new_y

func rotate_around(point, angle):
	x = x - point.x
	y = y - point.y
	rotate(angle)
	x = x + point.x
	y = y + point.y

func normalized():
	if length() == 0:
		return MyVec2.new(0, 0)
	return MyVec2.new(x / length(), y / length())

func normal():
	if length() == 0:
		return MyVec2.new(0, 0)
	return MyVec2.new(-y / length(), x / length())

func dot(v):
	return v.x * x + v.y * y

func scalar_projection(onto):
	return dot(onto.normalized())

func vector_projection(onto):
	var unit = onto.normalized()
	var s = scalar_projection(onto)
	return MyVec2.new(unit.x * s, unit.y * s)

func reflect(n, c = 1):
	var s = dot(n)
	x = x - (1 + c) * s * n.x
	y = y - (1 + c) * s * n.y
