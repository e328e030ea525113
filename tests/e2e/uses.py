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
    "class_or_value": Use((235, 334), r"= Vec2\.new\(2, -3\)", r"= Vec2\.new\(0, -3\)", (175, 334)),
    # An end of the floor.
    "easy_bounce": Use((714, 456), r"tilt = 0°", r"tilt = [-−]?[1-9]", (714, 350)),
    # The tip of v.
    "normals": Use((631, 466), r"v = \(3, 1\)", r"v = \(2, 1\)", (559, 466)),
    # The tip of a, from (7, 1) to (3, 1).
    "dot_product": Use((676, 418), r"a = \(7, 1\)", r"a = \(3, 1\)", (527, 418)),
    # The ball, further away.
    "line_distance": Use((594, 329), r"c = \(120, -35\)", r"c = \(160, -35\)", (654, 329)),
    # Where the ball is after the frame: further away, so that it touches sooner in it.
    "point_of_impact": Use((438, 552), r"new \(6, 42\)", r"new \(6, [56]\d\)", (438, 612)),
    # Where the ball comes from: v changes from (3, 4) to (4, 4).
    "reflection": Use((319, 253), r"v = \(3, 4\)", r"v = \(4, 4\)", (287, 253)),
    # The next step: before it the lesson asks.
    "angled_lines": Use((1244, 158), r"Drag on the board to draw a line", r"at its next touch\?"),
    # The situation "Miss".
    "line_ends": Use((1164, 465), r"P = \(-6, -8\)", r"P = \(-9, -7\)"),
    # The first component of a, from 4 to 2.
    "more_dimensions": Use((459, 157), r"a = \(4, -3, 2\)", r"a = \(2, -3, 2\)", (459, 198)),
    # The target, to the right.
    "aim_at": Use((279, 546), r"T = \(-80, 110\)", r"T = \(-50, 110\)", (330, 546)),
    # The tip of v.
    "lead_target": Use((620, 359), r"v = \(0, 90\)", r"v = \(40, 90\)", (688, 359)),
    # The next step.
    "ballistic_aim": Use((1244, 110), r"Step 1 of 6", r"Step 2 of 6"),
    # The next step.
    "bank_shot": Use((1244, 110), r"Step 1 of 6", r"Step 2 of 6"),
    # Where the target starts.
    "timed_shot": Use((175, 278), r"T = \(-300, -100\)", r"T = \(-200, -100\)", (255, 278)),
    # The button that fires, below the board.
    "aiming_game": Use((754, 621), r"shots: 0", r"shots: 1"),
    # The tip of v₁: one unit to the left.
    "newton_balls": Use((415, 279), r"v₁ = \(6, 0\)", r"v₁ = \(5, 0\)", (375, 279)),
    # The tail of v: twenty pixels of the plane to the right.
    "collision_friction": Use((267, 311), r"v = \(300, 400\)", r"v = \(200, 400\)", (316, 311)),
    # The end of the line.
    "slide_and_roll": Use((607, 503), r"B = \(48, 36\)", r"B = \(68, 36\)", (687, 503)),
    # The head of v.
    "moving_platforms": Use((527, 288), r"v = \(-200, 100\)", r"v = \(-120, 100\)", (602, 288)),
    # The tip of a.
    "projection_proof": Use((639, 413), r"a = \(7, 1\)", r"a = \(3, 1\)", (511, 413)),
    # The next step, while it measures by itself: before it the lesson asks.
    "error_and_time": Use((1246, 152), r"Step 1 of 3", r"has the smallest error\?|Step 2 of 3"),
}
