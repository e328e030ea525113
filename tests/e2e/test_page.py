"""The page around a demo: what it says when something is missing, its keys, its use by touch on a phone."""

import threading

import pytest

from conftest import SITE, WITHOUT_WEBGL, start_browser
from demo_page import START_MS, DemoPage
from server import open_server

PHONE = {"viewport": {"width": 390, "height": 844}, "device_scale_factor": 2, "has_touch": True, "is_mobile": True}

# Where the tip of a is at the start.
TIP_ON_PHONE = (297, 330)


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


def test_from_a_folder_it_says_at_once_what_is_needed(browser):
    page = browser.new_page()
    page.goto(f"file://{SITE}/dot_product/index.html")
    assert "must come from a web server" in page.get_by_role("alert").inner_text()
    page.close()


# Files come with pauses: a quick machine would have all of the engine before it shows a frame.
SLOWLY = """
const quickFetch = window.fetch;
window.fetch = async (...request) => {
    const answer = await quickFetch(...request);
    let pieces = 0;
    const pause = new TransformStream({ async transform(piece, out) {
        if (pieces++ % 16 === 0)
            await new Promise(goOn => setTimeout(goOn, 40));
        out.enqueue(piece);
    } });
    return new Response(answer.body.pipeThrough(pause), { status: answer.status, headers: answer.headers });
};
"""


def test_progress_counts_to_what_is_really_loaded(demo):
    demo.page.add_init_script(SLOWLY)
    demo.page.add_init_script(
        "window.amounts = []; addEventListener('load', () => new MutationObserver("
        "() => amounts.push(document.getElementById('amount').textContent)"
        ").observe(document.getElementById('amount'), { childList: true }))"
    )
    demo.start("dot_product")
    amounts = [text for text in demo.page.evaluate("amounts") if " of " in text]
    small = (SITE / "engine" / "godot.wasm.gz").stat().st_size / 1e6
    assert amounts
    assert all(float(text.split(" of ")[1].split()[0]) < small + 1 for text in amounts), amounts


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
    demo.read(r"a = \(3, 1\)")
    demo.page.keyboard.press("Control+z")
    demo.read(r"a = \(7, 1\)")
    demo.page.keyboard.press("F6")
    assert demo.page.evaluate("document.activeElement.href").endswith("/index.html")
    demo.page.keyboard.press("Tab")
    demo.page.keyboard.press("Enter")
    assert demo.page.get_by_text("leaves the lesson").is_visible()
    demo.page.keyboard.press("Escape")
    assert not demo.page.get_by_text("leaves the lesson").is_visible()
    demo.page.keyboard.press("F6")
    assert demo.page.evaluate("document.activeElement.id") == "canvas"


def test_f6_leads_out_of_a_number_field_too(demo):
    demo.start("dot_product")
    demo.click(927, 227)
    # The engine puts an element of its own over the field.
    demo.page.wait_for_function("document.activeElement.isContentEditable")
    demo.page.keyboard.press("F6")
    # Nor does the engine take the focus back a few frames later.
    for _ in range(5):
        assert demo.page.evaluate("document.activeElement.href ?? ''").endswith("/index.html")
        demo.page.wait_for_timeout(100)
    demo.page.keyboard.press("F6")
    demo.page.wait_for_function("document.querySelector('main').contains(document.activeElement)")


def test_a_link_is_copied_and_the_page_says_so(browser, site):
    context = browser.new_context(permissions=["clipboard-read", "clipboard-write"])
    page = DemoPage(context.new_page(), site)
    page.start("dot_product", "#dot_product?a=3,1")
    page.read(r"a = \(3, 1\)")
    page.click(400, 600)
    page.page.keyboard.press("l")
    page.page.get_by_text("Link copied").wait_for()
    assert "#dot_product?a=" in page.page.evaluate("navigator.clipboard.readText()")
    page.close()
    context.close()


def test_where_copying_is_refused_the_link_can_be_marked_and_nothing_false_is_said(demo):
    demo.start("dot_product", "#dot_product?a=3,1")
    demo.page.evaluate("navigator.clipboard.writeText = () => Promise.reject(); document.execCommand = () => false")
    demo.page.locator("canvas").focus()
    demo.page.keyboard.press("l")
    link = demo.page.get_by_label("copy it yourself")
    link.wait_for()
    assert link.input_value().endswith("#dot_product?a=3,1")
    assert demo.page.evaluate("getSelection().toString() || document.activeElement.selectionEnd") != 0
    assert demo.page.locator("#news").inner_text() == ""
    assert "copied" not in demo.text()
    demo.page.keyboard.press("Escape")
    assert link.is_hidden()
    assert demo.page.evaluate("document.activeElement.id") == "canvas"


def test_in_the_frame_of_another_site_without_the_right_to_copy_nothing_false_is_said(demo, tmp_path):
    (tmp_path / "host.html").write_text(f"<iframe src='{demo.site}/dot_product/index.html' width=1200 height=650></iframe>")
    host = open_server(tmp_path, 0)
    threading.Thread(target=host.serve_forever, daemon=True).start()
    demo.page.goto(f"http://127.0.0.1:{host.server_port}/host.html")
    lesson = demo.page.frames[-1]
    lesson.wait_for_function("document.documentElement.dataset.firstFrame", timeout=START_MS)
    assert not lesson.evaluate("document.featurePolicy.allowsFeature('clipboard-write')")
    lesson.locator("canvas").focus()
    demo.page.keyboard.press("l")
    # Copied in the older way, or shown so that it can be copied: either is true.
    lesson.wait_for_selector("#news:not(:empty), #uncopied:not([hidden])")
    assert lesson.evaluate("(part('news').textContent === '') === !part('uncopied').hidden")
    host.shutdown()
    demo.complaints.clear()


class Fingers:
    """Touches as a phone sends them, any number at once."""

    def __init__(self, page):
        self.session = page.context.new_cdp_session(page)

    def send(self, kind, *places):
        points = [{"x": x, "y": y, "id": number} for number, (x, y) in enumerate(places)]
        self.session.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})


def test_one_finger_drags_and_two_zoom_the_page_and_drag_nothing(phone):
    # A link with a board does not swing as it opens, so what is read stays.
    phone.start("dot_product", "#dot_product?a=7,1")
    phone.read(r"a = \(7, 1\)")
    before = phone.text().splitlines()
    fingers = Fingers(phone.page)
    # The tip of a, then another finger beside it; both move apart.
    fingers.send("touchStart", TIP_ON_PHONE)
    fingers.send("touchStart", TIP_ON_PHONE, (120, 300))
    for way in range(0, 90, 10):
        fingers.send("touchMove", (TIP_ON_PHONE[0] + way, TIP_ON_PHONE[1] + way), (120 - way, 300 - way))
    fingers.send("touchEnd")
    phone.page.wait_for_timeout(500)
    assert [line for line in phone.text().splitlines() if " ns" not in line] == [line for line in before if " ns" not in line]
    assert phone.page.evaluate("visualViewport.scale") > 1.2


def test_after_two_fingers_one_drags_again(phone):
    phone.start("dot_product")
    fingers = Fingers(phone.page)
    fingers.send("touchStart", (100, 300))
    fingers.send("touchStart", (100, 300), (200, 300))
    fingers.send("touchEnd", (100, 300))
    fingers.send("touchEnd")
    fingers.send("touchStart", TIP_ON_PHONE)
    for way in range(0, 60, 10):
        fingers.send("touchMove", (TIP_ON_PHONE[0] - way, TIP_ON_PHONE[1]))
    fingers.send("touchEnd")
    phone.read(r"a = \((?!7)")


def test_on_a_phone_the_lesson_fills_the_page_and_is_used_by_touch(phone):
    phone.start("dot_product")
    phone.read(r"a = \(7, 1\)")
    box = phone.page.locator("canvas").bounding_box()
    assert (box["x"], box["width"], box["y"] + box["height"]) == (0, 390, 844)
    assert phone.page.evaluate("document.documentElement.scrollWidth") == 390
    # The next step.
    phone.page.touchscreen.tap(354, 519)
    phone.read(r"Step 2 of \d")
