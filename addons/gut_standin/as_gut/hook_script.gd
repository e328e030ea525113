extends "res://addons/gut_standin/hook_script.gd"
## Where GUT has its base of the scripts that run before and after all tests.
