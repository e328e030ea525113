extends LabTest
## Tries every line of the stability table as `./lab stability --quick` does, long ones in their
## quick form.


func test_case(case: StabilityCase = use_parameters(_cases())) -> void:
	var result := case.run(case.is_long)
	var name_of_case := case.title_in_brief()
	assert_true(result.passed, "%s: %s; got %s" % [name_of_case, case.criterion, result.figure])


func _cases() -> Array[StabilityCase]:
	return StabilityCases.all().filter(
		func(case: StabilityCase) -> bool: return case.has_quick_form()
	)
