extends "res://addons/gut_standin/gut_cmdln.gd"
## Where GUT has its command line.
