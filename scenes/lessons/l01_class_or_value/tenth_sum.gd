class_name TenthSum
## Adds 0.1 again and again, with 64 bits and with 32: neither holds 0.1 exactly, and every addition
## rounds.


## The x of a Vec2 after [param count] additions of 0.1.
static func with_64_bits(count: int) -> float:
	var sum := Vec2.new()
	for i in count:
		sum.x += 0.1
	return sum.x


## The x of a Vector2 after [param count] additions of 0.1.
static func with_32_bits(count: int) -> float:
	var sum := Vector2()
	for i in count:
		sum.x += 0.1
	return sum.x


## The exact sum of [param count] tenths.
static func exact(count: int) -> float:
	return count / 10.0
