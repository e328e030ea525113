class_name NormalByAngle
## The unit normal by angles, as one does it who does not know (-y, x): slower and less exact.


## The direction of [param v] by atan2, a quarter turn on, and back by cos and sin. Never zero, not
## even for a zero v.
static func unit(v: Vec2) -> Vec2:
	var angle := atan2(v.y, v.x) + PI / 2.0
	return Vec2.new(cos(angle), sin(angle))
