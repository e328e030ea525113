"""A lesson in the frame of another site, as in a course or on a page of games."""

import threading

import pytest

from demo_page import START_MS
from server import open_server

HOST = """<!doctype html><meta charset="utf-8"><body style="margin: 0; height: 3000px">
<input id="before" autofocus><br>
<iframe src="{site}/dot_product/index.html" width="1200" height="600" style="border: 0"
	allow="clipboard-write; fullscreen; gamepad" sandbox="allow-scripts allow-same-origin"></iframe><br>
<input id="behind">"""


@pytest.fixture
def host(demo, tmp_path):
    (tmp_path / "host.html").write_text(HOST.format(site=demo.site))
    server = open_server(tmp_path, 0)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    demo.page.goto(f"http://127.0.0.1:{server.server_port}/host.html")
    demo.lesson = demo.page.frames[-1]
    demo.lesson.wait_for_function("document.documentElement.dataset.firstFrame", timeout=START_MS)
    demo.page.wait_for_timeout(1000)
    yield demo
    server.shutdown()
    demo.complaints.clear()


def focused(host):
    return host.page.evaluate("document.activeElement.id || document.activeElement.tagName")


def turn_wheel_over_board(host):
    host.page.mouse.move(400, 300)
    host.page.wait_for_timeout(500)
    host.page.mouse.wheel(0, 100)


def test_it_takes_no_focus_when_the_page_loads(host):
    assert focused(host) == "before"


def test_the_wheel_scrolls_the_page_until_the_lesson_has_the_focus(host):
    turn_wheel_over_board(host)
    host.page.wait_for_function("scrollY === 100")
    host.page.evaluate("scrollTo(0, 0)")
    host.click(400, 300)
    turn_wheel_over_board(host)
    host.page.wait_for_timeout(2000)
    assert host.page.evaluate("scrollY") == 0


def test_tab_comes_into_the_lesson_and_out_of_it_behind_its_last_part(host):
    tabs = 0
    while focused(host) != "behind" and tabs < 100:
        host.page.keyboard.press("Tab")
        host.page.wait_for_timeout(350)
        tabs += 1
    assert focused(host) == "behind"
    # The links above the lesson, and its own parts.
    assert tabs > 12


def test_tab_with_shift_leaves_before_the_first_part(host):
    host.lesson.locator("canvas").focus()
    host.page.keyboard.press("Tab")
    host.page.wait_for_timeout(500)
    assert host.lesson.evaluate("document.activeElement.id") == "canvas"
    host.page.keyboard.press("Shift+Tab")
    host.page.wait_for_timeout(500)
    assert host.lesson.evaluate("document.activeElement.closest('header') !== null")
