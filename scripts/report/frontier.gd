class_name Frontier
extends RefCounted
## The frontier between error and run time: the methods that no other method beats (the Pareto
## front).
##
## Measurements of different situations are never compared. One without an answer is on no frontier.


## Whether [param one] is at least as good as [param other] in error and in run time, and better in
## one of them. False for different problems or situations.
static func beats(one: Measurement, other: Measurement) -> bool:
	if one.problem != other.problem or one.situation != other.situation:
		return false
	if one.error > other.error or one.run_time_us > other.run_time_us:
		return false
	return one.error < other.error or one.run_time_us < other.run_time_us


## The measurements that none of them beats, the fastest first.
static func of(measurements: Array[Measurement]) -> Array[Measurement]:
	var found: Array[Measurement] = []
	for candidate in measurements:
		if candidate.has_answer() and not _is_beaten(candidate, measurements):
			found.append(candidate)
	found.sort_custom(_is_faster)
	return found


static func _is_beaten(candidate: Measurement, measurements: Array[Measurement]) -> bool:
	for other in measurements:
		if beats(other, candidate):
			return true
	return false


static func _is_faster(one: Measurement, other: Measurement) -> bool:
	return one.run_time_us < other.run_time_us
