"""The game on a phone: a level is played to its end by a finger, and one by keys."""

import pytest

from demo_page import DemoPage
from test_page import PHONE, Fingers

# A place on the empty board, the target of the first level, and the large button.
EMPTY = (200, 400)
TARGET = (299, 258)
FIRE = (302, 550)
# A press of an arrow key moves the end of the barrel by 2 px, 78 px from the gun. So many turn it from 80 to 28 degrees.
PRESSES = 47


@pytest.fixture
def phone(browser, site):
    context = browser.new_context(**PHONE, reduced_motion="reduce")
    page = DemoPage(context.new_page(), site)
    yield page
    page.close()
    context.close()


def test_a_finger_turns_the_barrel_fires_and_goes_on(phone):
    phone.start("aiming_game")
    phone.read(r"Level 1 of 7 · shots: 0")
    fingers = Fingers(phone.page)
    fingers.send("touchStart", EMPTY)
    for part in range(1, 9):
        x, y = (start + (end - start) * part / 8 for start, end in zip(EMPTY, TARGET))
        fingers.send("touchMove", (x, y))
    fingers.send("touchEnd")
    phone.page.touchscreen.tap(*FIRE)
    phone.read(r"Level 1 of 7 · shots: 1")
    phone.read(r"Hit with the first shot!")
    phone.page.touchscreen.tap(*FIRE)
    phone.read(r"Level 2 of 7 · shots: 0")
    phone.read(r"It moves: aim where it will be")


def test_keys_turn_the_barrel_fire_and_go_on(phone):
    phone.start("aiming_game")
    phone.read(r"Level 1 of 7 · shots: 0")
    phone.page.locator("canvas").focus()
    phone.page.keyboard.press("Tab")
    for _ in range(PRESSES):
        phone.page.keyboard.press("ArrowRight")
    phone.page.keyboard.press("Enter")
    phone.read(r"Level 1 of 7 · shots: 1")
    phone.read(r"Hit with the first shot!")
    phone.page.keyboard.press("Enter")
    phone.read(r"Level 2 of 7 · shots: 0")
