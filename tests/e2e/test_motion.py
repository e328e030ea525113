"""A lesson moves from its first frame until somebody acts, and not at all for whoever wants little motion."""

import time

import pytest

from conftest import WIDE
from demo_page import DemoPage

# What the lesson may take to move, and how long what stands still is watched.
WATCHED_S = 3
# Where only the plane with its arrows is. The text of the page says nothing of what moves by itself.
PLANE = {"x": 100, "y": 110, "width": 700, "height": 500}


@pytest.fixture
def moving(browser, site):
    """A page for somebody who has no wish about motion."""
    context = browser.new_context(viewport=WIDE, reduced_motion="no-preference")
    page = DemoPage(context.new_page(), site)
    yield page
    page.close()
    context.close()


def picture(demo):
    return demo.page.screenshot(clip=PLANE)


def pictures_while_watched(demo):
    """How many different ones there were."""
    end = time.monotonic() + WATCHED_S
    seen = set()
    while time.monotonic() < end:
        seen.add(picture(demo))
        demo.page.wait_for_timeout(100)
    return len(seen)


def test_with_reduced_motion_nothing_moves(demo):
    demo.start("dot_product")
    demo.read(r"a = \(7, 1\)")
    assert pictures_while_watched(demo) == 1
    # A key would stop what moves, and then the page would say where it is.
    demo.page.locator("canvas").focus()
    demo.page.keyboard.press("j")
    demo.page.wait_for_timeout(1000)
    demo.read(r"a = \(7, 1\)")


def test_without_that_wish_a_moves_at_once_and_a_click_on_the_board_stops_it_for_good(moving):
    first_frame = moving.start("dot_product")
    first = picture(moving)
    while picture(moving) == first:
        assert moving.page.evaluate("performance.now()") - first_frame < WATCHED_S * 1000
    moving.page.locator("canvas").focus()
    moving.page.keyboard.press("j")
    moving.read(r"a = \((?!7, 1\))")
    moving.page.reload()
    moving.page.wait_for_function("document.documentElement.dataset.firstFrame")
    assert pictures_while_watched(moving) > 1
    # Where neither arrow ever is.
    moving.click(301, 311)
    moving.read(r"a = \(-3, -2\)")
    moving.page.mouse.move(20, 690)
    moving.page.wait_for_timeout(500)
    assert pictures_while_watched(moving) == 1
    moving.read(r"a = \(-3, -2\)")
