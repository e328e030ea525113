extends LabTest
## The file error_vs_time.csv.


func test_the_first_line_names_the_columns() -> void:
	var wanted := "problem,method,setting,peer,run_time_us,error,error_unit,note"
	wanted += ",lower_quartile_us,upper_quartile_us\n"
	assert_eq(MeasurementTable.to_csv([]), wanted)


func test_a_line_has_a_cell_for_each_column() -> void:
	var line := _lines([_made()])[1]
	var cells: Array = Array(MeasurementTable.cells(line))
	assert_eq(
		cells,
		["box", "event world", "300 px/s, 60 Hz", "1", "12.5", "3e-13", "px", "calm", "", "13"]
	)


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


func test_what_is_written_can_be_read_again() -> void:
	var made := _made()
	made.note = 'a "short", odd note'
	var read := MeasurementTable.from_csv(MeasurementTable.to_csv([made]))[0]
	assert_eq([read.problem, read.method, read.setting], ["box", "event world", "300 px/s, 60 Hz"])
	assert_eq([read.is_baseline, read.run_time_us, read.note], [true, 12.5, 'a "short", odd note'])
	assert_eq([is_nan(read.lower_quartile_us), read.upper_quartile_us], [true, 13.0])


func test_an_older_report_has_no_quartiles() -> void:
	var text := "problem,method,setting,peer,run_time_us,error,error_unit,note\na,b,c,0,2.5,,px,\n"
	var read := MeasurementTable.from_csv(text)[0]
	assert_eq([read.run_time_us, read.has_answer()], [2.5, false])
	assert_true(is_nan(read.lower_quartile_us) and is_nan(read.upper_quartile_us))


func test_another_text_holds_no_measurement() -> void:
	for text: String in ["", "a,b,c\n1,2,3", "problem,method,setting,peer,time\na,b,c,0,1"]:
		assert_eq(MeasurementTable.from_csv(text).size(), 0, text)


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
	made.upper_quartile_us = 13.0
	return made


func _lines(rows: Array[Measurement]) -> PackedStringArray:
	return MeasurementTable.to_csv(rows).strip_edges().split("\n")
