class_name WorkshopAny
extends RefCounted
## Gives what comes from a student's class, whose type nobody knows, the type that it has.


## An object.
static func object(value: Variant) -> Object:
	return value


## A script.
static func script(value: Variant) -> GDScript:
	return value


## A whole or a broken number.
static func number(value: Variant) -> float:
	return value


## A list.
static func list(value: Variant) -> Array:
	return value


## What JSON holds between braces.
static func dictionary(value: Variant) -> Dictionary:
	return value


## Whether it is a whole or a broken number.
static func is_number(value: Variant) -> bool:
	return value is float or value is int
