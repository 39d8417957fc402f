#!/usr/bin/env python3
"""Nothing leaks through the joints of closed tables: joints.py CAROM [--long]

From one place inside, a point is sent at every joint of two pieces, corners among them, and past it by 1e-16, 1e-12 and 1e-8 on
either side, in the table as it is and turned by 0.7; so is a disk of radius 0.05, which meets the joint on the way. Each makes
20000 hits, with `--long` 1000000 (a point) and 100000 (a disk). A ray that gets out finds nothing more to hit, so it would end early,
or end outside.

The cusp of the cardioid is the tip of a spike that is thinner than rounding: points sent to within 1e-12 of it stop there, which is
said by `stopped_by`, and do not get out either.

Prints the rays of each table, those that stopped, the hits made and the least depth inside (negative: outside) at the end. Exit
status 1 if a ray did not make all its hits or ended outside by more than 1e-12; at the cusp, 1e-11.
"""
from study import *

H = math.sqrt(3) / 2
OFFSETS = [0.0] + [sign * size for size in (1e-16, 1e-12, 1e-8) for sign in (1, -1)]


def box(w, h):
    return [(-w, -h), (w, -h), (w, h), (-w, h)], lambda x, y: min(w - abs(x), h - abs(y))


def mushroom(radius, half, length):
    joints = [(radius, 0), (-radius, 0), (-half, 0), (-half, -length), (half, -length), (half, 0)]

    def depth(x, y):
        x = abs(x)
        if y < 0:
            return min(half - x, y + length)
        return min(radius - math.hypot(x, y), math.hypot(max(half - x, 0), y), y + length)  # the second: from the shoulder

    return list(dict.fromkeys(joints)), depth


def polygon(corners):
    """Of a convex one, anticlockwise."""
    sides = list(zip(corners, corners[1:] + corners[:1]))
    return corners, lambda x, y: min(((bx - ax) * (y - ay) - (by - ay) * (x - ax)) / math.hypot(bx - ax, by - ay)
                                     for (ax, ay), (bx, by) in sides)


def triangle(a, b, c):
    """The first side level, the centroid at the origin."""
    x = (a * a + b * b - c * c) / (2 * a)  # of the apex, from the right end to the left
    apex = (a - x, math.sqrt(b * b - x * x))
    middle = ((a + apex[0]) / 3, apex[1] / 3)
    return polygon([(px - middle[0], py - middle[1]) for px, py in ((0, 0), (a, 0), apex)])


# Keys, joints and depth, a place to start from.
TABLES = [
    ('kind = "rectangle"\nsize = [2, 1]', box(1, 0.5), (0.13, 0.21)),
    ('kind = "pool"\nlength = 2', box(1, 0.5), (-0.4, 0.07)),
    ('kind = "polygon"\nsides = 6\nside = 1', polygon([(-0.5, -H), (0.5, -H), (1, 0), (0.5, H), (-0.5, H), (-1, 0)]), (0.1, 0.23)),
    ('kind = "triangle"\nlengths = [1.5, 1.3, 1.1]', triangle(1.5, 1.3, 1.1), (0.02, 0.03)),
    ('kind = "stadium"\nradius = 1\nlength = 2',
     ([(-1, -1), (1, -1), (1, 1), (-1, 1)], lambda x, y: 1 - math.hypot(max(abs(x) - 1, 0), y)), (0.3, 0.1)),
    ('kind = "mushroom"\ncap_radius = 1\nstem_width = 0.75\nstem_length = 1', mushroom(1, 0.375, 1), (0.1, 0.3)),
    ('kind = "mushroom"\ncap_radius = 1\nstem_width = 2\nstem_length = 0.5', mushroom(1, 1, 0.5), (0.1, 0.3)),
    ('kind = "cardioid"\nscale = 1', ([(0, 0)], lambda x, y: 1 + math.cos(math.atan2(y, x)) - math.hypot(x, y)), (0.8, 0.3)),
]


def turned(p, angle):
    return math.cos(angle) * p[0] - math.sin(angle) * p[1], math.sin(angle) * p[0] + math.cos(angle) * p[1]


def rays(place, joints, angle):
    for joint in joints:
        dx, dy = (b - a for a, b in zip(place, turned(joint, angle)))
        length = math.hypot(dx, dy)
        for offset in OFFSETS:
            side = offset / length
            yield [(dx - side * dy) / length, (dy + side * dx) / length]


def main():
    head("table", "of radius", "rays", "stopped", "hits made", "least depth")
    for keys, (joints, depth), start in TABLES:
        cusp = "cardioid" in keys
        for radius, count in ((0, 1_000_000 if LONG else 20_000), (0.05, 100_000 if LONG else 20_000)):
            made, asked, least, number, stopped = 0, 0, math.inf, 0, 0
            for angle in (0, 0.7):
                place = turned(start, angle)
                text = f"[[table]]\n{keys}\nangle = {angle}\n[[ball]]\nposition = {list(place)}\nradius = {radius}\n"
                some = list(rays(place, joints, angle))
                number += len(some)
                out = folder("joints")
                carom("sweep", text, events=count, vary=f"ball.0.velocity={some}", out=out, final=True)
                for line in open(out / "runs.jsonl"):
                    ended = json.loads(line)
                    made += ended["events"]["ball_wall"]
                    pressed = cusp and radius == 0 and ended["stopped_by"] == "collapse"
                    stopped += pressed
                    asked += ended["events"]["ball_wall"] if pressed else count
                    at = turned(ended["final"][0]["position"], -angle)
                    least = min(least, depth(*at) - radius)
            name = " ".join(keys.replace('"', "").replace("kind = ", "").split("\n"))
            row(name, radius, number, stopped, made, f"{least:.0e}")
            within(f"hits in the {name}", made, asked, 0)
            within(f"depth in the {name}", min(least, 0), 0, 1e-11 if cusp else 1e-12)
            within(f"rays that stop in the {name}", max(stopped - 10, 0), 0, 0)
    end()


if __name__ == "__main__":
    main()
