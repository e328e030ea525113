class_name ComparisonText
extends RefCounted
## The part of report.md that compares run times with those of older reports.

const _EXPLANATION := (
	"Run time now over run time then: below 1 is faster. The spread in brackets goes from the lower to"
	+ " the upper quartile of the runs of one report, or over all reports where several are given. A"
	+ " ratio in bold differs from 1 by more than its spread. Baselines are the engine's own"
	+ " methods and other libraries. They have not changed, so their median is what the machine did."
)


## The whole part. [param old_count] and [param new_count] are the numbers of reports on both sides.
static func of(ratios: Array[RunTimeRatio], old_count: int, new_count: int) -> String:
	var parts: PackedStringArray = [
		"## Against older reports",
		"%d older, %d new. %s" % [old_count, new_count, _EXPLANATION],
	]
	if ratios.is_empty():
		parts.append("No row is in all of these reports.")
		return "\n\n".join(parts) + "\n"
	var lines: PackedStringArray = ["| problem | method, setting | now / then |", "|---|---|---|"]
	for one in ratios:
		lines.append("| %s | %s | %s |" % [one.problem, one.title.replace("|", "\\|"), _cell(one)])
	parts.append("\n".join(lines))
	parts.append(summary(ratios))
	return "\n\n".join(parts) + "\n"


## One sentence: the medians of the lab's own methods and of their baselines.
static func summary(ratios: Array[RunTimeRatio]) -> String:
	var medians: Array[String] = []
	for baselines: bool in [false, true]:
		var median := RunTimeRatio.median_of(ratios, baselines)
		medians.append(_number(median) if is_finite(median) else "none")
	return "Median of now / then: the lab's own methods %s, baselines %s." % medians


static func _cell(one: RunTimeRatio) -> String:
	var text := _number(one.ratio)
	if one.is_clear():
		text = "**%s**" % text
	if not is_finite(one.least) or not is_finite(one.largest):
		return text + " (spread unknown)"
	return "%s (%s to %s)" % [text, _number(one.least), _number(one.largest)]


static func _number(value: float) -> String:
	return "%.3f" % value
