extends "res://addons/gut_standin/test.gd"
## Where GUT has its base of all tests.
