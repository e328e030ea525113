#!/usr/bin/env python3
"""Draws the signs that the lessons use and that the engine's font has not, into assets/signs.ttf.

A program on the desktop borrows such signs from the system's fonts; in the browser there are none to borrow from.
Run from the root of the project, with fonttools 4.60 from PyPI: python3 tools/draw/make_signs_font.py
"""

from math import hypot

from fontTools.fontBuilder import FontBuilder
from fontTools.pens.ttGlyphPen import TTGlyphPen

FILE = "assets/signs.ttf"
# Sizes in thousandths of the font's size; heights of a line and of its letters as in the engine's font.
EM = 1000
ASCENT, DESCENT = 1069, 293
BAR = 105
MIDDLE = 350
# A fixed moment, so that the same drawing gives the same file.
MOMENT = 0


def bar(start, end, width=BAR):
    """A bar from point to point, with square ends."""
    (x, y), (to_x, to_y) = start, end
    length = hypot(to_x - x, to_y - y)
    across, up = -(to_y - y) / length * width / 2, (to_x - x) / length * width / 2
    return [(x + across, y + up), (to_x + across, to_y + up), (to_x - across, to_y - up), (x - across, y - up)]


def turned(shape, quarters, center=(400, MIDDLE)):
    """The shape after quarter turns to the left."""
    points = [(x - center[0], y - center[1]) for x, y in shape]
    for _ in range(quarters):
        points = [(-y, x) for x, y in points]
    return [(x + center[0], y + center[1]) for x, y in points]


def arrow(quarters):
    """To the right, and turned."""
    shaft = bar((90, MIDDLE), (500, MIDDLE))
    head = [(720, MIDDLE), (430, MIDDLE - 200), (430, MIDDLE + 200)]
    return [turned(shape, quarters) for shape in (shaft, head)]


def cross(half):
    left, right = 330 - half, 330 + half
    low, high = MIDDLE - half, MIDDLE + half
    return [bar((left, low), (right, high)), bar((left, high), (right, low))]


# Character, name, width, outlines.
SIGNS = [
    ("→", "right", 800, arrow(0)),
    ("↑", "up", 800, arrow(1)),
    ("←", "left", 800, arrow(2)),
    ("↓", "down", 800, arrow(3)),
    ("✓", "check", 760, [bar((90, 350), (310, 110)), bar((270, 100), (660, 640))]),
    ("✗", "cross", 660, cross(220)),
    ("✕", "small_cross", 660, cross(190)),
    ("⁻", "superscript_minus", 420, [bar((50, 590), (370, 590), 70)]),
]


def glyph(outlines):
    pen = TTGlyphPen(None)
    for points in outlines:
        area = sum(x * to_y - to_x * y for (x, y), (to_x, to_y) in zip(points, points[1:] + points[:1]))
        # Filled outlines run clockwise; two of one glyph may overlap.
        ordered = points[::-1] if area > 0 else points
        pen.moveTo(tuple(round(value) for value in ordered[0]))
        for point in ordered[1:]:
            pen.lineTo(tuple(round(value) for value in point))
        pen.closePath()
    return pen.glyph()


def main():
    names = [".notdef"] + [name for _, name, _, _ in SIGNS]
    font = FontBuilder(EM, isTTF=True)
    font.setupGlyphOrder(names)
    font.setupCharacterMap({ord(sign): name for sign, name, _, _ in SIGNS})
    font.setupGlyf({".notdef": glyph([]), **{name: glyph(outlines) for _, name, _, outlines in SIGNS}})
    font.setupHorizontalMetrics({".notdef": (500, 0), **{name: (width, 0) for _, name, width, _ in SIGNS}})
    font.setupHorizontalHeader(ascent=ASCENT, descent=-DESCENT)
    font.setupNameTable({"familyName": "Vec2 Lab Signs", "styleName": "Regular"})
    font.setupOS2(sTypoAscender=ASCENT, sTypoDescender=-DESCENT, usWinAscent=ASCENT, usWinDescent=DESCENT)
    font.setupPost()
    font.updateHead(created=MOMENT, modified=MOMENT)
    font.font.recalcTimestamp = False
    font.save(FILE)


if __name__ == "__main__":
    main()
