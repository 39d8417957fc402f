// What is said of an engine and a scene, and what is refused.

#include <gmock/gmock.h>

#include "carom/core/error.hpp"
#include "engine_runs.hpp"
#include "game_engine/layout.hpp"
#include "game_engine/sphere_mesh.hpp"

namespace carom {
namespace {

using test::scene_of;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const std::string ball = "run.until = 1\n[[ball]]\nposition = [1, 1]\nvelocity = [3, 4]\n";

std::vector<std::string> said(const std::string& scene, const std::string& engine) {
  return cannot_represent(scene_of(scene), engine);
}
std::vector<std::string> refused(const std::string& scene, const std::string& engine) {
  return refuses(scene_of(scene), engine);
}

TEST(Limits, refuse_what_an_engine_does_not_have) {
  for (const GameEngine& e : game_engines()) {
    EXPECT_THAT(refused(ball, e.name), IsEmpty());
    EXPECT_THAT(refused(ball + "[space]\nkind = \"periodic\"\nlower = [0, 0]\nupper = [5, 5]\n", e.name),
                ElementsAre(HasSubstr("no periodic space")));
    EXPECT_THAT(refused(ball + "[collision]\nlaw = \"stick\"\n", e.name), ElementsAre(HasSubstr("no law \"stick\"")));
    EXPECT_THAT(refused(ball + "[collision]\nlaw = \"merge\"\n", e.name), ElementsAre(HasSubstr("no law \"merge\"")));
    EXPECT_THAT(refused(ball + "[[ball]]\nposition = [3, 3]\nradius = 0\n", e.name),
                ElementsAre(HasSubstr("no balls of radius 0")));
    EXPECT_THAT(refused(ball + "[[ball]]\nposition = [1e15, 3]\n", e.name), ElementsAre(HasSubstr("too large")));
    EXPECT_THAT(refused("run.until = 1\n[[ball]]\nposition = [1, 1]\n[[ball]]\nposition = [9, 3]\nmass = 1e-30\n", e.name),
                ElementsAre(HasSubstr("A mass of 1e-30 is too far")));
    EXPECT_THAT(refused("run.until = 1e-6\n[[ball]]\nposition = [9, 3]\nvelocity = [2e18, 0]\n", e.name),
                ElementsAre(HasSubstr(e.name == "chipmunk" ? "Speeds of 2e+18 are too large for Chipmunk" : "Speeds of")));
  }
}

TEST(Limits, refuse_curved_walls_and_openings) {
  const std::string walls = ball + "[[wall]]\nkind = \"segment\"\nfrom = [-9, 9]\nto = [9, 9]\nopening = true\n" +
                            "[[wall]]\nkind = \"ellipse\"\ncentre = [0, 0]\naxes = [8, 7]\n" +
                            "[[wall]]\nkind = \"arc\"\ncentre = [0, 0]\nradius = 20\nfrom_angle = 0\nto_angle = 3\n" +
                            "[[wall]]\nkind = \"circle\"\ncentre = [0, 0]\nradius = 30\n";
  for (const GameEngine& e : game_engines())
    EXPECT_THAT(refused(walls, e.name), ElementsAre(HasSubstr("wall 2 is an arc"), HasSubstr("wall 1 is an ellipse"),
                                                    HasSubstr("wall 0 is an opening")));
}

TEST(Limits, refuse_space_in_the_plane) {
  const std::string scene = "dimension = 3\nrun.until = 1\n[[ball]]\nposition = [0, 0, 0]\n";
  EXPECT_THAT(refused(scene, "box2d"), ElementsAre("Box2D is 2-dimensional, and the scene has 3 dimensions."));
  EXPECT_THAT(refused(scene, "chipmunk"), ElementsAre(HasSubstr("Chipmunk is 2-dimensional")));
  EXPECT_THAT(refused(scene, "bullet"), IsEmpty());
}

TEST(Limits, say_of_a_refused_scene_why_alone) {
  const std::string scene = ball + "[collision]\nlaw = \"stick\"\n";
  EXPECT_EQ(said(scene, "bullet"), refused(scene, "bullet"));
}

// Radius 0.5 is 0.5 m; a step of 2 / 5 s moves the ball at speed 5 by 2 m.
TEST(Limits, are_in_the_users_units) {
  EXPECT_THAT(said(ball, "box2d"), Contains(HasSubstr("more slowly than 1 (1 m/s)")));
  EXPECT_THAT(said(ball, "box2d"),
              Contains(HasSubstr("more than 2 (2 m) in a step, and slows down for good what is faster: "
                                 "the fastest of the start needs a step of at most 0.4")));
  EXPECT_THAT(said(ball, "chipmunk"), Contains(HasSubstr("up to 0.003125 (0.1)")));
  // Radius 1/128 is 0.5 m: a metre is 1/64.
  const std::string small = "run.until = 1\n[[ball]]\nposition = [1, 1]\nradius = \"1/128\"\n";
  EXPECT_THAT(said(small, "box2d"), Contains(HasSubstr("more slowly than 0.01562 (1 m/s)")));
  EXPECT_THAT(said(small, "bullet"), Contains(HasSubstr("slower than 0.0125 (0.8 m/s)")));
}

TEST(Limits, are_said_where_they_matter) {
  EXPECT_THAT(said(ball, "box2d"), Not(Contains(HasSubstr("semi-implicit"))));
  EXPECT_THAT(said(ball + "[motion]\nacceleration = [0, -1]\n", "box2d"), Contains(HasSubstr("semi-implicit")));
  EXPECT_THAT(said(ball, "box2d"), Not(Contains(HasSubstr("between two balls"))));
  EXPECT_THAT(said(ball + "[[ball]]\nposition = [4, 4]\n", "box2d"), Contains(HasSubstr("between two balls")));
  EXPECT_THAT(said(ball + "[collision]\nrestitution = 0\n", "bullet"), Not(Contains(HasSubstr("restitution 0"))));
  EXPECT_THAT(said(ball + "[[ball]]\nposition = [9, 9]\nmass = \"inf\"\nvelocity = [1, 0]\n", "chipmunk"),
              Contains(HasSubstr("infinite mass")));
  EXPECT_THAT(said(ball + "[[wall]]\nkind = \"segment\"\nfrom = [4, 0]\nto = [4, 3]\n", "box2d"),
              Contains(HasSubstr("thicker by 0.01 (0.01 m)")));
  EXPECT_THAT(
      said(ball + "[[ball]]\nposition = [9, 30]\nradius = 20\n[[ball]]\nposition = [60, 30]\nradius = 20\n", "bullet"),
      Contains(HasSubstr("is made for radii")));
}

// A circle of radius 5 from inside in Box2D: 71 edges, whose middles lie 5 (1 - cos(pi/71)) = 0.0049 inside.
TEST(Limits, say_how_fine_a_circle_is) {
  const std::string scene = ball + "[[wall]]\nkind = \"circle\"\ncentre = [0, 0]\nradius = 5\nside = \"inside\"\n";
  EXPECT_THAT(said(scene, "box2d"), Contains("Wall 0, a circle from inside, is 71 straight edges in Box2D, up to 0.004894 "
                                             "inside of it."));
  EXPECT_THAT(said(scene, "chipmunk"), Contains(HasSubstr("is 89 straight edges in Chipmunk, up to 0.003115 inside")));
}

TEST(Limits, need_a_known_engine_and_a_sound_scene) {
  EXPECT_THROW((void)said(ball, "havok"), InputError);
  EXPECT_THROW((void)said(ball + "[[ball]]\nposition = [1.2, 1]\n", "box2d"), InputError);
}

TEST(MakeGameEngine, lists_all_that_is_wrong) {
  GameEngineOptions options{"chipmunk", -1.0, true, false, 0.5};
  try {
    (void)make_game_engine(scene_of(ball + "[collision]\nlaw = \"stick\"\n"), options);
    FAIL();
  } catch (const InputError& error) {
    for (const char* part : {"a time step of -1", "no continuous collision detection", "no threshold", "no law \"stick\""})
      EXPECT_THAT(error.what(), HasSubstr(part));
  }
  for (const double dt : {0.0, -0.1, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    for (const std::string& engine : test::built_engines())
      EXPECT_THROW((void)make_game_engine(scene_of(ball), {engine, dt}), InputError) << dt;
}

TEST(RingEdges, lie_within_the_depth_asked_for) {
  for (const double radius : {0.2, 1.0, 7.0, 100.0, 2000.0}) {
    const int n = game_engine::ring_edges(radius, 0.005);
    EXPECT_LE(game_engine::ring_depth(radius, n), 0.005 * (1 + 1e-9)) << radius;
    if (n > 64) {
      EXPECT_GT(game_engine::ring_depth(radius, n - 1), 0.005 * (1 - 1e-9)) << radius;
    }
  }
  EXPECT_EQ(game_engine::ring_edges(1e9, 0.005), 4096);
}

// Of the icosahedron itself: the distance of its faces, 1 - phi^2 / (sqrt(3) sqrt(phi sqrt(5))) = 0.2053; each level about
// a quarter of the last.
TEST(SphereMesh, lies_within_its_depth) {
  EXPECT_EQ(game_engine::unit_sphere_triangles(2).size(), 320U);
  EXPECT_NEAR(game_engine::sphere_mesh_depth(0), 0.2053, 1e-4);
  for (int level = 1; level <= 5; ++level)
    EXPECT_NEAR(game_engine::sphere_mesh_depth(level) / game_engine::sphere_mesh_depth(level - 1), 0.29, 0.04) << level;
  for (const game_engine::Triangle& t : game_engine::unit_sphere_triangles(3))
    for (const game_engine::Point& corner : t) EXPECT_NEAR(game_engine::norm(corner), 1, 1e-15);
}

}  // namespace
}  // namespace carom
