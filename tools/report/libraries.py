"""Measures Box2D and Chipmunk at the ball in the box and at many balls.

Usage: libraries.py SHOTS RESULTS. SHOTS is what tools/report/write_shots.gd has written. RESULTS gets a
list of measurements in JSON; the error of the ball in the box is worked out by the report itself.

A run time is the median of 5 runs and holds the steps alone: reading places through Python would
take longer than moving the balls.
"""

import json
import math
import statistics
import sys
import time

import Box2D
import pymunk

RUNS = 5
RATES = (60, 240)
FRAMES_PER_SECOND = 60
OVERLAP_EVERY = 6
LOST_PX = 1.0


class Box2DWorld:
    """Box2D 2.3, every ball a bullet. Its speed limit and its tolerances are lengths in metres.

    Of 20 to 1000 px for a metre these were best at 300, 3000 and 30 000 px/s: 20, 100, 300.
    """

    method = "Box2D"

    def __init__(self, task, rate):
        self._step = 1.0 / rate
        self._pixels = self._pixels_per_metre(task["balls"])
        self._world = Box2D.b2World(gravity=(0, 0), doSleep=False)
        walls = self._world.CreateStaticBody()
        for x1, y1, x2, y2 in task["walls"]:
            ends = [self._metres(x1, y1), self._metres(x2, y2)]
            walls.CreateFixture(shape=Box2D.b2EdgeShape(vertices=ends), friction=0, restitution=1)
        circle = Box2D.b2CircleShape(radius=task["radius"] / self._pixels)
        self._bodies = [self._add(ball, circle) for ball in task["balls"]]

    @staticmethod
    def _pixels_per_metre(balls):
        speed = max(math.hypot(ball[2], ball[3]) for ball in balls)
        return 20 if speed < 1000 else 100 if speed < 10000 else 300

    def _metres(self, x, y):
        return x / self._pixels, y / self._pixels

    def _add(self, ball, circle):
        fixture = Box2D.b2FixtureDef(shape=circle, density=1, friction=0, restitution=1)
        return self._world.CreateDynamicBody(
            position=self._metres(ball[0], ball[1]),
            linearVelocity=self._metres(ball[2], ball[3]),
            fixtures=fixture,
            bullet=True,
            fixedRotation=True,
        )

    def advance(self, steps):
        """Makes so many steps."""
        for _ in range(steps):
            self._world.Step(self._step, 8, 3)

    def places(self):
        """x, y of each ball in pixels."""
        return [tuple(self._pixels * value for value in body.position) for body in self._bodies]

    def velocities(self):
        """x, y of each velocity in pixels per second."""
        return [tuple(self._pixels * value for value in body.linearVelocity) for body in self._bodies]

    def turn_round(self):
        """Reverses all velocities."""
        for body in self._bodies:
            body.linearVelocity = -body.linearVelocity


class ChipmunkWorld:
    """Chipmunk 7. It has no continuous detection: thick walls keep fast balls from passing."""

    method = "Chipmunk"
    _THICKNESS = 1000.0

    def __init__(self, task, rate):
        self._step = 1.0 / rate
        self._space = pymunk.Space()
        for wall in task["walls"]:
            self._add_wall(*wall)
        self._bodies = [self._add(ball, task["radius"]) for ball in task["balls"]]

    def _add_wall(self, x1, y1, x2, y2):
        # The walls go round clockwise on screen: outside is on the left hand.
        length = math.hypot(x2 - x1, y2 - y1)
        out_x = (y2 - y1) / length * self._THICKNESS
        out_y = -(x2 - x1) / length * self._THICKNESS
        ends = (x1 + out_x, y1 + out_y), (x2 + out_x, y2 + out_y)
        wall = pymunk.Segment(self._space.static_body, *ends, self._THICKNESS)
        wall.elasticity = 1.0
        self._space.add(wall)

    def _add(self, ball, radius):
        body = pymunk.Body(1.0, float("inf"))
        body.position = ball[0], ball[1]
        body.velocity = ball[2], ball[3]
        circle = pymunk.Circle(body, radius)
        circle.elasticity = 1.0
        self._space.add(body, circle)
        return body

    def advance(self, steps):
        """Makes so many steps."""
        for _ in range(steps):
            self._space.step(self._step)

    def places(self):
        """x, y of each ball in pixels."""
        return [tuple(body.position) for body in self._bodies]

    def velocities(self):
        """x, y of each velocity in pixels per second."""
        return [tuple(body.velocity) for body in self._bodies]

    def turn_round(self):
        """Reverses all velocities."""
        for body in self._bodies:
            body.velocity = -body.velocity


def run_time_us(kind, task, rate):
    """Microseconds per simulated second, and the world at its end."""
    world = kind(task, rate)
    steps = round(task["seconds"] * rate)
    start = time.perf_counter()
    world.advance(steps)
    return (time.perf_counter() - start) * 1e6 / task["seconds"], world


def measured(problem, kind, task, rate):
    """What both problems have in common, and the world at the end of a flight."""
    runs = [run_time_us(kind, task, rate) for _ in range(RUNS)]
    common = {
        "problem": problem,
        "method": kind.method,
        "situation": task["situation"],
        "tuning": f"{rate} Hz",
        "run_time_us": statistics.median(run[0] for run in runs),
    }
    return common, runs[0][1]


def ball_in_box(kind, task, rate):
    """Where the ball is at the end; the report knows where it should be."""
    common, world = measured("ball_in_box", kind, task, rate)
    return {**common, "end": world.places()[0]}


def many_balls(kind, task, rate):
    """The worst overlap, the drift of the energy, and how long a reversed run goes back."""
    common, _ = measured("many_balls", kind, task, rate)
    world = kind(task, rate)
    energy = energy_of(world)
    frames = [world.places()]
    for _ in range(round(task["seconds"] * FRAMES_PER_SECOND)):
        world.advance(rate // FRAMES_PER_SECOND)
        frames.append(world.places())
    overlap = max(worst_overlap(places, task["radius"]) for places in frames[1::OVERLAP_EVERY])
    drift = abs(energy_of(world) / energy - 1.0)
    world.turn_round()
    back = time_until_lost(world, frames, rate)
    return {**common, "error": overlap, "energy drift": drift, "reversed": back}


def time_until_lost(world, frames, rate):
    """Seconds until the first ball is too far off its own way back."""
    for back, places in enumerate(reversed(frames[:-1]), 1):
        world.advance(rate // FRAMES_PER_SECOND)
        if max(map(math.dist, world.places(), places)) > LOST_PX:
            return back / FRAMES_PER_SECOND
    return (len(frames) - 1) / FRAMES_PER_SECOND


def energy_of(world):
    """In px^2/s^2; all masses are equal."""
    return sum(x * x + y * y for x, y in world.velocities()) / 2.0


def worst_overlap(places, radius):
    """In pixels, 0 if none overlap; sorted by x, each has to look only at its neighbours."""
    ordered = sorted(places)
    least = 2.0 * radius
    for index, (x, y) in enumerate(ordered):
        for other_x, other_y in ordered[index + 1 :]:
            if other_x - x >= least:
                break
            least = min(least, math.hypot(other_x - x, other_y - y))
    return 2.0 * radius - least


def main():
    """Reads the shots, flies them all, writes the results."""
    shots_path, results_path = sys.argv[1:]
    with open(shots_path, encoding="utf-8") as file:
        shots = json.load(file)
    results = []
    for measure in (ball_in_box, many_balls):
        for task in shots[measure.__name__]:
            for kind in (Box2DWorld, ChipmunkWorld):
                results += [measure(kind, task, rate) for rate in RATES]
        print(f"{measure.__name__}: Box2D and Chipmunk, {RUNS} runs", flush=True)
    with open(results_path, "w", encoding="utf-8") as file:
        json.dump(results, file, indent="\t")


if __name__ == "__main__":
    main()
