class_name WrongShot
extends RefCounted
## The shot to which a mistake leads, or none.

## Whether the mistake finds an aim at all; without one the rest means nothing.
var hit := false
## Its direction, of length 1.
var direction := Vec2.zero()
## By how much it misses.
var miss: ShotMiss
