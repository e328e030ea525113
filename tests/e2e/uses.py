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
    # The tip of position.
    "class_or_value": Use((235, 312), r"= Vec2\.new\(2, -3\)", r"= Vec2\.new\(0, -3\)", (175, 312)),
    # An end of the floor.
    "easy_bounce": Use((744, 441), r"tilt = 0°", r"tilt = [-−]?[1-9]", (744, 340)),
    # The tip of v.
    "normals": Use((631, 444), r"v = \(3, 1\)", r"v = \(2, 1\)", (559, 444)),
    # The tip of a, from (7, 1) to (3, 1).
    "dot_product": Use((695, 399), r"a = \(7, 1\)", r"a = \(3, 1\)", (535, 399)),
    # The next step: before it the lesson asks.
    "projection_proof": Use((1244, 115), r"Step 1 of 7", r"Where does the head of a go\?"),
    # The ball, further away.
    "line_distance": Use((623, 311), r"c = \(120, -35\)", r"c = \(160, -35\)", (688, 311)),
    # Where the ball is after the frame: further away, so that it touches sooner in it.
    "point_of_impact": Use((439, 540), r"new \(6, 42\)", r"new \(6, [56]\d\)", (439, 615)),
    # The next step.
    "reflection": Use((1244, 115), r"Step 1 of 5", r"Step 2 of 5"),
    # The next step: before it the lesson asks.
    "angled_lines": Use((1244, 115), r"Drag on the board to draw a line", r"at its next touch\?"),
    # The next step.
    "line_ends": Use((1244, 115), r"Step 1 of 7", r"Step 2 of 7"),
    # The next step.
    "more_dimensions": Use((1244, 115), r"Step 1 of 5", r"Step 2 of 5"),
    # Stop: it measures by itself.
    "error_and_time": Use((897, 199), r"Run \d+ of \d+", r"Stopped after \d+ of \d+ runs"),
}
