class_name EventQueue
extends RefCounted
## Which of many things happens next. It keeps a time for each, and finds the earliest without
## looking at all of them.
##
## It is a tournament: each pair plays, the earlier one goes on, and the winner of all is at the
## top. When one time changes, only its own matches are played again: as many as the count has
## binary digits. A time is the sum of two numbers, the second one smaller than the last place of
## the first. Of two equal times the smaller index wins, so that the order is always the same.

## The index that comes first; 0 where nothing is ever to happen.
var first := 0
## When that is, in seconds; INF where nothing is ever to happen.
var first_time := INF
## The second part of [member first_time].
var first_low := 0.0
## The time of each index, in seconds, INF for never. Read it; change it by [method change].
var times: PackedFloat64Array = []
## The second parts of [member times].
var lows: PackedFloat64Array = []

# A complete binary tree: the children of match k are 2k and 2k + 1; the indices themselves follow
# the last match.
var _winners: PackedInt32Array = [0, 0]
var _capacity := 1


## Makes room for this many and keeps the times that it has; new ones never happen.
func resize(count: int) -> void:
	var old := times.size()
	_capacity = 1
	while _capacity < count:
		_capacity *= 2
	times.resize(_capacity)
	lows.resize(_capacity)
	for index in range(mini(old, count), _capacity):
		times[index] = INF
		lows[index] = 0.0
	_winners.resize(2 * _capacity)
	for index in _capacity:
		_winners[_capacity + index] = index
	for index in range(_capacity - 1, 0, -1):
		_winners[index] = _earlier(_winners[2 * index], _winners[2 * index + 1])
	_note_first()


## Sets the time of one index, as the sum of [param time] and [param low].
func change(index: int, time: float, low: float = 0.0) -> void:
	times[index] = time
	lows[index] = low
	# On the way up the winner so far meets the winner from the other side. The steps of _earlier
	# are written out, because every event of a world comes through here.
	var winner := index
	var winner_time := time
	var place := _capacity + index
	while place > 1:
		var rival := _winners[place ^ 1]
		var rival_time := times[rival]
		if rival_time < winner_time:
			winner = rival
			winner_time = rival_time
		elif (
			rival_time == winner_time
			and rival == _earlier(mini(rival, winner), maxi(rival, winner))
		):
			winner = rival
		place >>= 1
		if winner != index and winner == _winners[place]:
			break
		_winners[place] = winner
	first = _winners[1]
	first_time = times[first]
	first_low = lows[first]


func _note_first() -> void:
	first = _winners[1]
	first_time = times[first]
	first_low = lows[first]


func _earlier(left: int, right: int) -> int:
	if times[left] == times[right]:
		return left if lows[left] <= lows[right] else right
	return left if times[left] < times[right] else right
