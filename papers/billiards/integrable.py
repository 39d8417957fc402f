#!/usr/bin/env python3
"""Tables whose orbits are known in closed form: integrable.py CAROM [--long]

Prints the largest error of each and its bound; exit status 1 if one is broken.

circle     radius 1: the k-th hit is at theta_0 + k (pi - 2 alpha), sin alpha the angular momentum [Tabachnikov2005, ch. 2]
rectangle  1 by 0.6: reflections fold the straight line, x(t) = |x_0 + v t| folded into the period 2 L; hits counted
ellipse    semi-axes 2 and 1: the product of the angular momenta about the foci is the same after all hits [Tabachnikov2005, ch. 4]
triangle   equilateral, side 1: from the middle of the base at 60 degrees the orbit closes after 3 hits and 3/2, from elsewhere
           after 6 and 3; any other orbit has 6 directions
magnetic   in the circle: the centre of gyration keeps its distance d from the middle, hits advance by 2 pi - 2 alpha,
           cos alpha = (1 + d^2 - r^2) / (2 d), r the radius of gyration; 60 hits, with `--long` 60000
"""
from study import *

WALL = """
[[wall]]
kind = "polygon"
vertices = [[0, 0], [1, 0], [0.5, "0.86602540378443864676372317075293618347140262690519"]]
[[ball]]
position = [%s]
velocity = [%s]
radius = 0
"""


def circle_angle(place):
    return math.atan2(place[1], place[0])


def turn(a, b):
    return abs(math.remainder(a - b, 2 * math.pi))


def hits(scene, *settings, **options):
    """Rows of the event log as dictionaries of text, and the summary."""
    out = folder("hits")
    seen = run(scene, 'output.events="hits.csv"', *settings, out=out, final=True, **options)
    return list(rows(out / "hits.csv")), seen


def place(hit):
    return float(hit["x"]), float(hit["y"])


def report(what, error, bound):
    row(what, f"{error:.1e}", f"{bound:.0e}")
    within(what, error, 0, bound)


def circle():
    log, _ = hits(EXAMPLES / "circle_billiard" / "scene.toml", events=1001)
    l = 0.2 * math.sin(0.6) + 0.1 * math.cos(0.6)
    middle = 0.2 * math.cos(0.6) - 0.1 * math.sin(0.6)  # along the path, from the point nearest to the centre
    reach = math.sqrt(1 - l * l) - middle
    first = math.atan2(-0.1 + reach * math.sin(0.6), 0.2 + reach * math.cos(0.6))
    step = math.pi - 2 * math.asin(l)
    errors = [turn(circle_angle(place(hit)), first + k * step) for k, hit in enumerate(log)]
    report("circle: angle of hits 0 to 1000", max(errors), 1e-10)


def fold(x, length):
    x = math.fmod(x, 2 * length)
    return x if x <= length else 2 * length - x


def rectangle(until, x, hits_x, hits_y):
    """x at that time from 40 digits; y, of rational numbers, is 0.59."""
    log, seen = hits(EXAMPLES / "rectangle_billiard" / "scene.toml", until=until)
    at = seen["final"][0]["position"]
    report(f"rectangle: place at t = {until}", max(abs(at[0] - x), abs(at[1] - 0.59)), 1e-10 * until)
    count = [sum(hit["partner"][0] == axis for hit in log) for axis in "xy"]
    row(f"rectangle: hits to t = {until}", f"{count[0]} and {count[1]}", f"{hits_x} and {hits_y}")
    within("hits of the rectangle", abs(count[0] - hits_x) + abs(count[1] - hits_y), 0, 0)


def ellipse(count, bound):
    scene = f"""
        [[table]]
        kind = "ellipse"
        axes = [2, 1]
        [[ball]]
        position = [{2 * math.cos(0.3)!r}, {math.sin(0.3)!r}]
        velocity = [{math.cos(2.5)!r}, {math.sin(2.5)!r}]
        radius = 0
        [observe]
        caustic = true
        """
    caustic = run(scene, events=count)["observed"]["caustic"]
    report(f"ellipse: mean of L1 L2 over {count} hits", abs(caustic["invariant"]["value"] - 0.8305520941916194), bound)
    report(f"ellipse: spread of L1 L2 over {count} hits", caustic["spread"]["value"], bound)


def triangle():
    for start, period in ((0.5, 3), (0.4, 6)):
        s = math.sqrt(3) / 2
        log, seen = hits(WALL % (f"{start}, 0", f"0.5, {s!r}"), events=100 * period)
        off = max(math.hypot(float(log[k]["x"]) - start, float(log[k]["y"])) for k in range(period - 1, len(log), period))
        report(f"triangle: place after 1 to 100 periods of {period} hits", off, 1e-10)
        report(f"triangle: length of 100 periods of {period} hits", abs(seen["time"] - 50 * period), 1e-10)
    log, _ = hits(WALL % ("0.3, 0.1", f"{math.cos(0.5)!r}, {math.sin(0.5)!r}"), events=10000)
    directions = {(round(float(hit["vx"]), 9), round(float(hit["vy"]), 9)) for hit in log}
    row("triangle: directions in 10000 hits", len(directions), 6)
    within("directions in the triangle", len(directions), 6, 0)


def magnetic(count, bound):
    log, _ = hits(EXAMPLES / "magnetic_circle" / "scene.toml", events=count + 1)
    omega, r = 0.7, 1 / 0.7
    d = math.hypot(0.3 - math.sin(1.1) / omega, 0.1 + math.cos(1.1) / omega)
    step = 2 * math.pi - 2 * math.acos((1 + d * d - r * r) / (2 * d))
    angles = [circle_angle(place(hit)) for hit in log]
    report(f"magnetic circle: angle of {count} hits after the first", max(turn(a, angles[0] + k * step) for k, a in enumerate(angles)), bound)
    centres = [math.hypot(x - float(hit["vy"]) / omega, y + float(hit["vx"]) / omega)
               for hit in log for x, y in (place(hit),)]
    report(f"magnetic circle: d over {count} hits", max(abs(c - d) for c in centres), bound)


def main():
    head("", "largest error", "bound")
    circle()
    rectangle(100, 0.27864376269049, 141, 167)
    rectangle(10000, 0.4356237309512, 14142, 16667)
    ellipse(1000, 1e-12)
    ellipse(1_000_000, 1e-10)
    triangle()
    magnetic(60, 1e-11)
    if LONG:
        magnetic(60_000, 1e-8)
    end()


if __name__ == "__main__":
    main()
