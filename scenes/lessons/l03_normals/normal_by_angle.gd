class_name NormalByAngle
## The unit normal by angles, the way of those who do not know (-y, x): less exact, and wrong for a
## zero vector.


## Takes the angle of [param v] by atan2, adds a quarter turn, and goes back by cos and sin. Has
## length 1 even for a zero v.
static func unit(v: Vec2) -> Vec2:
	var angle := atan2(v.y, v.x) + PI / 2.0
	return Vec2.new(cos(angle), sin(angle))
