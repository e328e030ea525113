"""The address and the title follow what is open; the browser's own Back and Reload work."""

import re

import pytest

LINK = "#dot_product?a=3,1"
TIP = (535, 399)


def titled(demo, title):
    demo.page.wait_for_function(f"document.title === {title!r}")


def addressed(demo, pattern):
    demo.page.wait_for_function(f"/{pattern}/.test(location.hash)")


def test_each_lesson_of_the_lab_has_an_address_a_title_and_an_entry(demo):
    demo.start("lab")
    titled(demo, "Vec2 Lab")
    demo.page.locator("canvas").focus()
    demo.page.keyboard.press("Enter")
    addressed(demo, "^#class_or_value$")
    demo.page.wait_for_function("/^1 .* - Vec2 Lab$/.test(document.title)")
    demo.page.keyboard.press("g")
    addressed(demo, "^#easy_bounce$")
    assert demo.page.locator("h1").inner_text().startswith("2\u2002")
    demo.page.go_back()
    demo.page.wait_for_function("/^1 /.test(document.title)")
    addressed(demo, "^#class_or_value$")
    demo.page.go_back()
    titled(demo, "Vec2 Lab")
    demo.read("Pick a lesson")
    demo.page.go_forward()
    demo.page.wait_for_function("/^1 /.test(document.title)")


def test_back_shows_the_lesson_before_with_its_board(demo):
    demo.start("lab", LINK)
    demo.read(r"a = \(3, 1\)")
    demo.drag(TIP, (615, 399))
    addressed(demo, "a=5,1")
    demo.page.keyboard.press("g")
    demo.page.wait_for_function("/^\\d+ /.test(document.title) && !/^4 /.test(document.title)")
    demo.page.go_back()
    titled(demo, "4 The dot product - Vec2 Lab")
    demo.read(r"a = \(5, 1\)")


@pytest.mark.parametrize("name", ["lab", "dot_product"])
def test_loading_again_keeps_lesson_board_and_step(demo, name):
    demo.start(name, LINK)
    demo.page.locator("canvas").focus()
    demo.page.keyboard.press("n")
    demo.drag(TIP, (615, 399))
    addressed(demo, "a=5,1&step=2")
    demo.page.reload()
    demo.page.wait_for_function("document.documentElement.dataset.firstFrame", timeout=90_000)
    demo.read(r"a = \(5, 1\)")
    demo.read("Step 2 of")


def test_a_demo_has_its_address_and_title_and_adds_no_entry(demo):
    demo.start("dot_product")
    entries = demo.page.evaluate("history.length")
    addressed(demo, "^#dot_product$")
    titled(demo, "4 The dot product - Vec2 Lab")
    demo.page.locator("canvas").focus()
    demo.page.keyboard.press("n")
    addressed(demo, "step=2")
    assert demo.page.evaluate("history.length") == entries


def test_the_address_changes_at_most_twice_a_second(demo):
    demo.start("dot_product")
    demo.page.evaluate(
        "window.changes = []; const replace = history.replaceState.bind(history);"
        "history.replaceState = (...all) => { changes.push(performance.now()); replace(...all); }; 0"
    )
    demo.page.locator("canvas").focus()
    for _ in range(20):
        demo.page.keyboard.press("n")
        demo.page.keyboard.press("Shift+N")
    demo.page.wait_for_timeout(1500)
    times = demo.page.evaluate("changes")
    assert times
    assert all(later - earlier > 450 for earlier, later in zip(times, times[1:])), times


def test_a_wrong_link_stays_in_the_address_until_something_is_done(demo):
    demo.start("lab", "#dot_prodct")
    demo.read("There is no lesson “dot_prodct”")
    assert re.fullmatch("#dot_prodct", demo.page.evaluate("location.hash"))
