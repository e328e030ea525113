class_name LineEndsPresets
## The presets of the lesson on line ends: shots with their lines.

## By their titles (source text): x and y of the ball's centre, x and y of its motion, its radius, x
## and y of both ends of the line.
const SHOTS: Dictionary[String, Array] = {
	"End": [-6.0, -8.0, 6.0, 16.0, 5.0, 1.0, 3.0, 13.0, 8.0],
	"Good side": [-4.0, 12.0, 8.0, -16.0, 3.0, -9.0, 4.0, 9.0, 4.0],
	"Head-on": [-6.0, 0.0, 10.0, 0.0, 3.0, 2.0, 0.0, 12.0, 0.0],
	"Middle": [-4.0, -10.0, 8.0, 16.0, 3.0, -9.0, 4.0, 9.0, 4.0],
	"Miss": [-9.0, -7.0, 16.0, 12.0, 3.0, 3.0, -4.0, 12.0, -8.0],
	"Overlap": [-4.0, -2.0, 6.0, 8.0, 5.0, -1.0, 1.0, 11.0, 4.0],
}


## Puts the shot [param preset] into [param model] and shows the end of the frame.
static func lay(model: LineEndsModel, preset: String) -> void:
	var numbers: PackedFloat64Array = SHOTS[preset]
	model.start = Vec2.new(numbers[0], numbers[1])
	model.motion = Vec2.new(numbers[2], numbers[3])
	model.radius = numbers[4]
	model.segment = LineSegment.new(
		Vec2.new(numbers[5], numbers[6]), Vec2.new(numbers[7], numbers[8])
	)
	model.fraction = 1.0
