class_name WorkshopAnswer
extends RefCounted
## What came of one call.

## What kind of thing came back.
enum Kind { NUMBERS, NOTHING, COPY, WRONG_KIND }

## Whether [member numbers] mean something; else why not. COPY: a method that must change the vector
## itself left it alone, and [member numbers] are those of a new one that came back.
var kind := Kind.NUMBERS
## The answer as plain numbers; true is 1.
var numbers: PackedFloat64Array = []
## Whether something was changed that must stay as it was.
var spoiled := false
## What kind of thing came back, in words, for [constant Kind.WRONG_KIND].
var came_back := ""
