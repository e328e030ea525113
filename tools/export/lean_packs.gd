@tool
extends EditorPlugin
## Brings [code]lean_export.gd[/code] into every export, in the editor and on a command line.

var _export := preload("lean_export.gd").new()


func _enter_tree() -> void:
	add_export_plugin(_export)


func _exit_tree() -> void:
	remove_export_plugin(_export)
