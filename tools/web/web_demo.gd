extends RefCounted
## A demo on the web site: the whole lab, one lesson, the game, or the workshop. Texts are English,
## as the pages are.

const WebDemo := preload("web_demo.gd")

## The whole lab among the ids of lessons.
const LAB := "lab"
## The workshop among them.
const WORKSHOP := "workshop"
## Its picture; that of a lesson is in its folder.
const WORKSHOP_PICTURE := "res://scenes/workshop/room/card.png"

const _LAB_NAME := "Vec2 Lab"

## Its folder on the site, and the lesson's id.
var id: String

## A lesson's number; 0 for the whole lab, for the game and for the workshop.
var number: int

## Its name.
var title: String

## What one sees in it: one line.
var summary: String


## The whole lab, then all lessons and the game in the order of the start screen, then the workshop.
static func all() -> Array[WebDemo]:
	var lessons := LessonAgenda.lessons()
	var lab := WebDemo.new()
	lab.id = LAB
	lab.title = _LAB_NAME
	var count := LessonIndex.lessons().size()
	lab.summary = "All %d lessons in one program, with a card for each." % count
	var demos: Array[WebDemo] = [lab]
	for lesson in lessons:
		demos.append(_of_lesson(lesson))
	demos.append(_of_workshop())
	return demos


## Its title on a page of its own: a lesson's begins with its number.
func heading() -> String:
	return "%d  %s" % [number, title] if number else title


## The title of its page, as the browser's tab and history show it.
func page_title() -> String:
	var named := "%d %s" % [number, title] if number else title
	return title if is_lab() else "%s - %s" % [named, _LAB_NAME]


## Whether it is the whole lab.
func is_lab() -> bool:
	return id == LAB


static func _of_workshop() -> WebDemo:
	var demo := WebDemo.new()
	demo.id = WORKSHOP
	demo.title = "Your own code"
	demo.summary = "Write the lecture's methods in the browser, and see whether they are right."
	return demo


static func _of_lesson(lesson: LessonInfo) -> WebDemo:
	var demo := WebDemo.new()
	demo.id = lesson.id
	demo.number = LessonIndex.number_of(lesson)
	demo.title = lesson.title
	demo.summary = lesson.summary
	return demo
