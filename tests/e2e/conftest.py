"""What all tests in the browser share: the served site, one Chromium, and pages that fail on any complaint."""

import json
import os
import pathlib
import sys
import threading

import pytest
from playwright.sync_api import sync_playwright

ROOT = pathlib.Path(__file__).resolve().parents[2]
SITE = ROOT / "build" / "export" / "web"
FIRST_FRAMES = SITE / "first_frames.json"

sys.path.insert(0, str(ROOT / "tools" / "web"))

from demo_page import DemoPage  # noqa: E402 (found beside this file)
from server import open_server  # noqa: E402 (found by the path above)

# WebGL 2 without a graphics card; as root Chromium has no sandbox.
DRAWN_BY_SOFTWARE = ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--no-sandbox"]
WITHOUT_WEBGL = ["--disable-gpu", "--disable-3d-apis", "--no-sandbox"]
WIDE = {"width": 1280, "height": 720}


def start_browser(playwright, arguments):
    return playwright.chromium.launch(executable_path=os.environ["CHROMIUM"], args=arguments)


@pytest.fixture(scope="session")
def site():
    """The address of the site, without a slash at the end."""
    server = open_server(SITE, 0)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    yield f"http://127.0.0.1:{server.server_port}"
    server.shutdown()


@pytest.fixture(scope="session")
def playwright():
    with sync_playwright() as running:
        yield running


@pytest.fixture(scope="session")
def browser(playwright):
    browser = start_browser(playwright, DRAWN_BY_SOFTWARE)
    yield browser
    browser.close()


@pytest.fixture(scope="session")
def wide_context(browser):
    """One context for all tests, as for a visitor who goes from demo to demo: the engine is loaded once.

    It asks for reduced motion, so that a lesson waits at its start.
    """
    context = browser.new_context(viewport=WIDE, reduced_motion="reduce")
    yield context
    context.close()


@pytest.fixture
def demo(wide_context, site):
    """An empty page in a window of 1280x720."""
    page = DemoPage(wide_context.new_page(), site)
    yield page
    page.close()


@pytest.fixture(scope="session")
def first_frames():
    """Milliseconds to the first frame by demo; kept for `./lab needs`."""
    measured = json.loads(FIRST_FRAMES.read_text()) if FIRST_FRAMES.exists() else {}
    yield measured
    FIRST_FRAMES.write_text(json.dumps(measured, indent="\t") + "\n")
