class_name LabText
extends RefCounted
## Texts of the lab in the language of the person who reads them.


## [param sentence], source text in English, as the chosen language has it. For static functions and
## models: nodes have [method Object.tr].
static func translate(sentence: String) -> String:
	return TranslationServer.translate(sentence)


## Goes back to English where the lab does not know the system's language: a line without letters,
## such as a formula, runs in the direction of the chosen language.
static func choose_language() -> void:
	if not TranslationServer.has_translation_for_locale(TranslationServer.get_locale(), false):
		TranslationServer.set_locale("en")
