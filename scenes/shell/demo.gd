extends Control
## The start of a lesson's demo: the frame with the only lesson that the demo holds, and no start
## screen to go back to.


# The frame has to know its lesson before it enters the tree, which it does after this node.
func _enter_tree() -> void:
	($LessonFrame as LessonFrame).lesson_info = LessonIndex.lessons()[0]
