extends LabTest
## The pages of the web site: what is filled in, and that their colours are the lab's.

const TeachingPlan := preload("res://tools/web/teaching_plan.gd")
const WebDemo := preload("res://tools/web/web_demo.gd")
const WebPages := preload("res://tools/web/web_pages.gd")

const INDEX := "res://tools/web/index_page.html"
const NOTES := "res://tools/web/notes_page.html"
const RUBRIC := "res://tools/web/rubric_page.html"
const PAGE := "res://tools/web/demo_page.html"

const SIZES: Dictionary[String, int] = {"wasm": 37000000, "pck": 145000}

## What Godot writes into a page at an export.
const CONFIG := '{"args":[],"executable":"index","fileSizes":{"index.pck":1,"index.wasm":2}}'

var _demos := WebDemo.all()


func test_there_is_a_demo_for_the_lab_for_every_lesson_in_order_and_for_the_workshop() -> void:
	var ids := _demos.map(func(demo: WebDemo) -> String: return demo.id)
	var lessons := LessonAgenda.lessons().map(func(info: LessonInfo) -> String: return info.id)
	assert_eq(ids, [WebDemo.LAB] + lessons + [WebDemo.WORKSHOP])
	assert_eq(_demos[0].heading(), "Vec2 Lab")
	assert_eq(_demos[4].heading(), "4  The dot product")


func test_the_index_has_a_card_for_each_demo_that_is_there() -> void:
	var index := WebPages.index(_text(INDEX), [_demos[0], _demos[4], _demos[5]], 9390000, "")
	assert_eq(
		_hrefs(index),
		[
			"lab/index.html",
			"notes.html",
			"rubric.html",
			"dot_product/index.html",
			"line_distance/index.html",
		]
	)
	assert_string_contains(index, "4&ensp;The dot product")
	assert_string_contains(index, _demos[4].summary)
	assert_string_contains(index, "cards/line_distance.png")
	assert_string_contains(index, "10<!-- /engine -->&nbsp;MB")


func test_an_index_without_the_lab_does_not_offer_it() -> void:
	var index := WebPages.index(_text(INDEX), [_demos[4]], 1, "")
	assert_eq(_hrefs(index), ["dot_product/index.html"])


func test_the_notes_have_every_row_of_the_plan_and_its_versions() -> void:
	var plan := (
		TeachingPlan
		. new(
			(
				"| 1 | 0 | 8 | `dot_product?a=7,1&step=3` | **Exercise.** | a < b? – Yes – no. | vectors |\n"
				+ "| 2 | 2 | next time | `line_ends?step=4` | Caps. | What? – A point. | collisions |\n\n"
				+ "- 30 minutes: 1, 2\n"
			)
		)
	)
	var page := WebPages.notes(_text(NOTES), plan)
	assert_string_contains(page, 'href="lab/index.html#dot_product?a=7,1&amp;step=3"')
	assert_string_contains(page, "1 · minute 0, 2 min · part 8 · ")
	assert_string_contains(page, "minute 2, 48 min · next time · ")
	assert_string_contains(page, '<p class="show"><strong>Exercise.</strong></p>')
	assert_string_contains(page, '<p class="ask">a &lt; b?</p>')
	assert_string_contains(page, '<p class="answer">Yes – no.</p>')
	assert_string_contains(page, '<option value="1 2">30 minutes</option>')


func test_a_page_gets_its_title_its_links_and_the_shared_engine() -> void:
	var page := WebPages.demo_page(_exported(), _demos[4], _demos[5], SIZES, "")
	assert_string_contains(page, "<title>4 The dot product - Vec2 Lab</title>")
	assert_string_contains(page, 'name="description" content="%s"' % _demos[4].summary)
	assert_string_contains(page, "<h1>4&ensp;The dot product</h1>")
	assert_string_contains(page, 'src="../cards/dot_product.png"')
	assert_eq(_hrefs(page), ["../index.html", "../line_distance/index.html"])
	var config: Dictionary = JSON.parse_string(WebPages.between(page, "config"))
	var wanted := {
		"args": [],
		"executable": "../engine/godot",
		"mainPack": "dot_product.pck",
		"fileSizes": {"../engine/godot.wasm": 37e6, "dot_product.pck": 145e3},
	}
	assert_eq(config, wanted)


func test_the_last_page_has_no_next_and_the_labs_has_no_picture() -> void:
	var last := WebPages.demo_page(_exported(), _demos[12], null, SIZES, "")
	assert_eq(_hrefs(last), ["../index.html"])
	var lab := WebPages.demo_page(_exported(), _demos[0], _demos[1], SIZES, "")
	assert_eq(WebPages.between(lab, "picture"), "")
	assert_eq(_hrefs(lab), ["../index.html"], "its lessons follow each other inside")
	assert_string_contains(lab, "<title>Vec2 Lab</title>")


func test_the_manifest_names_what_is_there() -> void:
	var manifest: Dictionary = JSON.parse_string(_text("res://tools/web/manifest.webmanifest"))
	assert_eq(str(manifest["start_url"]), "lab/index.html")
	assert_has([Palette.PANEL], Color(str(manifest["theme_color"])))


func test_a_page_can_be_filled_in_anew() -> void:
	var page := WebPages.demo_page(_exported(), _demos[4], _demos[5], SIZES, "")
	assert_eq(WebPages.demo_page(page, _demos[4], _demos[5], SIZES, ""), page)
	var other := WebPages.demo_page(page, _demos[4], _demos[6], SIZES, "")
	assert_eq(_hrefs(other), ["../index.html", "../point_of_impact/index.html"])


func test_only_where_the_address_is_known_a_preview_has_a_picture() -> void:
	var picture := '<meta property="og:image" content="https://example.org/vec2_lab/cards/%s.png">'
	for address: String in ["https://example.org/vec2_lab", "https://example.org/vec2_lab/"]:
		var index := WebPages.index(_text(INDEX), _demos, 1, address)
		assert_string_contains(index, picture % "dot_product")
		for place: int in [0, 4, 5]:
			var demo := _demos[place]
			var page := WebPages.demo_page(_exported(), demo, null, SIZES, address)
			assert_string_contains(page, picture % (demo.id if place else "dot_product"))
			var again := WebPages.demo_page(page, demo, null, SIZES, "")
			assert_false(again.contains("og:image"))
	assert_false(WebPages.index(_text(INDEX), _demos, 1, "").contains("og:image"))


func test_words_cannot_break_a_page() -> void:
	var demo := WebDemo.new()
	demo.id = "dot_product"
	demo.title = 'a < b & "c"'
	var page := WebPages.demo_page(_exported(), demo, null, SIZES, "")
	assert_string_contains(page, "<h1>a &lt; b &amp; &quot;c&quot;</h1>")


func test_a_page_without_a_mark_is_refused() -> void:
	assert_eq(WebPages.between("<!-- next --> and nothing more", "next"), "")
	assert_push_error("<!-- /next -->")


func test_every_colour_of_the_pages_is_one_of_the_palette() -> void:
	var colors: Array[Color] = [
		Palette.PAPER, Palette.PANEL, Palette.FIELD, Palette.BORDER, Palette.FOCUS
	]
	for role: Palette.Role in Palette.Role.values():
		colors.append(Palette.color(role))
	for file: String in [INDEX, PAGE, NOTES, RUBRIC]:
		var found := RegEx.create_from_string("#([0-9a-f]{6})\\b").search_all(_text(file))
		assert_gt(found.size(), 5, file)
		for hit in found:
			assert_has(colors, Color(hit.get_string(1)), "%s: %s" % [file, hit.get_string()])


func _text(file: String) -> String:
	return FileAccess.get_file_as_string(file)


func _exported() -> String:
	return _text(PAGE).replace("$GODOT_CONFIG", CONFIG).replace("$GODOT_PROJECT_NAME", "Vec2 Lab")


# Where the links of a page lead, in order; pictures and icons are no links.
func _hrefs(page: String) -> Array:
	var found := RegEx.create_from_string('<a href="([^"]+)"').search_all(page)
	return found.map(func(hit: RegExMatch) -> String: return hit.get_string(1))
