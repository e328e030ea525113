class_name LabTest
extends GutTest
## The base of every test script of the project: GUT's own asserts, and those that know a Vec2.
