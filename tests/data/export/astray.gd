extends RefCounted

var sound := "res://assets/sounds/%s.wav"
var scene := "res://tests/data/export/not_there.tscn"
