extends LabTest
## Tries every line of the stability table as `./lab stability` does, long ones in their quick form.


func test_case(case: StabilityCase = use_parameters(StabilityCases.all())) -> void:
	var result := case.run(case.is_long)
	var name_of_case := case.title + (": " + case.quick_form if case.is_long else "")
	assert_true(result.passed, "%s: %s; got %s" % [name_of_case, case.criterion, result.figure])
