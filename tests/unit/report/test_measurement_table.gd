extends LabTest
## The file error_vs_time.csv.


func test_the_first_line_names_the_columns() -> void:
	var wanted := "problem,method,setting,peer,run_time_us,error,error_unit,note\n"
	assert_eq(MeasurementTable.to_csv([]), wanted)


func test_a_line_has_a_cell_for_each_column() -> void:
	var line := _lines([_made()])[1]
	var cells: Array = Array(MeasurementTable.cells(line))
	assert_eq(cells, ["box", "event world", "300 px/s, 60 Hz", "1", "12.5", "3e-13", "px", "calm"])


func test_commas_and_quotes_in_a_text_come_back() -> void:
	var made := _made()
	made.note = 'a "short", odd note'
	made.method = '"'
	var cells := MeasurementTable.cells(_lines([made])[1])
	assert_eq([cells[1], cells[7]], ['"', 'a "short", odd note'])


func test_a_line_break_in_a_note_does_not_break_the_line() -> void:
	var made := _made()
	made.note = "one\ntwo"
	assert_eq(_lines([made]).size(), 2)


func test_no_answer_is_an_empty_cell() -> void:
	var made := _made()
	made.error = Measurement.NO_ANSWER
	made.run_time_us = Measurement.NO_ANSWER
	var line := _lines([made])[1]
	assert_eq(MeasurementTable.cells(line).slice(4, 6), PackedStringArray(["", ""]))
	assert_false(line.to_lower().contains("inf"))


func test_numbers_keep_all_their_digits() -> void:
	var made := _made()
	made.error = 0.1 + 0.2
	assert_eq(MeasurementTable.cells(_lines([made])[1])[5], "0.30000000000000004")


func _made() -> Measurement:
	var made := Measurement.new()
	made.problem = "box"
	made.method = "event world"
	made.situation = "300 px/s"
	made.tuning = "60 Hz"
	made.is_baseline = true
	made.run_time_us = 12.5
	made.error = 3e-13
	made.note = "calm"
	return made


func _lines(rows: Array[Measurement]) -> PackedStringArray:
	return MeasurementTable.to_csv(rows).strip_edges().split("\n")
