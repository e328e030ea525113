"""The speaker's notes lead the lab in a second window from row to row, without loading it again."""

import re

import pytest

from demo_page import DemoPage

KEPT = "window.was_not_loaded_again = true"


@pytest.fixture
def notes(wide_context, site):
    page = DemoPage(wide_context.new_page(), site)
    page.open("notes.html")
    yield page
    page.close()


@pytest.fixture
def lab(notes, site):
    """The second window, as the first press of Page Down opens it."""
    with notes.page.expect_popup() as popup:
        notes.page.keyboard.press("PageDown")
    lab = DemoPage(popup.value, site)
    lab.page.wait_for_function("document.documentElement.dataset.firstFrame", timeout=90_000)
    lab.page.evaluate(KEPT)
    yield lab
    lab.close()


def now(notes):
    return int(notes.page.locator("article.now").get_attribute("data-number"))


def test_the_lab_follows_the_keys_and_the_button(notes, lab):
    assert now(notes) == 1
    lab.read("Step 1 of 3")
    notes.page.keyboard.press("PageDown")
    lab.page.wait_for_function("location.hash.startsWith('#easy_bounce')")
    lab.read("Step 1 of 5")
    notes.page.get_by_role("button", name="Next row").click()
    lab.read("Step 2 of 5")
    assert now(notes) == 3
    notes.page.keyboard.press("PageUp")
    lab.read("Step 1 of 5")
    assert now(notes) == 2
    assert lab.page.evaluate("window.was_not_loaded_again")


def test_a_link_of_any_row_is_followed(notes, lab):
    notes.page.get_by_role("button", name="All rows").click()
    link = notes.page.locator("#row_17 h2 a")
    link.click()
    lab.read(r"a = \(.5, 2\)")
    lab.read("Step 5 of 9")
    assert now(notes) == 17
    assert lab.page.evaluate("window.was_not_loaded_again")


def test_a_row_has_its_question_its_answer_and_the_time(notes):
    row = notes.page.locator("article.now")
    for kind in ["show", "ask", "answer", "rubric"]:
        assert len(row.locator(f".{kind}").inner_text()) > 5
    assert notes.page.locator("#clock").inner_text() == "0 min gone, 120 left"


def test_a_shorter_version_goes_through_its_own_rows(notes):
    notes.page.locator("#version").select_option(label="30 minutes")
    assert re.fullmatch(r"row 1 of 14", notes.page.locator("#place").inner_text())
    # The clock counts from the first row that is opened.
    assert "29 left" in notes.page.locator("#clock").inner_text()


def test_nothing_is_wider_than_a_phone(notes):
    notes.page.set_viewport_size({"width": 390, "height": 844})
    assert notes.page.evaluate("document.documentElement.scrollWidth <= window.innerWidth")


def test_without_javascript_all_rows_are_there(browser, site):
    context = browser.new_context(java_script_enabled=False)
    page = context.new_page()
    page.goto(f"{site}/notes.html")
    assert page.locator("article:visible").count() > 40
    context.close()
