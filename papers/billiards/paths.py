#!/usr/bin/env python3
"""Mean free paths: paths.py CAROM [--long]

Of a ball in a table with the area Q within reach of its centre and the boundary dQ: exactly pi |Q| / |dQ| in the plane, 4 |Q| / |dQ| in
space, whatever the shape [Chernov1997]. For a ball of radius R the walls are R nearer. 4e6 collisions of each, `--long` 4e7. Exit
status 1 if one is off by more than 4 standard errors or, with `--long`, by more than 5e-4 of it or 5e-4 itself.
"""
from study import *

PI = math.pi


def lorentz(spacing):
    table = f"""
        [[table]]
        kind = "lorentz"
        lattice = "triangular"
        spacing = {spacing}
        radius = 1
        [[ball]]
        position = [{spacing / 2}, 0.1]
        velocity = [0.6, 0.8]
        radius = 0
        """
    return table, (math.sqrt(3) * spacing**2 / 2 - PI) / 2


def stadium(radius):
    """Of half circles of radius 1, for a ball of this radius."""
    table = f"""
        [[table]]
        kind = "stadium"
        radius = 1
        length = 2
        [[ball]]
        position = [0.3, 0.1]
        velocity = [0.6, 0.8]
        radius = {radius}
        """
    r = 1 - radius
    return table, PI * (PI * r * r + 4 * r) / (2 * PI * r + 4)


def sinai(dimension, radius):
    """A ball of radius 0.1 that flies around a fixed one, in a periodic cell of side 1."""
    table = f"""
        dimension = {dimension}
        [space]
        kind = "periodic"
        lower = {[0] * dimension}
        upper = {[1] * dimension}
        [[ball]]
        position = {[0.1, 0.05, 0.02][:dimension]}
        velocity = {[0.6, 0.64, 0.48] if dimension == 3 else [0.6, 0.8]}
        radius = 0.1
        [[ball]]
        position = {[0.5] * dimension}
        radius = {radius - 0.1}
        fixed = true
        """
    if dimension == 2:
        return table, PI * (1 - PI * radius**2) / (2 * PI * radius)
    return table, 4 * (1 - 4 * PI / 3 * radius**3) / (4 * PI * radius**2)


TABLES = {"Lorentz gas, disks of radius 1, spacing 2.3": lorentz(2.3), "Lorentz gas, spacing 3": lorentz(3),
          "stadium, a point": stadium(0), "stadium, a disk of radius 0.25": stadium(0.25),
          "Sinai cell, 0.1 + 0.25": sinai(2, 0.35), "the same in space, 0.1 + 0.35": sinai(3, 0.45)}


def main():
    head("table", "collisions", "mean free path", "error", "exact", "off, relative")
    for name, (table, exact) in TABLES.items():
        count = 40_000_000 if LONG else 4_000_000
        path = run(table, "observe.mean_free_path=true", events=count)["observed"]["mean_free_path"]
        value, error = path["value"], path["error"]
        row(name, f"{count // 10**6}e6", f"{value:.6f}", f"{error:.6f}", f"{exact:.6f}", f"{value / exact - 1:+.1e}")
        within(name, value, exact, 5e-4 * min(1, exact) if LONG else math.inf, error)
    end()


if __name__ == "__main__":
    main()
