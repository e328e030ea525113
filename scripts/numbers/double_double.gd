class_name DoubleDouble
extends RefCounted
## A number with about 106 bits, twice as many as a double: the unevaluated sum of two doubles.
##
## It is for readouts and tests that state the error of a double, and too slow for motion. A number
## never changes: every operation returns a new one, with a relative error below 2^-100. All
## numbers, intermediate ones included, must be 0 or have a magnitude between 1e-290 and 1e290.
## [br][br]
## Sources. Exact sum: Knuth, The Art of Computer Programming 2, section 4.2.2. Exact product, with
## Veltkamp's splitting: Dekker, A Floating-Point Technique for Extending the Available Precision,
## 1971. Numbers as sums of doubles: Shewchuk, Adaptive Precision Floating-Point Arithmetic, 1997.
## Sum and product of two such numbers: Joldes, Muller and Popescu, Tight and Rigorous Error Bounds
## for Basic Building Blocks of Double-Word Arithmetic, 2017.

## Multiplying by this splits the 53 bits of a double into two halves (Veltkamp).
const _SPLITTER := 2.0 ** 27 + 1.0

## The double nearest to the number.
var high: float

## The rest of the number, at most half a unit in the last place of [member high].
var low: float


## Takes both parts unchecked. Use [method from_float], [method sum_of] or [method product_of],
## whose parts fit together.
func _init(high_part: float, low_part: float) -> void:
	high = high_part
	low = low_part


## Both parts with all their digits, such as 0.1 + 5.5e-18.
func _to_string() -> String:
	return "%s + %s" % [String.num_scientific(high), String.num_scientific(low)]


## The double [param value], exactly.
static func from_float(value: float) -> DoubleDouble:
	return DoubleDouble.new(value, 0.0)


## a + b, exactly (two-sum).
static func sum_of(a: float, b: float) -> DoubleDouble:
	var sum := a + b
	var b_part := sum - a
	var a_part := sum - b_part
	return DoubleDouble.new(sum, (a - a_part) + (b - b_part))


## a times b, exactly (Dekker's product).
static func product_of(a: float, b: float) -> DoubleDouble:
	var product := a * b
	var a_high := _upper_half(a)
	var a_low := a - a_high
	var b_high := _upper_half(b)
	var b_low := b - b_high
	var rest := ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low
	return DoubleDouble.new(product, rest)


## The sum of this number and [param other].
func plus(other: DoubleDouble) -> DoubleDouble:
	var highs := sum_of(high, other.high)
	var lows := sum_of(low, other.low)
	var carried := sum_of(highs.high, highs.low + lows.high)
	return sum_of(carried.high, carried.low + lows.low)


## This number less [param other].
func minus(other: DoubleDouble) -> DoubleDouble:
	return plus(other.negated())


## The number with the other sign, exactly.
func negated() -> DoubleDouble:
	return DoubleDouble.new(-high, -low)


## Whether this number is smaller than [param other]; equal ones are not.
func is_less_than(other: DoubleDouble) -> bool:
	return high < other.high or (high == other.high and low < other.low)


## The product of this number and [param other].
func times(other: DoubleDouble) -> DoubleDouble:
	var product := product_of(high, other.high)
	return sum_of(product.high, product.low + (high * other.low + low * other.high))


## This number divided by [param divisor]. A divisor of 0 is refused with an error, and the result
## is this number.
func divided(divisor: DoubleDouble) -> DoubleDouble:
	if divisor.high == 0.0:
		push_error("DoubleDouble.divided: the divisor must not be 0; %s stays undivided." % self)
		return self
	var estimate := high / divisor.high
	var rest := minus(divisor.times(from_float(estimate)))
	return sum_of(estimate, rest.high / divisor.high)


## The square root. A negative number is refused with an error, and the result is this number.
func square_root() -> DoubleDouble:
	if high < 0.0:
		push_error("DoubleDouble.square_root: the number must be 0 or more, but is %s." % self)
		return self
	if high == 0.0:
		return from_float(0.0)
	var estimate := sqrt(high)
	var rest := minus(product_of(estimate, estimate))
	return sum_of(estimate, rest.high / (2.0 * estimate))


## The double nearest to the number.
func to_float() -> float:
	return high


## The error of [param value] if this number is exact: above 0 if it is too large, below 0 if it is
## too small.
func error_of(value: float) -> float:
	return from_float(value).minus(self).to_float()


static func _upper_half(value: float) -> float:
	var spread := _SPLITTER * value
	return spread - (spread - value)
