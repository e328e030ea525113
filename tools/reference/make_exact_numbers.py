#!/usr/bin/env python3
"""Writes the reference values for DoubleDouble and ExactProjection.

Run from the root of the project: python3 tools/reference/make_exact_numbers.py

Every input is a double taken as exact. The answers are worked out with Python's fractions, roots with
3000 bits, and stored as a pair of doubles: the nearest double, and the double nearest to what is left.
A double is written as the 16 hexadecimal digits of its bytes, little end first, because Godot does not
read every decimal number back to the last bit.
"""

import json
import random
import struct
from fractions import Fraction
from math import isqrt
from pathlib import Path

SEED = 20
ROWS_PER_FAMILY = 40
ROOT_BITS = 3000
DATA_FOLDER = Path("tests/data")


def hex_digits(number: float) -> str:
    return struct.pack("<d", number).hex()


def pair(exact: Fraction) -> list[float]:
    high = float(exact)
    return [high, float(exact - Fraction(high))]


def square_root(exact: Fraction) -> Fraction:
    return Fraction(isqrt(int(exact * 4**ROOT_BITS)), 2**ROOT_BITS)


def random_magnitude(generator: random.Random, largest_exponent: float) -> float:
    sign = generator.choice([-1.0, 1.0])
    return sign * 10.0 ** generator.uniform(-largest_exponent, largest_exponent)


def random_pair(generator: random.Random) -> list[float]:
    high = random_magnitude(generator, 20.0)
    return pair(Fraction(high) + Fraction(high) * Fraction(generator.uniform(-1, 1)) / 2**53)


def nearly_opposite(generator: random.Random, number: list[float]) -> list[float]:
    exact = -Fraction(number[0]) - Fraction(number[1])
    return pair(exact * (1 + Fraction(generator.uniform(-1, 1)) / 2 ** generator.randint(1, 100)))


def operations_row(first: list[float], second: list[float]) -> list[float]:
    x = Fraction(first[0]) + Fraction(first[1])
    y = Fraction(second[0]) + Fraction(second[1])
    answers = [x + y, x - y, x * y, x / y, square_root(abs(x))]
    return first + second + [part for answer in answers for part in pair(answer)]


def operations() -> dict[str, list[list[float]]]:
    generator = random.Random(SEED)
    families: dict[str, list[list[float]]] = {"ordinary": [], "cancelling": []}
    for _ in range(ROWS_PER_FAMILY):
        families["ordinary"].append(operations_row(random_pair(generator), random_pair(generator)))
        first = random_pair(generator)
        families["cancelling"].append(operations_row(first, nearly_opposite(generator, first)))
    return families


def projection_row(components: list[float]) -> list[float]:
    ax, ay, bx, by = map(Fraction, components)
    dot = ax * bx + ay * by
    return components + pair(dot) + pair(dot / square_root(bx * bx + by * by))


def nearly_perpendicular(generator: random.Random) -> list[float]:
    bx, by = (generator.uniform(-1000.0, 1000.0) for _ in range(2))
    share = generator.uniform(-1.0, 1.0)
    return [-by * share, bx * share, bx, by]


def projections() -> dict[str, list[list[float]]]:
    generator = random.Random(SEED)
    makers = {
        "whole": lambda: [float(generator.randint(-1000, 1000)) for _ in range(4)],
        "ordinary": lambda: [generator.uniform(-1000.0, 1000.0) for _ in range(4)],
        "perpendicular": lambda: nearly_perpendicular(generator),
        "extreme": lambda: [random_magnitude(generator, 150.0) for _ in range(4)],
    }
    return {
        family: [projection_row(make()) for _ in range(ROWS_PER_FAMILY)]
        for family, make in makers.items()
    }


def write(name: str, columns: list[str], families: dict[str, list[list[float]]]) -> None:
    lines = [json.dumps({"columns": columns})[:-1] + ', "families": {']
    for family, rows in families.items():
        texts = [json.dumps([hex_digits(number) for number in row]) for row in rows]
        lines.append(f'"{family}": [\n' + ",\n".join(texts) + "\n],")
    lines[-1] = lines[-1].rstrip(",")
    (DATA_FOLDER / name).write_text("\n".join(lines) + "\n}}\n", encoding="utf-8")


def main() -> None:
    operation_names = ["sum", "difference", "product", "quotient", "root_of_abs_x"]
    operation_columns = ["x_high", "x_low", "y_high", "y_low"]
    operation_columns += [f"{name}_{part}" for name in operation_names for part in ("high", "low")]
    write("double_double.json", operation_columns, operations())
    projection_columns = ["ax", "ay", "bx", "by", "dot_high", "dot_low"]
    projection_columns += ["scalar_projection_high", "scalar_projection_low"]
    write("scalar_projection.json", projection_columns, projections())


if __name__ == "__main__":
    main()
