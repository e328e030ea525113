extends LabTest
## Which of many things happens next.


func test_an_empty_place_never_comes_first() -> void:
	var queue := EventQueue.new()
	queue.resize(5)
	assert_eq(queue.first_time, INF)


func test_the_earliest_of_random_times_comes_first_after_each_change() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 3
	var queue := EventQueue.new()
	queue.resize(37)
	var times := PackedFloat64Array()
	times.resize(37)
	times.fill(INF)
	var wrong := 0
	for change: int in 2000:
		var index := rng.randi_range(0, 36)
		times[index] = INF if rng.randf() < 0.1 else rng.randf()
		queue.change(index, times[index])
		var sorted := times.duplicate()
		sorted.sort()
		if queue.first_time != sorted[0] or queue.first != times.find(sorted[0]):
			wrong += 1
	assert_eq(wrong, 0)


func test_of_equal_times_the_smaller_index_comes_first() -> void:
	var queue := EventQueue.new()
	queue.resize(4)
	for index: int in [3, 1, 2]:
		queue.change(index, 5.0)
	assert_eq(queue.first, 1)


func test_equal_times_are_told_apart_by_their_low_parts() -> void:
	var queue := EventQueue.new()
	queue.resize(4)
	queue.change(1, 5.0, 1e-17)
	queue.change(2, 5.0, -1e-17)
	queue.change(3, 5.0)
	assert_eq([queue.first, queue.first_low], [2, -1e-17])
	queue.change(2, INF)
	assert_eq([queue.first, queue.first_low], [3, 0.0])


func test_growing_keeps_the_times() -> void:
	var queue := EventQueue.new()
	queue.resize(2)
	queue.change(1, 4.0)
	queue.resize(9)
	queue.change(8, 6.0)
	assert_eq([queue.first, queue.first_time], [1, 4.0])


func test_one_place_is_enough() -> void:
	var queue := EventQueue.new()
	queue.resize(1)
	queue.change(0, 2.5)
	assert_eq([queue.first, queue.first_time], [0, 2.5])
