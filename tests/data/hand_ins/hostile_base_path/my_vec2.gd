class_name MyVec2
extends "res://scripts/vec2.gd"


