"""What a person does first in each lesson, and what the lesson says before and after.

Places are pixels of a page of 1280x720. The patterns are regular expressions; minus signs are those of the lesson (−).
"""

import dataclasses


@dataclasses.dataclass(frozen=True)
class Use:
    """A click at `start`, or a drag from there to `end`."""

    start: tuple
    before: str
    after: str
    end: tuple = None

    def do(self, page):
        if self.end:
            page.drag(self.start, self.end)
        else:
            page.click(*self.start)


USES = {
    # The tip of position: old is the same object and goes along, old_value stays.
    "class_or_value": Use((304, 299), r"old \(4, −4\)", r"old \(2, −4\)[^]*old_value \(2, −3\)", (241, 299)),
    # An end of the floor: on a tilted one the easy way is wrong.
    "easy_bounce": Use((252, 437), r"The easy way is right", r"^✗ A tilted line:", (252, 350)),
    # The tip of v.
    "normals": Use((631, 461), r"= \(−1, 3\)", r"= \(−1, 2\)", (564, 461)),
    # The tip of a, from (7, 1) to (3, 1).
    "dot_product": Use((692, 431), r"^dot product: 5,", r"^dot product: 1\.8,", (541, 431)),
    "projection_proof": Use((664, 427), r"a′\.x = 5$", r"a′\.x = 1\.8$", (530, 427)),
    # The ball, further away.
    "line_distance": Use((624, 337), r"Free: a gap of 70 px", r"Free: a gap of 94 px", (689, 337)),
    # Where the ball is after the frame: further away, so that it touches sooner in it.
    "point_of_impact": Use((452, 551), r"t = 0\.5, within", r"t = 0\.4\d*, within", (452, 626)),
    # The tip of v, from (3, 4) to (4, 4).
    "reflection": Use((533, 532), r"reflect\(n, C\): \(3, −4\)", r"reflect\(n, C\): \(4, −4\)", (568, 532)),
    # The next step: before it the lesson asks.
    "angled_lines": Use((1245, 153), r"^Drag on the board to draw a line", r"at its next touch\?"),
    # The situation "Miss".
    "line_ends": Use((1145, 500), r"^bounces on the end", r"D < 0: no root"),
    # The first component of a, from 4 to 2.
    "more_dimensions": Use((476, 172), r"a · b: 18,", r"a · b: 14,", (476, 210)),
    # Stop: it measures by itself.
    "error_and_time": Use((918, 232), r"Run \d+ of \d+", r"Stopped after \d+ of \d+ runs"),
}
