"""The page around a demo: what it says when something is missing, its keys, its use by touch on a phone."""

import pytest

from conftest import WITHOUT_WEBGL, start_browser
from demo_page import DemoPage

PHONE = {"viewport": {"width": 390, "height": 844}, "device_scale_factor": 2, "has_touch": True, "is_mobile": True}


@pytest.fixture
def phone(browser, site):
    context = browser.new_context(**PHONE)
    page = DemoPage(context.new_page(), site)
    yield page
    page.close()
    context.close()


def test_without_webgl_it_says_so_and_loads_no_engine(playwright, site):
    browser = start_browser(playwright, WITHOUT_WEBGL)
    page = DemoPage(browser.new_page(), site)
    loaded = []
    page.page.on("request", lambda request: loaded.append(request.url))
    page.open("dot_product/index.html")
    assert "needs WebGL 2" in page.page.get_by_role("alert").inner_text()
    assert not [url for url in loaded if "engine" in url]
    page.close()
    browser.close()


@pytest.mark.parametrize("missing", ["engine/godot.js", "engine/godot.wasm", "dot_product/dot_product.pck"])
def test_a_missing_file_is_told(demo, missing):
    demo.page.route(f"**/{missing}", lambda route: route.fulfill(status=404))
    demo.open("dot_product/index.html")
    alert = demo.page.get_by_role("alert")
    alert.get_by_role("button", name="Load again").wait_for()
    assert missing.split("/")[-1] in alert.inner_text()
    demo.complaints.clear()


def test_without_script_it_says_what_is_needed(browser, site):
    context = browser.new_context(java_script_enabled=False)
    page = context.new_page()
    page.goto(f"{site}/dot_product/index.html")
    assert page.get_by_text("please allow JavaScript").is_visible()
    context.close()


def test_the_keys_of_the_page_and_of_the_lesson(demo):
    demo.start("dot_product")
    demo.click(692, 431)
    demo.drag((692, 431), (541, 431))
    demo.read(r"^dot product: 1\.8,")
    demo.page.keyboard.press("Control+z")
    demo.read(r"^dot product: 5,")
    demo.page.keyboard.press("F6")
    assert demo.page.evaluate("document.activeElement.href").endswith("/index.html")
    demo.page.keyboard.press("Tab")
    demo.page.keyboard.press("Enter")
    assert demo.page.get_by_text("leaves the lesson").is_visible()
    demo.page.keyboard.press("Escape")
    assert not demo.page.get_by_text("leaves the lesson").is_visible()
    demo.page.keyboard.press("F6")
    assert demo.page.evaluate("document.activeElement.id") == "canvas"


def test_on_a_phone_the_lesson_fills_the_page_and_is_used_by_touch(phone):
    phone.start("dot_product")
    phone.read(r"^dot product: 5,")
    box = phone.page.locator("canvas").bounding_box()
    assert (box["x"], box["width"], box["y"] + box["height"]) == (0, 390, 844)
    assert phone.page.evaluate("document.documentElement.scrollWidth") == 390
    # The situation "Obtuse".
    phone.page.touchscreen.tap(217, 712)
    phone.read(r"a = \(-5, 2\)")
