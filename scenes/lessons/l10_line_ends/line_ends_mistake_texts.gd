class_name LineEndsMistakeTexts
## What the bug gallery of this lesson says about each mistake, and which preset shows it best.

const _TELLING_PRESETS: Dictionary[int, String] = {
	18: "Head-on",
	19: "Miss",
	20: "Head-on",
	22: "End",
	23: "Miss",
}


## All mistakes of this lesson, translated.
static func infos() -> Array[MistakeInfo]:
	return [
		MistakeInfo.new(
			18,
			LabText.translate("D squared instead of rooted"),
			LabText.translate(
				"(−b − D²) / 2a: 5 px from the touch at speed 10, t = −64799, not 0.5."
			),
			"test_cap_impact.test_the_discriminant_is_rooted_not_squared",
			LabText.translate("The test wants t = 0.5 for a ball 5 px from the touch at speed 10.")
		),
		MistakeInfo.new(
			19,
			LabText.translate("negative D not tested"),
			LabText.translate(
				"The root of D < 0 is NaN, and so are time, place and normal: no ball left."
			),
			"test_cap_impact.test_a_near_miss_has_no_time_and_no_normal",
			LabText.translate("The test shoots past an end and wants no touch, not NaN.")
		),
		MistakeInfo.new(
			20,
			LabText.translate("time from the new position"),
			LabText.translate(
				"t counted from the new position but added to the old: −0.5, not 0.5."
			),
			"test_cap_impact.test_the_time_counts_from_the_old_position",
			LabText.translate("The test wants the ball to be r away from the end at t.")
		),
		(
			MistakeInfo
			. new(
				22,
				LabText.translate("end tested too late"),
				LabText.translate(
					"Between the ends AFTER the frame is not between them at the impact."
				),
				"test_segment_impact.test_the_end_is_tested_at_the_impact_not_after_the_frame",
				(
					LabText
					. translate(
						"The test shoots past an end at an angle: beside the line at first, not when it touches."
					)
				)
			)
		),
		MistakeInfo.new(
			23,
			LabText.translate("line without ends"),
			LabText.translate(
				"Infinite, no caps or one-sided: compare the other fields. A wrong one has a ✗."
			),
			"test_segment_impact.test_an_infinite_line_is_not_a_segment",
			LabText.translate("The test shoots past both ends and from both sides.")
		),
	]


## The preset whose shot goes visibly wrong with the mistake [param number].
static func telling_preset(number: int) -> String:
	return _TELLING_PRESETS[number]
