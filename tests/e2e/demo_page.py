"""A page of the site as a person uses it: sees, reads, clicks and drags."""

import json

from playwright.sync_api import TimeoutError

# How long to wait for a start and for an answer. These are no limits on speed.
START_MS = 90_000
ANSWER_MS = 20_000

# What the lesson says: its lines, as a screen reader finds them.
LINES = "[...document.querySelectorAll('#lesson_text p')].map(line => line.textContent).join('\\n')"


class DemoPage:
    """Notes every complaint of the browser; `close` fails if there was one."""

    def __init__(self, page, site):
        self.page = page
        self.site = site
        self.complaints = []
        page.on("console", self._note_message)
        page.on("pageerror", lambda error: self.complaints.append(f"page error: {error}"))
        page.on("requestfailed", self._note_failure)
        page.on("response", self._note_response)

    def open(self, path):
        self.page.goto(f"{self.site}/{path}")

    def start(self, demo, link=""):
        """Opens a demo and waits for its first frame; returns the milliseconds that it took."""
        self.open(f"{demo}/index.html{link}")
        self.page.wait_for_function("document.documentElement.dataset.firstFrame", timeout=START_MS)
        assert self.page.locator("#cover").is_hidden()
        return int(self.page.evaluate("document.documentElement.dataset.firstFrame"))

    def text(self):
        return self.page.evaluate(LINES)

    def read(self, pattern):
        """Waits until the lesson says what fits the regular expression."""
        try:
            self.page.wait_for_function(f"new RegExp({json.dumps(pattern)}, 'mu').test({LINES})", timeout=ANSWER_MS)
        except TimeoutError:
            raise AssertionError(f"the lesson does not say {pattern!r} but:\n{self.text()}") from None

    def click(self, x, y):
        self.page.mouse.click(x, y)

    def drag(self, start, end):
        """With the left button down, and on the way in steps, as a hand moves."""
        self.page.mouse.move(*start)
        self.page.mouse.down()
        self.page.mouse.move(*end, steps=8)
        self.page.mouse.up()

    def close(self):
        self.page.close()
        assert not self.complaints, "\n".join(self.complaints)

    def _note_message(self, message):
        if message.type == "error":
            self.complaints.append(f"console: {message.text}")

    def _note_failure(self, request):
        # Leaving a page aborts what it still loads: that is no complaint.
        if request.failure != "net::ERR_ABORTED":
            self.complaints.append(f"{request.failure}: {request.url}")

    def _note_response(self, response):
        if response.status >= 400 or not response.url.startswith((self.site, "data:", "blob:")):
            self.complaints.append(f"{response.status}: {response.url}")
