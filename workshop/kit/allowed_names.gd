class_name WorkshopAllowed
extends RefCounted
## Which names a student's code may use. The judge runs it on a teacher's computer, too: so anything
## that reaches beyond numbers and the student's own classes is not even compiled. What is refused
## is to be looked at by hand; it is no mistake.

## Names of the language.
const LANGUAGE := (
	"if elif else for while match when break continue pass return class "
	+ "class_name extends is in as "
	+ "self super signal set get func static const enum var void and or not null true false assert "
	+ "PI TAU INF NAN int float bool String StringName Array Dictionary Variant RefCounted "
	+ "PackedFloat64Array PackedFloat32Array PackedInt32Array PackedInt64Array PackedStringArray"
)
## Functions of the language that compute or print.
const FUNCTIONS := (
	"abs absf absi acos acosh asin asinh atan atan2 atanh ceil ceilf ceili clamp clampf clampi cos "
	+ "cosh deg_to_rad rad_to_deg exp floor floorf floori fmod fposmod posmod is_equal_approx "
	+ "is_finite is_inf is_nan is_zero_approx is_same lerp lerpf log max maxf maxi min minf mini "
	+ "move_toward pow round roundf roundi sign signf signi sin sinh snapped "
	+ "snappedf sqrt tan tanh "
	+ "wrap wrapf wrapi range len str typeof print prints printt printerr push_error push_warning "
	+ "angle_difference rotate_toward remap inverse_lerp step_decimals"
)
## Members of lists, texts and classes.
const MEMBERS := (
	"new _init _to_string _static_init append append_array push_back push_front pop_back pop_front "
	+ "back front size clear is_empty has erase insert remove_at resize fill find duplicate keys "
	+ "values get_or_add slice sort sort_custom map filter reduce any all min max reverse merge "
	+ "format num join length"
)
## What his tests may use besides.
const TESTS := (
	"GutTest assert_eq assert_ne assert_almost_eq assert_almost_ne assert_gt assert_gte assert_lt "
	+ "assert_lte assert_true assert_false assert_between assert_not_between assert_null "
	+ "assert_not_null assert_same assert_not_same assert_has assert_does_not_have assert_is "
	+ "assert_typeof pass_test fail_test pending before_all before_each after_all after_each "
	+ "use_parameters ParameterFactory named_parameters gut p assert_has_method assert_eq_deep "
	+ "assert_push_error assert_push_warning"
)
## Annotations.
const ANNOTATIONS := "warning_ignore export export_range static_unload"

## Names that nobody may make his own: what they mean elsewhere in the file would be hidden.
const NEVER := (
	"load preload str_to_var var_to_str bytes_to_var bytes_to_var_with_objects var_to_bytes "
	+ "instance_from_id convert type_convert get_stack print_stack "
	+ "print_tree breakpoint await yield "
	+ "get_script set_script call callv bind bindv rpc connect emit "
	+ "call_deferred set_deferred get_tree get_node"
)

# A script of the lab or of the disk as a base would bring its methods along.
const _BASE_OF_TESTS := '"res://addons/gut/test.gd"'

const _DECLARING: PackedStringArray = [
	"var", "func", "const", "class", "class_name", "enum", "signal", "for"
]

# Looked at for every name, so it is split once.
static var _never := NEVER.split(" ")

## The line of what is refused; 0 if nothing is.
var line := 0
## One sentence, translated; "" if nothing is refused.
var sentence := ""
## A name that nobody knows, which may be a misspelt one; "" where something else is refused.
var unknown := ""

var _known: Dictionary[String, bool] = {}


## Looks at the tokens of one file; [param declared] are the names that the student's files declare.
func _init(
	tokens: Array[WorkshopCode.Token], declared: Dictionary[String, bool], is_test: bool
) -> void:
	_known = declared.duplicate()
	for names: String in [LANGUAGE, FUNCTIONS, MEMBERS, TESTS if is_test else ""]:
		for each in names.split(" ", false):
			_known[each] = true
	var before := ""
	for token in tokens:
		if not sentence:
			_look_at(token, before)
			if before == "extends" and token.text[-1] in ["'", '"']:
				if not (is_test and token.text == _BASE_OF_TESTS):
					_refuse(token, token.text)
		# It only joins two lines.
		if token.text != "\\":
			before = token.text


## The names that a file declares, and those that the student's classes have anyway.
static func declared_in(tokens: Array[WorkshopCode.Token]) -> Dictionary[String, bool]:
	var declared: Dictionary[String, bool] = {}
	for of_class: String in WorkshopFiles.CLASSES.values():
		declared[of_class] = true
	var enum_depth := -1
	var head_depth := -1
	var depth := 0
	for index in tokens.size():
		var text := tokens[index].text
		var before := tokens[index - 1].text if index > 0 else ""
		if text == "(" or text == "{":
			depth += 1
			var earlier := tokens[index - 2].text if index > 1 else ""
			if text == "(" and ("func" in [before, earlier] or before == "set"):
				head_depth = depth
			if text == "{" and "enum" in [before, earlier]:
				enum_depth = depth
		elif text == ")" or text == "}":
			head_depth = -1 if depth == head_depth else head_depth
			enum_depth = -1 if depth == enum_depth else enum_depth
			depth -= 1
		elif tokens[index].is_name():
			var is_listed := depth == head_depth and before in ["(", ","]
			if is_listed or depth == enum_depth or before in _DECLARING:
				declared[text] = true
	return declared


func _look_at(token: WorkshopCode.Token, before: String) -> void:
	if token.text == "$":
		_refuse(token, "$")
	elif before == "@":
		if not token.text in ANNOTATIONS.split(" "):
			_refuse(token, "@" + token.text)
	elif before == "." and token.text in ["set", "get"]:
		_refuse(token, token.text)
	elif token.is_name() and not _is_allowed(token.text):
		if before != "." or not _is_harmless_member(token.text):
			_refuse(token, token.text)


func _is_allowed(word: String) -> bool:
	if not _known.has(word) or word in _never:
		return false
	if word == "RefCounted" or word == "GutTest" or word.begins_with("My"):
		return true
	return not (ClassDB.class_exists(word) or Engine.has_singleton(word))


# A member that the student's classes do not have: the engine says so when it compiles.
static func _is_harmless_member(word: String) -> bool:
	return not (word in _never or ClassDB.class_has_method("RefCounted", word))


func _refuse(token: WorkshopCode.Token, word: String) -> void:
	line = token.line
	if _is_of_engine(word):
		sentence = LabText.translate("%s is the engine's: here you write it yourself.") % word
	elif _is_of_lab(word):
		sentence = LabText.translate("%s is the lab's own: here you write it yourself.") % word
	elif word in _never or not word.is_valid_ascii_identifier():
		sentence = LabText.translate("%s is not used in the workshop.") % word
	else:
		sentence = LabText.translate("%s is not known in the workshop.") % word
		unknown = word


static func _is_of_engine(word: String) -> bool:
	return (
		ClassDB.class_exists(word)
		or Engine.has_singleton(word)
		or word in ["Vector2", "Vector2i", "Vector3", "Transform2D", "Rect2"]
	)


static func _is_of_lab(word: String) -> bool:
	for listed: Dictionary in ProjectSettings.get_global_class_list():
		if listed["class"] == word:
			return true
	return false
