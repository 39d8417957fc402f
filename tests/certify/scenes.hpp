#pragma once
// Scenes to be proven.

#include <string>

#include "carom/certify/certify.hpp"
#include "carom/scene/read.hpp"
#include "sim/scenes.hpp"

namespace carom::testing {

[[nodiscard]] inline Scene scene_of(const std::string& toml) { return read_scene(toml, "scene.toml"); }

/// A photon among mirrors at all integer points: the hundred-digit challenge [Trefethen2002].
inline const char* const photon =
    "[space]\nkind = \"periodic\"\nlower = [-0.5, -0.5]\nupper = [0.5, 0.5]\n"
    "[[ball]]\nposition = [\"1/2\", \"1/10\"]\nvelocity = [1, 0]\nradius = 0\n"
    "[[ball]]\nposition = [0, 0]\nradius = \"1/3\"\nfixed = true\n[run]\nuntil = 10\n";

/// Walls of every kind, gravity, lossy impacts, a fixed ball, a point and two disks.
inline const char* const everything =
    "[space]\nkind = \"box\"\nlower = [0, 0]\nupper = [5, 4]\n[motion]\nacceleration = [0.1, -1]\n"
    "[collision]\nrestitution = \"9/10\"\n"
    "[[wall]]\nkind = \"segment\"\nfrom = [1, 1]\nto = [3, 2]\n"
    "[[wall]]\nkind = \"segment\"\nfrom = [4, 3]\nto = [3.5, 1]\nvelocity = [-0.01, 0.02]\nrestitution = 1\n"
    "[[wall]]\nkind = \"circle\"\ncentre = [1, 3]\nradius = 0.4\nside = \"outside\"\n"
    "[[wall]]\nkind = \"polygon\"\nvertices = [[2.1, 0.2], [2.6, 0.3], [2.3, 0.7]]\n"
    "[[ball]]\nposition = [0.5, 0.6]\nvelocity = [0.3, 0.777]\nradius = 0.1\n"
    "[[ball]]\nposition = [2, 2.5]\nvelocity = [-0.7, 0.31]\nradius = 0.15\nmass = 2\n"
    "[[ball]]\nposition = [3, 3.5]\nvelocity = [-0.7, 0.31]\nradius = 0\nmass = 2\n"
    "[[ball]]\nposition = [4, 0.5]\nradius = 0.2\nfixed = true\n[run]\nevents = 60\n";

/// Galperin's balls with a mass ratio of 100^n.
[[nodiscard]] inline std::string galperin(const std::string& ratio) {
  return "dimension = 1\n[[wall]]\nkind = \"plane\"\npoint = [0]\nnormal = [1]\n"
         "[[ball]]\nposition = [1]\nradius = 0\n[[ball]]\nposition = [2]\nvelocity = [-1]\nradius = 0\nmass = " +
         ratio + "\n[run]\nuntil = 100\n";
}

}  // namespace carom::testing
