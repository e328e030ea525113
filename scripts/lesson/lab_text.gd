class_name LabText
extends RefCounted
## Texts of the lab in the language of the person who reads them.

## The language of the texts in the code.
const ENGLISH := "en"

const _KEY := "language"
const _NAMES: Dictionary[String, String] = {"en": "English", "nl": "Nederlands"}

# The language that a link has asked for; "" where none has.
static var _for_now := ""


## [param sentence], source text in English, as the chosen language has it. For static functions and
## models: nodes have [method Object.tr].
static func translate(sentence: String) -> String:
	return TranslationServer.translate(sentence)


## Speaks the language that a link has asked for, else the one that was chosen in the lab, else that
## of the system; English where the lab does not know it: a line without letters, such as a formula,
## runs in the direction of the chosen language.
static func choose_language() -> void:
	var wanted: String = _for_now if _for_now else KeptChoices.value(_KEY, "")
	if wanted in languages():
		TranslationServer.set_locale(wanted)
	elif not TranslationServer.has_translation_for_locale(TranslationServer.get_locale(), false):
		TranslationServer.set_locale(ENGLISH)


## The codes of the languages that the lab speaks: `en`, `nl`.
static func languages() -> PackedStringArray:
	var found: PackedStringArray = [ENGLISH]
	for locale in TranslationServer.get_loaded_locales():
		if not locale in found:
			found.append(locale)
	return found


## The code of the language that is spoken now.
static func language() -> String:
	var spoken := TranslationServer.get_locale().get_slice("_", 0)
	return spoken if spoken in languages() else ENGLISH


## The code of the language behind the one that is spoken now, after the last one the first.
static func next_language() -> String:
	var codes := languages()
	return codes[(codes.find(language()) + 1) % codes.size()]


## Speaks the language with this code, one of [method languages], from now on and the next time.
## What is shown already has to be shown anew.
static func speak(code: String) -> void:
	_for_now = ""
	KeptChoices.keep(_KEY, code)
	TranslationServer.set_locale(code)


## The same as long as the lab runs, or until a language is chosen.
static func speak_for_now(code: String) -> void:
	_for_now = code
	TranslationServer.set_locale(code)


## The language of [method speak_for_now]; "" where there is none.
static func language_for_now() -> String:
	return _for_now


## The name of a language in that language.
static func name_of(code: String) -> String:
	return _NAMES.get(code, TranslationServer.get_locale_name(code))
