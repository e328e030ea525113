class_name MyVec2
extends \
	'../scripts/vec2.gd'
