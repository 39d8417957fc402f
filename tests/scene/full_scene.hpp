#pragma once
// Scenes that the tests of reading start from.

#include <string>

#include "scene/reading.hpp"

namespace carom::testing {

/// Two balls in a box: the shortest scene of all tables that have no default.
inline const std::string small_scene = R"([[ball]]
position = [1, 1]
velocity = [1, 0]
[[ball]]
position = [3, 1]
[run]
until = 10
)";

/// Every key that a Scene has a place for; a line number is stated where a test asks for it.
inline const std::string full_scene = R"(title = "Every key – of a scene"
dimension = 2

[space]
kind = "box"
lower = [0, -1]
upper = ["20/3", 1e1]
restitution = 0.9

[motion]
acceleration = [0, -9.81]

[collision]
law = "restitution"
restitution = 0.8
contact_time = 0.0
simultaneous = "sequential"

[material.ivory]
restitution = 0.94
[material.rubber]
restitution = 0.5
[[material_pair]]
of = ["ivory", "rubber"]
restitution = 0.75

[[ball]]  # line 27
name = "cue"
position = [0.1, +2.50]
velocity = [3.0, 1_0.5e-1]
radius = "1/3"
mass = "inf"
material = "ivory"
fixed = false
[[ball]]
position = [
  4,   # é: columns count code points
  0x5,
]
fixed = true

[[lattice]]
kind = "hexagonal"
count = 72
packing_fraction = 0.70
radius = 0.25
mass = 2
material = "rubber"
temperature = 1.5
seed = 7
[[lattice]]
kind = "rack"
rows = 3
gap = 0.001
apex = [2, 2]
direction = [0, 1]
radius = 0.1

[[gas]]
count = 10_000
packing_fraction = 0.30
radius = 0.5
mass = 3.0
temperature = 2.0
material = "ivory"
seed = 9

[[wall]]
kind = "segment"
from = [0, 0]
to = [4, 3]
restitution = 0.6
velocity = [0, 1]
[[wall]]
kind = "plane"
point = [1, 0]
normal = [0, 1]
material = "rubber"
[[wall]]
kind = "circle"
centre = [5, 5]
radius = 4
side = "outside"
[[wall]]
kind = "polygon"
vertices = [[0, 0], [1, 0], [0, "1/7"]]

[run]
start = -1.0
until = 10.0
events = 1_000_000
sample_every = 0.1
seed = 5

[engine]
search = "cells"
queue = "heap"

[observe]
after = { events = 100000 }
pressure = true
collision_rate = true
mean_free_path = true
speed_histogram = true
lyapunov = { exponents = 3, every = 0.5, finite_time = 2.0 }
boundary_map = { file = "map.csv" }
poincare = { point = [1, 2], normal = [0, 1], file = "section.csv" }
wall_sequence = true
rotation_number = true
caustic = true
phase_space_portion = { bins = 50 }
diffusion = { every = 0.5, lags = 20, origins = 5 }
angle_autocorrelation = { every = 0.25 }

[output]
events = "events.csv"
trajectory = "trajectory.csv"
trajectory_frames = "events"
ledger = "ledger.csv"
)";

inline scene_text::Reading reading(const std::string& text, const std::vector<Override>& overrides = {}) {
  return scene_text::read_all(text, "test.toml", overrides);
}

/// The problems other than features that are not built.
inline std::vector<Problem> mistakes(std::vector<Problem> problems) {
  std::erase_if(problems, [](const Problem& p) { return p.what.find("not built yet") != std::string::npos; });
  return problems;
}

inline std::string listed(const std::vector<Problem>& problems) {
  std::string s;
  for (const Problem& p : problems) s += p.text() + "\n";
  return s;
}

}  // namespace carom::testing
