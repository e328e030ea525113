class_name SteppedPi
extends PiCase
## Two blocks and a wall in equal steps, the lecture's simple way: move both, test whether they
## overlap the wall or each other, put them back, bounce.

var _rate: int


## Blocks for this n, with [param at_rate] steps a second.
func _init(of_n: int, at_rate: int) -> void:
	super(of_n)
	method = "stepped"
	tuning = "%d Hz" % at_rate
	_rate = at_rate


func _count_impacts() -> void:
	var light := TwoBlocks.LIGHT_START
	var heavy := TwoBlocks.HEAVY_START
	var light_speed := 0.0
	var heavy_speed := TwoBlocks.HEAVY_SPEED
	var share := 2.0 / (1.0 + mass_ratio())
	var count := 0
	var step := 1.0 / _rate
	var start := Time.get_ticks_usec()
	for i in roundi(SECONDS * _rate):
		light += light_speed * step
		heavy += heavy_speed * step
		if light < 0.0:
			light = 0.0
			if light_speed < 0.0:
				light_speed = -light_speed
				count += 1
		var approach := light_speed - heavy_speed
		if heavy < light:
			heavy = light
			if approach > 0.0:
				heavy_speed += approach * share
				light_speed = heavy_speed - approach
				count += 1
	_spent = Time.get_ticks_usec() - start
	_count = count
