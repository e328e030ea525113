extends LabTest
## Texts of students with guards in them: each construct keeps its meaning, is stopped where it
## would not come to an end, and is told by the line of the student's own text.

const _FRAME := "extends RefCounted\nvar x := 3.0\nvar other = null\n\n\n%s\n"
# Nothing in these is guarded.
const _PLAIN: PackedStringArray = [
	"func f():\n\t# while x: a / b % c.d\n\treturn 1",
	'func f():\n\tvar s = "while x: a / 0 % b.c()"\n\treturn s',
	"func f():\n\tvar s = 'for i in 3: print(1 / 0)'\n\treturn s",
	'func f():\n\tvar s = """while true:\n\tprint(a / b)\n"""\n\treturn s',
	"func f():\n\treturn x / 2.0 + 7 / 2 % 5",
	"func f():\n\treturn x / sqrt(x)",
	'func f():\n\treturn "%s %s" % [x, x]',
]
# What is run, and what comes back.
const _MEANING: Dictionary[String, Variant] = {
	"func f():\n\tvar n := 0\n\twhile n < 5: n += 1\n\treturn n": 5,
	"func f():\n\tvar n := 0\n\twhile n < 5 and \\\n\t\t\tn < 3:\n\t\tn += 1\n\treturn n": 3,
	"func f():\n\tvar n := 0\n\twhile (n < 5\n\t\t\tand n < 4):\n\t\tn += 1; n += 1\n\treturn n": 4,
	"func f():\n\tvar n := 0\n\tfor i in 4: n += i\n\treturn n": 6,
	"func f():\n\tvar n := 0\n\tfor i in range(1, 4): n += i; n += 1\n\treturn n": 9,
	"func f():\n\tvar n := 0\n\tfor i: int in [1, 2]:\n\t\tfor k in 3:\n\t\t\tn += i * k\n\treturn n":
	9,
	"func f():\n\tfor i in 9:\n\t\tif i == 4: return i\n\treturn -1": 4,
	"func f():\n\tvar n := 0\n\tfor i in 9:\n\t\tif i % 2: continue\n\t\tn += i\n\treturn n": 20,
	"func f(): return 7": 7,
	"func f() -> int: return 7 / g()\nfunc g() -> int: return 2": 3,
	"func f():\n\tvar half := func(a): return a / 2\n\treturn [8].map(half)[0]": 4,
	"func f():\n\treturn [3, 1, 2].map(func(a):\n\t\tvar b = a * 2\n\t\treturn b\n\t)[0]": 6,
	"func f():\n\tmatch int(x):\n\t\t1: return 1\n\t\t3 when x > 2.0:\n\t\t\treturn 33\n\treturn 0":
	33,
	"func f():\n\tvar n := 10\n\tn /= 1 + 2\n\tn %= 2\n\treturn n": 1,
	"func f():\n\treturn 2 ** 3 / 2 ** 2 / -1": -2,
	"func f():\n\treturn 1.0 / 0.0": INF,
	"func f():\n\treturn 1.0 / -0.0": -INF,
	"func f():\n\tvar zero := -0.0\n\treturn 1.0 / zero": -INF,
	"func f():\n\treturn posmod(-1, 3)": 2,
	"func f():\n\tvar list := []\n\tlist.resize(3)\n\tlist.append_array([1, 2])\n\treturn list.size()":
	5,
	"func f():\n\treturn range(2, 8, 2).size()": 3,
	"func f():\n\tself.x = 5.0\n\tself.x += 1.0\n\treturn self.x": 6.0,
	'func f():\n\tvar d := {"a": 1, "b": x}\n\treturn d.a + d["b"]': 4.0,
	"func f():\n\tvar a := 1 if x > 2.0 else 2; var b := a; return a + b": 2,
	"func f():\n\tassert(x > 1.0)\n\tassert(x > 1.0, 'more')\n\tprint(x)\n\treturn 1": 1,
	"func f(\n\ta := 4,\n\tb := [1, 2]\n):\n\treturn a + b[0]": 5,
	"static func f() -> float:\n\treturn absf(-2.0) / maxi(0, 4)": 0.5,
}
# What would not come to an end, or take all memory, and the line that says so.
const _STOPPED: Dictionary[String, int] = {
	"func f():\n\twhile true: pass": 7,
	"func f():\n\twhile true:\n\t\twhile true:\n\t\t\tpass": 8,
	"func f():\n\tfor i in 1000000000: x += 1.0": 7,
	"func f():\n\tvar list = [1]\n\tfor i in list:\n\t\tlist.append(i)": 8,
	"func f():\n\tfor i in range(1, 900000000):\n\t\tpass": 7,
	"func f():\n\treturn f()": 6,
	"func f():\n\treturn [1].map(func(a): return f())": 6,
	"func f() -> int:\n\treturn f() + f()": 6,
	"func f():\n\treturn range(1000000000)": 7,
	"func f():\n\tvar list := []\n\tlist.resize(1000000000)": 8,
	"func f():\n\tvar text := 'a'\n\tfor i in 90:\n\t\ttext += text": 9,
	"func f():\n\tvar list := [1]\n\twhile true: list.append_array(list)": 8,
}
# Whole numbers that would be divided by 0, and the line that says so.
const _DIVIDED: Dictionary[String, int] = {
	"func f():\n\tvar n := 0\n\treturn 7 / n": 8,
	"func f():\n\tvar n := 0\n\treturn 7 % n": 8,
	"func f():\n\tvar n := 7\n\tn /= 0 * n": 8,
	"func f():\n\tvar n := 7\n\treturn 1 + n / (n - 7) / 2": 8,
	"func f():\n\tvar n := 7\n\treturn n / [0][0]": 8,
	"func f():\n\treturn 7 / int(x - 3.0)": 7,
	"func f():\n\treturn 7 / min(0, 1)": 7,
	"func f():\n\treturn 7 / g()\nfunc g() -> int:\n\treturn 0": 7,
	"func f():\n\treturn 7 / g()\nfunc g():\n\treturn 0": 7,
	"func f():\n\treturn [0].map(func(a): return 1 / a)": 7,
	"func f():\n\treturn posmod(7, int(x) - 3)": 7,
}
# What is written for what a student uses of a value.
const _ASKED: Dictionary[String, String] = {
	"func f(a):\n\treturn a.x": '(a if WorkshopGuard.has(a, &"x", false, 2) else a).x',
	"func f(a):\n\ta.x = 2.0": '\tWorkshopGuard.has(a, &"x", false, 2); a.x = 2.0',
	"func f(a):\n\ta.b.c += 1": 'WorkshopGuard.has(a.b, &"c", false, 2); ',
	"func f(a):\n\treturn a[1].dot(2)": '(a[1] if WorkshopGuard.has(a[1], &"dot", true, 2)',
	"func f() -> A:\n\treturn f().x": '(WorkshopGuard.given(f(), &"x", false, 2) as A).x',
	"func f():\n\treturn f().g(\n\t\t1\n\t)": '(WorkshopGuard.given(f(), &"g", true, 2)).g(',
}

var _errors := WorkshopHeardErrors.new()


func test_strings_comments_and_what_is_harmless_stay_as_they_are() -> void:
	for body: String in _PLAIN:
		var guarded := WorkshopGuardedCode.new(body, {})
		# But for the two lines at the head of the function.
		var lines := guarded.text.split("\n")
		lines.remove_at(_line_with(lines, "WorkshopGuard.enter"))
		lines.remove_at(_line_with(lines, "WorkshopGuard.over"))
		assert_eq("\n".join(lines), body)


func test_code_means_the_same_with_guards() -> void:
	for body: String in _MEANING:
		var result: Variant = _run(body)
		assert_true(is_same(result, _MEANING[body]), "%s\ngives %s" % [body, result])
		assert_false(WorkshopGuard.over, body)
		assert_eq(_errors.heard.size(), 0, body)


func test_what_would_not_come_to_an_end_is_stopped_and_tells_its_line() -> void:
	for body: String in _STOPPED:
		_run(body)
		assert_true(WorkshopGuard.over, body)
		assert_eq(WorkshopGuard.line, _STOPPED[body], body)


func test_no_whole_number_is_divided_by_0_and_the_line_is_told() -> void:
	for body: String in _DIVIDED:
		_run(body)
		assert_eq(_errors.heard.size(), 1, body)
		assert_eq(_errors.heard[0].line, _DIVIDED[body], body)
		assert_string_contains(_errors.heard[0].message, "Division by zero")


# Where it is built for tests the engine tells the same, which would fail here.
func test_a_value_is_asked_for_before_something_of_it_is_used() -> void:
	for body: String in _ASKED:
		var text := WorkshopGuardedCode.new(body, WorkshopGuardedCode.types_in(body)).text
		assert_string_contains(text, _ASKED[body])


func test_what_is_null_or_has_no_such_member_is_told() -> void:
	var vector := Vec2.new(1.0, 2.0)
	_errors.begin()
	WorkshopGuard.begin(_errors)
	for member: StringName in [&"x", &"y"]:
		assert_true(WorkshopGuard.has(vector, member, false, 5))
	assert_true(WorkshopGuard.has(vector, &"length", true, 5))
	assert_true(WorkshopGuard.has([1], &"size", true, 5))
	assert_eq(_errors.heard.size(), 0)
	assert_false(WorkshopGuard.has(null, &"x", false, 6))
	assert_false(WorkshopGuard.has(vector, &"z", false, 7))
	assert_false(WorkshopGuard.has(vector, &"len", true, 8))
	assert_false(WorkshopGuard.has(2.0, &"x", false, 9))
	var told := _errors.heard.map(
		func(heard: WorkshopHeardErrors.Heard) -> String:
			return WorkshopSentences.of_stop(heard.message, ["x", "length"])
	)
	assert_string_contains(str(told[0]), "is null here")
	assert_string_contains(str(told[1]), "z is not there")
	assert_string_contains(str(told[2]), "do you mean length")
	assert_string_contains(str(told[3]), "x is not there")


func test_every_line_of_the_guarded_text_leads_to_the_students_own() -> void:
	var body := "func f():\n\tfor i in 3: x += i\n\tvar y := 1\n\treturn y"
	var guarded := WorkshopGuardedCode.new(_FRAME % body, {})
	var lines := guarded.text.split("\n")
	for told: String in ["for i", "x += i", "var y", "return y"]:
		var plain_line := _line_with((_FRAME % body).split("\n"), told) + 1
		assert_eq(guarded.line_of(_line_with(lines, told) + 1), plain_line, told)


func test_a_loop_within_another_line_is_refused() -> void:
	var guarded := WorkshopGuardedCode.new("func f(a):\n\tif a: for i in a: print(i)", {})
	assert_string_contains(guarded.problem, "lines of its own")
	assert_eq(guarded.problem_line, 2)


func test_what_no_guard_makes_safe_is_refused_with_its_line() -> void:
	var refused: Dictionary[String, int] = {
		"class_name A\nstatic var a := f()": 2,
		"class_name A\nstatic func _static_init():\n\tpass": 2,
		"class_name A\nvar a:\n\tset(value):\n\t\ta = value": 3,
		"class_name A\nvar a := A.new()": 2,
		"class_name A\nfunc f(a = f()):\n\tpass": 2,
	}
	for text: String in refused:
		var limits := WorkshopGuardLimits.new(text)
		assert_ne(limits.sentence, "", text)
		assert_eq(limits.line, refused[text], text)
	for text: String in [
		"class_name A\nvar a := B.new()\nfunc f(b = sqrt(2.0)) -> A:\n\treturn A.new()",
		"class_name A\nfunc f():\n\tvar set_of := {}\n\treturn set_of",
	]:
		assert_eq(WorkshopGuardLimits.new(text).sentence, "", text)


func test_guards_hold_for_every_starter() -> void:
	for file: String in WorkshopFiles.CLASSES:
		assert_eq(WorkshopGuardLimits.new(WorkshopFiles.starter(file)).sentence, "", file)
		assert_eq(WorkshopGuardedCode.new(WorkshopFiles.starter(file), {}).problem, "", file)


func test_prints_are_kept_up_to_a_bound() -> void:
	WorkshopGuard.forget_prints()
	_run("func f():\n\tfor i in 1000: print('a', i)")
	assert_eq(WorkshopGuard.print_count, 1000)
	assert_eq(WorkshopGuard.printed.size(), WorkshopGuard.MOST_PRINTED)
	assert_eq(WorkshopGuard.printed[1], "a1")


static func _line_with(lines: PackedStringArray, words: String) -> int:
	for at in lines.size():
		if lines[at].contains(words):
			return at
	return -1


func _compiled(body: String) -> GDScript:
	var text := _FRAME % body
	var guarded := WorkshopGuardedCode.new(text, WorkshopGuardedCode.types_in(text))
	assert_eq(guarded.problem, "", body)
	var script := GDScript.new()
	script.source_code = guarded.text
	# Nothing a student writes gives a warning there.
	script.take_over_path("res://workshop/guarded_in_test.gd")
	return script if script.reload() == OK else null


func _run(body: String) -> Variant:
	var script := _compiled(body)
	assert_not_null(script, body)
	_errors.begin()
	WorkshopGuard.begin(_errors)
	return WorkshopAny.object(script.callv(&"new", [])).call(&"f") if script else null
