"""The index shows every demo, also without JavaScript and on a phone."""

import pytest

from demo_page import DemoPage
from uses import USES

DEMOS = ["lab", *USES, "workshop"]
WINDOWS = {
    "wide": {"viewport": {"width": 1280, "height": 720}},
    "phone": {"viewport": {"width": 390, "height": 844}, "device_scale_factor": 2, "is_mobile": True},
    "no script": {"viewport": {"width": 1280, "height": 720}, "java_script_enabled": False},
}


@pytest.fixture(params=WINDOWS)
def index(request, browser, site):
    context = browser.new_context(**WINDOWS[request.param])
    page = DemoPage(context.new_page(), site)
    page.open("index.html")
    yield page.page
    page.close()
    context.close()


def test_it_has_a_card_for_each_demo_in_order(index):
    hrefs = [link.get_attribute("href") for link in index.get_by_role("link").all()]
    assert hrefs == ["lab/index.html", "notes.html", "rubric.html"] + [f"{demo}/index.html" for demo in DEMOS[1:]]


def test_each_card_has_its_words_and_its_picture(index):
    for card in index.locator("ol > .card").all():
        card.scroll_into_view_if_needed()
        assert len(card.get_by_role("heading").inner_text()) > 3
        assert len(card.locator("p").inner_text()) > 20
    index.wait_for_function("[...document.images].every(image => image.complete && image.naturalWidth > 0)")


def test_nothing_is_wider_than_the_window(index):
    assert index.evaluate("document.documentElement.scrollWidth <= window.innerWidth")


def test_a_click_anywhere_on_a_card_opens_its_demo(index):
    index.locator(".card", has_text="The dot product").first.click(position={"x": 20, "y": 20})
    index.wait_for_url("**/dot_product/index.html")


def test_each_page_leads_to_the_next_and_back(wide_context, site):
    page = wide_context.new_page()
    # The links are in the page itself: no engine is needed to look at them.
    page.route("**/engine/*", lambda route: route.fulfill(body=""))
    for demo, following in zip(DEMOS, [*DEMOS[1:], None]):
        page.goto(f"{site}/{demo}/index.html")
        hrefs = [link.get_attribute("href") for link in page.locator("header").get_by_role("link").all()]
        # The lab has the ways between its lessons inside.
        has_next = following and demo != "lab"
        assert hrefs == ["../index.html"] + ([f"../{following}/index.html"] if has_next else [])
        assert page.locator("meta[name=description]").get_attribute("content")
    page.close()
