"""Every demo starts in the browser, and answers to what a person does first."""

import pytest

from uses import USES


@pytest.mark.parametrize("lesson", USES)
def test_a_lesson_starts_and_answers(demo, first_frames, lesson):
    first_frames[lesson] = demo.start(lesson)
    use = USES[lesson]
    demo.read(use.before)
    assert demo.text().splitlines()[0] in demo.page.locator("h1").inner_text().replace("\u2002", "  ")
    use.do(demo)
    demo.read(use.after)


def test_the_lab_starts_with_cards_and_opens_a_lesson(demo, first_frames):
    first_frames["lab"] = demo.start("lab")
    demo.read("The dot product")
    demo.click(1026, 260)
    demo.read(r"a = \(7, 1\)")
    demo.page.keyboard.press("Escape")
    demo.read("Pick a lesson")
