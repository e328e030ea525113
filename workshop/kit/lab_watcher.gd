class_name WorkshopLabWatcher
extends RefCounted
## The one watcher of the lab: all lessons and screens share it, and it outlives each of them. It
## begins when it is wanted first.

static var _watcher: WorkshopWatcher


## The watcher in [param tree]. Where no child can be started it is a [WorkshopPageWatcher].
static func of(tree: SceneTree) -> WorkshopWatcher:
	if not is_instance_valid(_watcher):
		var has_children := WorkshopChild.can_run()
		_watcher = WorkshopWatcher.new() if has_children else WorkshopPageWatcher.new()
		tree.root.add_child.call_deferred(_watcher)
	return _watcher
