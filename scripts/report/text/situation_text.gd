class_name SituationText
extends RefCounted
## The text of the report on one situation of a problem: one item of a list.


## The frontier, how the best baselines compare with the method [param champion] (or with the most
## exact of the lab's own), and which methods gave no answer.
static func of(situation: String, rows: Array[Measurement], champion: String) -> String:
	var text := "- **%s**: on the frontier %s." % [situation, _names(Frontier.of(rows))]
	var champions := rows.filter(func(row: Measurement) -> bool: return row.method == champion)
	var own := fastest(champions, false) if champion else most_exact(rows, false)
	if own:
		text += _against(own, fastest(rows, true), "fastest baseline")
		var exact_baseline := most_exact(rows, true)
		if exact_baseline != fastest(rows, true):
			text += _against(own, exact_baseline, "most exact baseline")
	return text + _without_answer(rows)


## The fastest method with an answer, among the lab's own or among the baselines; null if there is
## none.
static func fastest(rows: Array[Measurement], is_baseline: bool) -> Measurement:
	var best: Measurement = null
	for row in rows:
		if row.is_baseline == is_baseline and row.has_answer():
			if best == null or row.run_time_us < best.run_time_us:
				best = row
	return best


## The method with the smallest error, and of equal ones the faster; null if there is none.
static func most_exact(rows: Array[Measurement], is_baseline: bool) -> Measurement:
	var best: Measurement = null
	for row in rows:
		if row.is_baseline == is_baseline and row.has_answer():
			if best == null or _is_more_exact(row, best):
				best = row
	return best


## The name of method and tuning, without the situation.
static func name_of(row: Measurement) -> String:
	return row.method if row.tuning == "" else "%s (%s)" % [row.method, row.tuning]


static func _is_more_exact(one: Measurement, other: Measurement) -> bool:
	if one.error == other.error:
		return one.run_time_us < other.run_time_us
	return one.error < other.error


static func _names(rows: Array[Measurement]) -> String:
	var texts: PackedStringArray = []
	for row in rows:
		var figures := [name_of(row), FigureText.short(row.run_time_us), FigureText.of(row)]
		texts.append("%s %s µs, %s" % figures)
	return "; ".join(texts)


static func _against(own: Measurement, baseline: Measurement, words: String) -> String:
	if baseline == null:
		return ""
	var times := FigureText.ratio(baseline.run_time_us, own.run_time_us)
	var errors := FigureText.ratio(baseline.error, own.error)
	var text := (
		" The %s, %s, takes %s times as long as %s"
		% [words, name_of(baseline), times, name_of(own)]
	)
	if errors == "-":
		return text + " and is %s off." % FigureText.of(baseline)
	return text + " and is %s times as far off." % errors


static func _without_answer(rows: Array[Measurement]) -> String:
	var tunings: Dictionary[String, PackedStringArray] = {}
	for row in rows:
		if not row.has_answer():
			var key := row.method + "\n" + row.note
			var known: PackedStringArray = tunings.get(key, PackedStringArray())
			known.append(row.tuning)
			tunings[key] = known
	var texts: PackedStringArray = []
	for key in tunings:
		var tuned := ", ".join(tunings[key])
		texts.append(key.replace("\n", " (%s): " % tuned if tuned else ": "))
	return " No answer: %s." % "; ".join(texts) if texts else ""
