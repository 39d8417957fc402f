"""check_h5md.py FILE [contacts]: what H5MD 1.1 demands of FILE, and what carom promises beyond it.

With `contacts`, each frame that follows a collision must show two balls, or a ball and a face of the box, whose surfaces
touch to 1e-14 of a ball's diameter.
"""

import sys

import h5py
import numpy


def check_strings(attribute):
    """Strings are of fixed length."""
    info = h5py.check_string_dtype(attribute.dtype)
    assert info is not None and info.length is not None, attribute


def check_element(group, frames):
    """An element in time: steps, times, and a first dimension that matches them."""
    step, time, value = group["step"], group["time"], group["value"]
    assert step.dtype.kind == "i" and step.shape == (frames,)
    assert time.dtype.kind == "f" and time.shape == (frames,)
    assert value.shape[0] == frames, (group.name, value.shape)
    assert value.chunks is not None and value.maxshape[0] is None
    assert (numpy.diff(step[:]) > 0).all() and (numpy.diff(time[:]) >= 0).all()


def check_file(f):
    assert list(f["h5md"].attrs["version"]) == [1, 1]
    for group, name in (("author", "name"), ("creator", "name"), ("creator", "version")):
        check_strings(f["h5md"][group].attrs.get_id(name))
    assert f["h5md/creator"].attrs["name"] == b"carom" or f["h5md/creator"].attrs["name"] == "carom"

    balls = f["particles/all"]
    position = balls["position"]
    frames, count, dimension = position["value"].shape
    for name in ("position", "velocity", "image", "id"):
        if name in balls:
            check_element(balls[name], frames)
            assert balls[name]["step"] == position["step"] and balls[name]["time"] == position["time"], "hard links"
    box = balls["box"]
    assert box.attrs["dimension"] == dimension
    assert box.attrs["boundary"].shape == (dimension,)
    check_strings(box.attrs.get_id("boundary"))
    periodic = all(b.decode() == "periodic" for b in box.attrs["boundary"])
    assert periodic or all(b.decode() == "none" for b in box.attrs["boundary"])
    if periodic:
        assert box["edges"].shape == (dimension,)
        assert balls["image"]["value"].shape == position["value"].shape
        inside = position["value"][:] - box["lower"][:]
        assert ((inside >= 0) & (inside < box["edges"][:])).all()
    if "id" not in balls:
        for name in ("mass", "radius", "species"):
            assert balls[name].shape == (count,)
        assert balls["species"].dtype.kind == "i"
    for name in f["observables"]:
        check_element(f["observables"][name], frames)
    assert f["observables/momentum/value"].shape == (frames, dimension)
    return frames


def closest(balls, frame, periodic):
    """The size of the smallest gap between two surfaces, over the largest diameter."""
    x, r = balls["position/value"][frame], balls["radius"][:]
    box = balls["box"]
    d = x[:, None, :] - x[None, :, :]
    if periodic:
        edges = box["edges"][:]
        d -= edges * numpy.round(d / edges)
    gap = numpy.sqrt((d**2).sum(axis=2)) - (r[:, None] + r[None, :])
    gaps = [numpy.abs(gap[numpy.triu_indices(len(r), 1)])]
    if not periodic and "edges" in box:
        gaps.append(numpy.abs(x - box["lower"][:] - r[:, None]).ravel())
        gaps.append(numpy.abs(box["lower"][:] + box["edges"][:] - x - r[:, None]).ravel())
    return numpy.concatenate(gaps).min() / (2 * r.max())


def check_contacts(f):
    balls = f["particles/all"]
    periodic = balls["box"].attrs["boundary"][0] == b"periodic"
    collisions = f["observables/collisions/value"][:]
    after = numpy.flatnonzero(numpy.diff(collisions)) + 1
    assert len(after) == collisions[-1], "a frame for each collision"
    worst = max(closest(balls, k, periodic) for k in after)
    assert worst < 1e-14, worst
    return len(after)


with h5py.File(sys.argv[1], "r") as file:
    print(check_file(file), "frames")
    if "contacts" in sys.argv[2:]:
        print(check_contacts(file), "contacts")
