class_name EventPi
extends PiCase
## Two blocks and a wall, from impact to impact; see [TwoBlocks].

## The name of the method in tables.
const METHOD := "from impact to impact"

const _AT_ONCE := 100_000_000


## Blocks for this n.
func _init(of_n: int) -> void:
	super(of_n)
	method = METHOD


func _count_impacts() -> void:
	var blocks := TwoBlocks.new()
	keep_refusal(blocks.start(mass_ratio()))
	var start := Time.get_ticks_usec()
	if blocks.run(_AT_ONCE):
		keep_refusal("There are more than %d impacts." % _AT_ONCE)
	_spent = Time.get_ticks_usec() - start
	_count = blocks.impacts
	figures["energy drift"] = absf(blocks.energy_drift())
