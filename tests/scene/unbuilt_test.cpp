// Documented keys whose feature is not there are refused by name and line; none is ignored.

#include "scene/unbuilt.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "full_scene.hpp"

namespace carom {
namespace {

struct Asking {
  std::string key, value;  // as the table of unbuilt keys names them
  std::string text;        // appended to a good scene; the key stands on its last line
};

const std::vector<Asking> asking = {
    {"motion.magnetic", "", "[motion]\nmagnetic = 1.5"},
    {"motion.cloth", "", "[motion]\ncloth = { }"},
    {"motion.acceleration", "", "[motion]\nacceleration = [0, -1]"},
    {"collision.law", "rough", "[collision]\nlaw = \"rough\""},
    {"collision.law", "stick", "[collision]\nlaw = \"stick\""},
    {"collision.law", "merge", "[collision]\nlaw = \"merge\""},
    {"collision.contact_time", "", "[collision]\ncontact_time = 0.001"},
    {"collision.simultaneous", "symmetric", "[collision]\nsimultaneous = \"symmetric\""},
    {"collision.regularise", "", "[collision]\nregularise = \"rest\""},
    {"ball.spin", "", "[[ball]]\nposition = [5, 5]\nspin = 1.0"},
    {"ball.inertia", "", "[[ball]]\nposition = [5, 5]\ninertia = 0.4"},
    {"gas", "", "[[gas]]"},
    {"gas.radius_growth", "", "[[gas]]\ncount = 5\nradius = 0.1\npacking_fraction = 0.1\nradius_growth = 0.1"},
    {"wall.kind", "arc", "[[wall]]\nkind = \"arc\""},
    {"wall.kind", "ellipse", "[[wall]]\nkind = \"ellipse\""},
    {"wall.kind", "segment", "[[wall]]\nfrom = [0, 0]\nto = [1, 1]\nkind = \"segment\""},
    {"wall.kind", "polygon", "[[wall]]\nvertices = [[0, 0], [1, 0], [0, 1]]\nkind = \"polygon\""},
    {"wall.oscillation", "", "[[wall]]\nkind = \"plane\"\npoint = [0, 0]\nnormal = [0, 1]\noscillation = { amplitude = [0, 1] }"},
    {"wall.velocity", "plane", "[[wall]]\nkind = \"plane\"\npoint = [0, 0]\nnormal = [0, 1]\nvelocity = [0, 1]"},
    {"wall.velocity", "circle", "[[wall]]\nkind = \"circle\"\ncentre = [0, 0]\nradius = 1\nvelocity = [0, 1]"},
    {"wall.velocity", "segment", "[[wall]]\nkind = \"segment\"\nfrom = [0, 0]\nto = [1, 0]\nvelocity = [0, 1]"},
    {"wall.velocity", "polygon", "[[wall]]\nkind = \"polygon\"\nvertices = [[0, 0], [1, 0], [0, 1]]\nvelocity = [0, 1]"},
    {"table", "", "[[table]]"},
    {"engine.search", "cells", "[engine]\nsearch = \"cells\""},
    {"observe.after", "", "[observe]\nafter = { time = 1.0 }"},
    {"observe.pressure", "", "[observe]\npressure = true"},
    {"observe.collision_rate", "", "[observe]\ncollision_rate = true"},
    {"observe.mean_free_path", "", "[observe]\nmean_free_path = true"},
    {"observe.speed_histogram", "", "[observe]\nspeed_histogram = true"},
    {"observe.radial_distribution", "", "[observe]\nradial_distribution = true"},
    {"observe.mean_squared_displacement", "", "[observe]\nmean_squared_displacement = true"},
    {"observe.velocity_autocorrelation", "", "[observe]\nvelocity_autocorrelation = true"},
    {"observe.lyapunov", "", "[observe]\nlyapunov = { exponents = 2 }"},
    {"observe.boundary_map", "", "[observe]\nboundary_map = true"},
    {"observe.poincare", "", "[observe]\npoincare = true"},
    {"observe.survival", "", "[observe]\nsurvival = true"},
    {"observe.diffusion", "", "[observe]\ndiffusion = true"},
    {"space.kind", "periodic", "[space]\nlower = [0, 0]\nupper = [9, 9]\nkind = \"periodic\""},
};

TEST(Unbuilt, is_refused_by_name_and_line_as_long_as_it_is_not_there) {
  for (const Asking& a : asking) {
    const bool unbuilt = scene_text::is_unbuilt(a.key, a.value);
    const std::string text = testing::small_scene + a.text + "\n";
    const auto line = std::count(text.begin(), text.end(), '\n');
    const std::string words = scene_text::unbuilt_message(a.key, a.value);
    int named = 0;
    for (const Problem& p : testing::reading(text).problems) {
      if (p.what != words) continue;
      ++named;
      EXPECT_EQ(p.line, line) << p.text();
      EXPECT_EQ(p.file, "test.toml");
    }
    EXPECT_EQ(named, unbuilt ? 1 : 0) << words << "\n" << testing::listed(testing::reading(text).problems);
  }
}

TEST(Unbuilt, what_is_switched_off_is_not_asked_for) {
  const std::string off = R"([motion]
acceleration = [0, 0]
[collision]
contact_time = 0.0
simultaneous = "sequential"
[[wall]]
kind = "plane"
point = [0, 0]
normal = [0, 1]
velocity = [0, 0]
[engine]
search = "auto"
queue = "heap"
[observe]
pressure = false
[output]
trajectory = "run.csv"
)";
  EXPECT_TRUE(testing::reading(testing::small_scene + off).problems.empty())
      << testing::listed(testing::reading(testing::small_scene + off).problems);
}

TEST(Unbuilt, message_names_key_and_value) {
  EXPECT_EQ(scene_text::unbuilt_message("wall.kind", "arc"), "key wall.kind = \"arc\": not built yet");
  EXPECT_EQ(scene_text::unbuilt_message("motion.cloth"), "key motion.cloth: not built yet");
}

}  // namespace
}  // namespace carom
