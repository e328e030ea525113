class_name LabText
extends RefCounted
## Texts of the lab in the language of the person who reads them.


## [param sentence], source text in English, as the chosen language has it. For static functions and
## models: nodes have [method Object.tr].
static func translate(sentence: String) -> String:
	return TranslationServer.translate(sentence)
