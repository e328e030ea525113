class_name LessonInfo
extends Resource
## What the lab knows of a lesson before it is opened: enough for its card, nothing of its scene.
##
## It is `lesson.tres` in the lesson's folder; the scene beside it is named after the [member id].

## Stable name in links, on the command line and in file names: snake_case, no number.
@export var id: StringName

## Title on card and frame: source text, English, translated where it is shown.
@export var title: String

## What one sees in the lesson: one line, source text, English.
@export var summary: String

## Services that the lesson frame brings, in the order in which the panel shows them: scenes in
## `scenes/widgets/services/`. What is not named here is not loaded.
@export var needs: PackedStringArray


## The lesson's scene: `<folder>/<id>.tscn`.
func scene_path() -> String:
	return resource_path.get_base_dir().path_join("%s.tscn" % id)


## The picture on the lesson's card: `<folder>/card.png`.
func card_path() -> String:
	return resource_path.get_base_dir().path_join("card.png")
