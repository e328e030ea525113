extends RefCounted
## The texts of the web site's pages: what belongs between the marks `<!-- name -->` and
## `<!-- /name -->` of a page is filled in. A page that is filled in already can be filled in anew.

const TeachingPlan := preload("teaching_plan.gd")
const WebDemo := preload("web_demo.gd")

const ENGINE := "../engine/godot"

const _ICON := (
	'<link rel="icon" type="image/svg+xml" href="../icon.svg">'
	+ '<link rel="manifest" href="../manifest.webmanifest">'
)
# What a search or a chat shows of the page.
const _DESCRIPTION := (
	'<meta name="description" content="{summary}"><meta property="og:type" content="website">'
	+ '<meta property="og:title" content="{page_title}">'
	+ '<meta property="og:description" content="{summary}">'
)
# Whoever shows a preview of a page takes whole addresses only.
const _PREVIEW := '<meta property="og:image" content="%s/cards/%s.png">'
# The whole lab has no picture of its own.
const _PICTURE_OF_LAB := "dot_product"
const _HOME := '<a href="../index.html">← All<span class="long">&nbsp;demos</span></a>'
const _NEXT := (
	'<a href="../{id}/index.html" rel="next">'
	+ 'Next<span class="long">: {title}</span>&nbsp;→</a>'
)
const _VERSION := '<option value="%s">%s</option>'
const _BOLD := "\\*\\*(.+?)\\*\\*"
const _PICTURE := '<img src="../cards/{id}.png" width="480" height="364" alt="">'


## The index made from its form [param page]: a card for each of [param demos], the lab's apart.
## [param engine_bytes] is what the first demo loads beside itself; [param address] is that of the
## site, "" where it is not known: then previews of the page have no picture.
static func index(
	page: String, demos: Array[WebDemo], engine_bytes: int, address: String
) -> String:
	var lab := ""
	var cards := ""
	for demo in demos:
		if demo.id == WebDemo.LAB:
			lab = _formatted(between(page, "lab"), demo)
		else:
			cards += _formatted(between(page, "card"), demo)
	var filled := fill(fill(page, "lab", lab), "card", cards)
	filled = fill(filled, "preview", _preview(address, _PICTURE_OF_LAB))
	return fill(filled, "engine", "%.0f" % ceilf(engine_bytes / 1e6))


## The speaker's notes made from their form [param page]: an article for each row of [param plan],
## and a choice of its versions.
static func notes(page: String, plan: TeachingPlan) -> String:
	var form := between(page, "row")
	var articles := ""
	for row in plan.rows:
		articles += form.format(_cells(row))
	var choices := _VERSION % ["", "Two hours"]
	for minutes in plan.versions:
		var numbers := " ".join(PackedStringArray(Array(plan.versions[minutes]).map(str)))
		choices += _VERSION % [numbers, "%d minutes" % minutes]
	return fill(fill(page, "row", articles), "versions", choices)


## The page of [param demo] as it was exported, or filled in before: with its title, its picture,
## the way to the index and to the demo [param next] (null after the last), and the shared engine.
## The lab has the ways between its lessons inside. [param sizes] tells the bytes of the engine's
## `wasm` and of the demo's `pck`; [param address] is as for [method index].
static func demo_page(
	page: String, demo: WebDemo, next: WebDemo, sizes: Dictionary[String, int], address: String
) -> String:
	var filled := fill(page, "title", _formatted("<title>{page_title}</title>", demo))
	var preview := _preview(address, _PICTURE_OF_LAB if demo.is_lab() else demo.id)
	filled = fill(filled, "description", _formatted(_DESCRIPTION, demo) + preview)
	filled = fill(filled, "icon", _ICON)
	filled = fill(filled, "heading", _formatted("<h1>{heading}</h1>", demo))
	filled = fill(filled, "home", _HOME)
	filled = fill(filled, "next", _formatted(_NEXT, next) if next and not demo.is_lab() else "")
	filled = fill(filled, "picture", "" if demo.is_lab() else _formatted(_PICTURE, demo))
	return fill(filled, "config", _shared(between(page, "config"), demo, sizes))


## The text between the marks [param name] of [param page].
static func between(page: String, name: String) -> String:
	var start := page.find("<!-- %s -->" % name)
	var end := page.find("<!-- /%s -->" % name)
	if start < 0 or end < start:
		push_error("the page has no marks <!-- %s --> and <!-- /%s -->" % [name, name])
		return ""
	return page.substr(start, end - start).trim_prefix("<!-- %s -->" % name)


## [param page] with [param text] between the marks [param name].
static func fill(page: String, name: String, text: String) -> String:
	return page.replace(_marked(name, between(page, name)), _marked(name, text))


static func _preview(address: String, picture: String) -> String:
	return _PREVIEW % [address.trim_suffix("/").xml_escape(true), picture] if address else ""


static func _marked(name: String, text: String) -> String:
	return "<!-- %s -->%s<!-- /%s -->" % [name, text, name]


static func _formatted(form: String, demo: WebDemo) -> String:
	return (
		form
		. format(
			{
				"id": demo.id,
				"title": demo.title.xml_escape(true),
				"heading": demo.heading().xml_escape(true).replace("  ", "&ensp;"),
				"page_title": demo.page_title().xml_escape(true),
				"summary": demo.summary.xml_escape(true),
			}
		)
	)


static func _cells(row: TeachingPlan.Row) -> Dictionary:
	return {
		"number": row.number,
		"minute": row.minute,
		"minutes": row.minutes,
		"part": ("part " if row.part.is_valid_int() else "") + row.part.xml_escape(),
		"link": row.link.xml_escape(true),
		"show": _html(row.show),
		"ask": _html(row.ask),
		"answer": _html(row.answer),
		"rubric": _html(row.rubric),
	}


# A cell of the plan: plain Markdown, of which bold is used.
static func _html(markdown: String) -> String:
	return RegEx.create_from_string(_BOLD).sub(markdown.xml_escape(), "<strong>$1</strong>", true)


static func _shared(config: String, demo: WebDemo, sizes: Dictionary[String, int]) -> String:
	var values: Dictionary = JSON.parse_string(config)
	var pack := "%s.pck" % demo.id
	values["executable"] = ENGINE
	values["mainPack"] = pack
	values["fileSizes"] = {ENGINE + ".wasm": sizes["wasm"], pack: sizes["pck"]}
	return JSON.stringify(values)
