// Scenes that are wrong, one mistake each: the line, and the words that must be in the message.

#include <filesystem>

#include <gtest/gtest.h>

#include "carom/scene/read.hpp"
#include "full_scene.hpp"

namespace carom {
namespace {

struct WrongScene {
  std::string name;
  std::string text;
  int line;  // 0: no line can be named
  std::vector<std::string> words;
};

// What a scene needs besides the mistake; two lines before the text of the table.
const std::string ball = "[[ball]]\nposition = [1, 1]\n";
const std::string run = "run.until = 1\n";                                            // one line
const std::string ok = run + ball;                                                    // three lines
const std::string box = "[space]\nkind = \"box\"\nlower = [0, 0]\nupper = [9, 9]\n";  // four lines
const std::string flat_wall = "[[wall]]\nkind = \"plane\"\npoint = [0, 0]\nnormal = [0, 1]\n";  // four lines
const std::string ivory = "[material.ivory]\nrestitution = 0.9\n";                    // two lines

const std::vector<WrongScene> wrong_scenes = {
    // Syntax
    {"unfinished_value", "run.until = \n", 1, {"not valid TOML"}},
    {"unclosed_string", ok + "name = \"cue\n", 4, {"not valid TOML"}},
    {"key_given_twice", ok + "position = [2, 2]\n", 4, {"position", "not valid TOML"}},
    {"table_given_twice", ok + "[space]\n[space]\n", 5, {"space", "not valid TOML"}},
    {"literal_too_large", ok + "radius = 1e400\n", 4, {"1e400", "string"}},
    {"not_utf8", ok + "name = \"\xff\"\n", 4, {"not valid TOML"}},
    {"endless_key", ok + "[a.b.c.d.e.f.g.h.i.j.k]\n", 4, {"too many dots"}},

    // Keys
    {"misspelt_key", ok + "velocty = [1, 0]\n", 4, {"unknown key \"velocty\" in ball.0", "Did you mean \"velocity\"?"}},
    {"swapped_letters", ok + "[run2]\n", 4, {"\"run2\" at the top", "Did you mean \"run\"?"}},
    {"misspelt_table", ok + "[colision]\n", 4, {"Did you mean \"collision\"?"}},
    {"key_far_from_any", ok + "zzzzzzzz = 1\n", 4, {"unknown key \"zzzzzzzz\"", "Known: ", "\"velocity\""}},
    {"unknown_key_in_material", ok + ivory + "bounce = 1\n", 6, {"\"bounce\" in material.ivory", "restitution"}},
    {"unknown_key_in_after", ok + "[observe]\nafter = { event = 3 }\n", 5, {"\"event\" in observe.after", "\"events\""}},
    {"key_of_another_wall",
     ok + "[[wall]]\nkind = \"plane\"\npoint = [0, 0]\nnormal = [0, 1]\ncentre = [0, 0]\n",
     8,
     {"wall.0.centre", "belongs to kind = \"circle\", not \"plane\""}},
    {"rows_without_rack",
     ok + box + "[[lattice]]\nkind = \"square\"\ncount = 4\nradius = 0.1\nrows = 3\n",
     12,
     {"lattice.0.rows", "\"rack\""}},

    // Fields and walls that move
    {"magnetic_in_space",
     "dimension = 3\n" + run + "[[ball]]\nposition = [1, 1, 1]\n[motion]\nmagnetic = 1\n",
     6,
     {"motion.magnetic needs dimension 2"}},
    {"magnetic_and_gravity",
     ok + "[motion]\nacceleration = [0, -1]\nmagnetic = 1\n",
     6,
     {"motion.magnetic", "motion.acceleration", "cycloids"}},
    {"wall_that_swings_in_a_field",
     ok + "[motion]\nmagnetic = 1\n" + flat_wall + "oscillation = { amplitude = [0, 1] }\n",
     10,
     {"wall.0.oscillation", "magnetic field"}},
    {"swing_without_amplitude", ok + flat_wall + "oscillation = { omega = 1 }\n", 8, {"amplitude is missing"}},
    {"swing_that_stands", ok + flat_wall + "oscillation = { amplitude = [0, 1], omega = 0 }\n", 8, {"omega is 0"}},
    {"swing_in_space",
     ok + flat_wall + "oscillation = { amplitude = [0, 1, 0] }\n",
     8,
     {"amplitude has 3 components"}},
    {"rest_on_a_swing",
     ok + "[collision]\nregularise = \"rest\"\n" + flat_wall + "oscillation = { amplitude = [0, 1] }\n",
     10,
     {"wall.0.oscillation", "rest"}},

    // Regularisation
    {"viscoelastic_without_speed",
     ok + "[collision]\nregularise = \"viscoelastic\"\n",
     4,
     {"collision.reference_speed is missing", "reference_speed = 1.0"}},
    {"reference_speed_without_viscoelastic",
     ok + "[collision]\nreference_speed = 2\n",
     5,
     {"collision.reference_speed has no meaning here", "viscoelastic"}},
    {"viscoelastic_and_plastic",
     ok + "[collision]\nregularise = \"viscoelastic\"\nreference_speed = 2\nrestitution = 0\n",
     7,
     {"collision.restitution is 0", "returns something"}},
    {"negative_contact_time", ok + "[collision]\ncontact_time = -1\n", 5, {"collision.contact_time is -1"}},
    {"rest_of_what_sticks",
     ok + "[collision]\nlaw = \"stick\"\nregularise = \"rest\"\n",
     6,
     {"collision.regularise", "balls that stick do not bounce"}},
    {"unknown_remedy", ok + "[collision]\nregularise = \"hope\"\n", 5, {"\"hope\"", "\"rest\""}},

    // Types
    {"table_as_number", "space = 3\n" + ok, 1, {"space is an integer", "a table is needed"}},
    {"array_as_table", run + "[ball]\nposition = [1, 1]\n", 2, {"ball is a table", "Write [[ball]]"}},
    {"table_as_array", ok + "[[space]]\n", 4, {"space is an array", "Write [space] once"}},
    {"array_of_numbers_for_balls", run + "ball = [1]\n", 2, {"ball.0 is an integer"}},
    {"vector_as_number", run + "[[ball]]\nposition = 1\n", 3, {"ball.0.position is an integer", "[0, 0]"}},
    {"vector_of_booleans", run + "[[ball]]\nposition = [true, 0]\n", 3, {"ball.0.position.0 is a boolean"}},
    {"empty_vector", ok + "velocity = []\n", 4, {"ball.0.velocity is empty"}},
    {"number_as_boolean", ok + "radius = false\n", 4, {"ball.0.radius is a boolean"}},
    {"number_as_date", ok + "radius = 2020-01-01\n", 4, {"ball.0.radius is a date"}},
    {"number_as_word", ok + "radius = \"large\"\n", 4, {"ball.0.radius is \"large\"", "1/3"}},
    {"division_by_zero", ok + "radius = \"1/0\"\n", 4, {"ball.0.radius is \"1/0\""}},
    {"string_too_large", ok + "radius = \"1e400\"\n", 4, {"ball.0.radius is 1e400", "double precision"}},
    {"exponent_beyond_all", ok + "radius = \"1e999999999\"\n", 4, {"double precision"}},
    {"number_too_long",
     ok + "radius = \"1/" + std::string(20000, '3') + "\"\n",
     4,
     {"ball.0.radius is a number of 20002 characters", "at most 10000"}},
    {"too_small", ok + "radius = 1e-320\n", 4, {"ball.0.radius is 1e-320", "double precision"}},
    {"count_as_decimal", "[run]\nevents = 1e6\n" + ball, 2, {"run.events is a number with a point", "Write 1000000"}},
    {"flag_as_number", ok + "fixed = 1\n", 4, {"ball.0.fixed is an integer", "true or false"}},
    {"name_as_number", ok + "name = 1\n", 4, {"ball.0.name is an integer", "a string is needed"}},
    {"word_as_number", ok + "[space]\nkind = 3\n", 5, {"space.kind is an integer"}},
    {"dimension_as_string", "dimension = \"2\"\n" + ok, 1, {"dimension is a string"}},

    // Ranges
    {"dimension_0", "dimension = 0\n" + ok, 1, {"dimension is 0", "1, 2 or 3"}},
    {"dimension_4", "dimension = 4\n" + ok, 1, {"dimension is 4"}},
    {"dimension_beyond_int", "dimension = 5000000000\n" + ok, 1, {"dimension is 5000000000"}},
    {"negative_mass", ok + "mass = -1\n", 4, {"ball.0.mass is -1", "above 0, or \"inf\""}},
    {"zero_mass", ok + "mass = 0.0\n", 4, {"ball.0.mass is 0.0"}},
    {"nan_mass", ok + "mass = nan\n", 4, {"ball.0.mass is nan"}},
    {"minus_infinite_mass", ok + "mass = -inf\n", 4, {"ball.0.mass is -inf"}},
    {"negative_radius", ok + "radius = -0.5\n", 4, {"ball.0.radius is -0.5"}},
    {"infinite_radius", ok + "radius = \"inf\"\n", 4, {"ball.0.radius is inf", "finite"}},
    {"nan_position", run + "[[ball]]\nposition = [nan, 0]\n", 3, {"ball.0.position has the component nan"}},
    {"infinite_velocity", ok + "velocity = [0, inf]\n", 4, {"ball.0.velocity has the component inf"}},
    {"too_many_components",
     run + "[[ball]]\nposition = [1, 2, 3]\n",
     3,
     {"ball.0.position has 3 components", "dimension 2", "Set dimension = 3?"}},
    {"too_few_components", ok + "velocity = [1]\n", 4, {"ball.0.velocity has 1 component "}},
    {"restitution_above_1", ok + "[collision]\nrestitution = 1.5\n", 5, {"collision.restitution is 1.5", "from 0"}},
    {"restitution_below_0", ok + box + "restitution = \"-1/2\"\n", 8, {"space.restitution is -1/2"}},
    {"material_restitution", ok + "[material.ivory]\nrestitution = 2\n", 5, {"material.ivory.restitution is 2"}},
    {"wall_restitution",
     ok + "[[wall]]\nkind = \"plane\"\npoint = [0, 0]\nnormal = [0, 1]\nrestitution = -0.1\n",
     8,
     {"wall.0.restitution is -0.1"}},
    {"negative_seed", "[run]\nuntil = 1\nseed = -1\n" + ball, 3, {"run.seed is -1"}},
    {"negative_count", run + box + "[[gas]]\ncount = -5\nradius = 0.1\n", 7, {"gas.0.count is -5"}},
    {"count_beyond_31_bits",
     run + box + "[[gas]]\ncount = 3_000_000_000\nradius = 0.1\n",
     7,
     {"gas.0.count is 3000000000"}},
    {"negative_events", "[run]\nevents = -1\n" + ball, 2, {"run.events is -1"}},
    {"zero_sample_every", "[run]\nuntil = 1\nsample_every = 0\n" + ball, 3, {"run.sample_every is 0"}},
    {"packing_above_1", run + box + "[[gas]]\ncount = 5\npacking_fraction = 1.5\n", 8, {"gas.0.packing_fraction is 1.5"}},
    {"negative_temperature",
     run + box + "[[gas]]\ncount = 5\nradius = 0.1\ntemperature = -1\n",
     9,
     {"gas.0.temperature is -1"}},
    {"infinite_mass_of_a_gas",
     run + box + "[[gas]]\ncount = 5\nradius = 0.1\nmass = inf\n",
     9,
     {"gas.0.mass is inf", "finite"}},

    // Words
    {"unknown_space",
     ok + "[space]\nkind = \"bx\"\nlower = [0, 0]\n",
     5,
     {"space.kind is \"bx\"", "\"open\", \"box\" or \"periodic\"", "Did you mean \"box\"?"}},
    {"unknown_law", ok + "[collision]\nlaw = \"sticky\"\n", 5, {"collision.law is \"sticky\"", "\"stick\""}},
    {"unknown_wall", ok + "[[wall]]\nkind = \"cube\"\nsize = 3\n", 5, {"wall.0.kind is \"cube\"", "\"polygon\""}},
    {"unknown_side",
     ok + "[[wall]]\nkind = \"circle\"\ncentre = [0, 0]\nradius = 3\nside = \"left\"\n",
     8,
     {"wall.0.side is \"left\"", "\"inside\" or \"outside\""}},
    {"unknown_lattice", ok + "[[lattice]]\nkind = \"bcc\"\n", 5, {"lattice.0.kind is \"bcc\"", "\"fcc\""}},
    {"unknown_queue", ok + "[engine]\nqueue = \"list\"\n", 5, {"engine.queue is \"list\"", "\"heap\""}},
    {"unknown_search", ok + "[engine]\nsearch = \"grid\"\n", 5, {"engine.search is \"grid\"", "\"cells\""}},
    {"unknown_simultaneous", ok + "[collision]\nsimultaneous = \"random\"\n", 5, {"\"random\"", "\"sequential\""}},
    {"unknown_trajectory", ok + "[output]\ntrajectory = \"run.dat\"\n", 5, {"output.trajectory", ".csv"}},

    // Missing
    {"no_end", ball, 0, {"the run has no end", "run.until or run.events"}},
    {"no_end_in_run", ball + "[run]\nseed = 3\n", 3, {"the run has no end", "Add until"}},
    {"no_balls", run, 0, {"the scene has no balls", "[[ball]]"}},
    {"no_position", run + "\n[[ball]]\nradius = 1\n", 3, {"ball.0.position is missing", "Add position = [1, 0]"}},
    {"box_without_lower", ok + "[space]\nkind = \"box\"\nupper = [1, 1]\n", 4, {"space.lower is missing"}},
    {"box_without_corners", ok + "[space]\nkind = \"box\"\n", 4, {"space.lower and space.upper are missing", "two corners"}},
    {"space_of_a_gas_that_brings_its_own", "[space]\nkind = \"periodic\"\n[[gas]]\ncount = 100\nradius = 0.5\npacking_fraction = 0.3\n[run]\nuntil = 1\n", 1,
     {"space.lower and space.upper are missing", "Leave out [space]"}},
    {"periodic_without_upper", ok + "[space]\nkind = \"periodic\"\nlower = [1, 1]\n", 4, {"space.upper is missing"}},
    {"wall_without_kind", ok + "[[wall]]\npoint = [0, 0]\n", 4, {"wall.0.kind is missing"}},
    {"plane_without_normal", ok + "[[wall]]\nkind = \"plane\"\npoint = [0, 0]\n", 4, {"wall.0.normal is missing"}},
    {"circle_without_radius", ok + "[[wall]]\nkind = \"circle\"\ncentre = [0, 0]\n", 4, {"wall.0.radius is missing"}},
    {"segment_without_to", ok + "[[wall]]\nkind = \"segment\"\nfrom = [0, 0]\n", 4, {"wall.0.to is missing"}},
    {"lattice_without_kind", ok + "[[lattice]]\ncount = 3\n", 4, {"lattice.0.kind is missing"}},
    {"lattice_without_size",
     ok + box + "[[lattice]]\nkind = \"square\"\ncount = 4\n",
     8,
     {"lattice.0.radius is missing", "packing_fraction"}},
    {"lattice_in_open_space",
     ok + "[[lattice]]\nkind = \"square\"\ncount = 4\nradius = 0.1\n",
     5,
     {"lattice.0.kind fills [space]", "open"}},
    {"rack_without_apex", ok + "[[lattice]]\nkind = \"rack\"\nradius = 0.1\n", 4, {"lattice.0.apex is missing"}},
    {"gas_without_size", run + box + "[[gas]]\ncount = 4\n", 6, {"gas.0.radius is missing"}},
    {"gas_without_space",
     run + "[[gas]]\ncount = 4\nradius = 0.1\n",
     2,
     {"gas.0.packing_fraction is missing", "without [space]"}},
    {"pair_of_one",
     ok + ivory + "[[material_pair]]\nof = [\"ivory\"]\nrestitution = 1\n",
     7,
     {"material_pair.0.of is not a pair"}},
    {"pair_without_of", ok + "[[material_pair]]\nrestitution = 1\n", 4, {"material_pair.0.of is missing"}},
    {"pair_without_restitution",
     ok + ivory + "[[material_pair]]\nof = [\"ivory\", \"ivory\"]\n",
     6,
     {"material_pair.0.restitution is missing"}},

    // What does not go together
    {"upper_below_lower",
     ok + "[space]\nkind = \"box\"\nlower = [0, 5]\nupper = [1, 5]\n",
     7,
     {"space.upper has the component 5", "space.lower"}},
    {"bounds_of_an_open_space", ok + "[space]\nlower = [0, 0]\n", 5, {"space.lower has no meaning", "kind = \"box\""}},
    {"faces_of_a_periodic_space",
     ok + "[space]\nkind = \"periodic\"\nlower = [0, 0]\nupper = [1, 1]\nrestitution = 1\n",
     8,
     {"space.restitution has no meaning"}},
    {"until_before_start", "[run]\nstart = 5\nuntil = 4.5\n" + ball, 3, {"run.until is 4.5", "before run.start = 5"}},
    {"material_not_defined",
     ok + "material = \"ivori\"\n" + ivory,
     4,
     {"ball.0.material is \"ivori\"", "Did you mean \"ivory\"?"}},
    {"material_without_any", ok + "material = \"ivory\"\n", 4, {"Add [material.ivory]"}},
    {"pair_not_defined",
     ok + ivory + "[[material_pair]]\nof = [\"ivory\", \"slate\"]\nrestitution = 1\n",
     7,
     {"material_pair.0.of names \"slate\""}},
    {"pair_twice",
     ok + ivory + "[material.slate]\n[[material_pair]]\nof = [\"ivory\", \"slate\"]\nrestitution = 1\n" +
         "[[material_pair]]\nof = [\"slate\", \"ivory\"]\nrestitution = 1\n",
     11,
     {"material_pair.1.of is given twice"}},
    {"name_twice",
     ok + "name = \"cue\"\n[[ball]]\nposition = [5, 5]\nname = \"cue\"\n",
     7,
     {"ball.1.name is \"cue\"", "ball 0 has the same name"}},
    {"fixed_ball_that_moves", ok + "velocity = [1, 0]\nfixed = true\n", 4, {"ball.0.velocity is not zero", "fixed"}},
    {"plane_without_direction",
     ok + "[[wall]]\nkind = \"plane\"\npoint = [0, 0]\nnormal = [0, 0.0]\n",
     7,
     {"wall.0.normal is zero"}},
    {"segment_of_no_length",
     ok + "[[wall]]\nkind = \"segment\"\nfrom = [1, 0]\nto = [1.0, 0]\n",
     7,
     {"wall.0.to is where"}},
    {"circle_of_no_size", ok + "[[wall]]\nkind = \"circle\"\ncentre = [0, 0]\nradius = 0\n", 7, {"wall.0.radius is 0"}},
    {"polygon_of_two",
     ok + "[[wall]]\nkind = \"polygon\"\nvertices = [[0, 0], [1, 0]]\n",
     6,
     {"wall.0.vertices has 2 points"}},
    {"polygon_closed_twice",
     ok + "[[wall]]\nkind = \"polygon\"\nvertices = [[0, 0], [1, 0],\n [0, 1], [0, 0]]\n",
     6,
     {"wall.0.vertices.0 is the point before it", "closes itself"}},
    {"polygon_with_a_flat_point",
     ok + "[[wall]]\nkind = \"polygon\"\nvertices = [[0, 0], [1, 0], [1]]\n",
     6,
     {"wall.0.vertices.2 has 1 component"}},
    {"square_lattice_in_3d",
     "dimension = 3\n" + run +
         "[space]\nkind = \"box\"\nlower = [0, 0, 0]\nupper = [1, 1, 1]\n[[lattice]]\nkind = \"square\"\n" +
         "count = 8\nradius = 0.1\n",
     8,
     {"lattice.0.kind is \"square\"", "dimension 2, the scene 3"}},
    {"arc_without_to_angle",
     ok + "[[wall]]\nkind = \"arc\"\ncentre = [0, 0]\nradius = 3\nfrom_angle = 0\n", 4, {"wall.0.to_angle is missing"}},
    {"arc_of_no_length",
     ok + "[[wall]]\nkind = \"arc\"\ncentre = [0, 0]\nradius = 3\nfrom_angle = 1\nto_angle = 1.0\n", 9,
     {"wall.0.to_angle", "begins"}},
    {"arc_of_more_than_a_turn",
     ok + "[[wall]]\nkind = \"arc\"\ncentre = [0, 0]\nradius = 3\nfrom_angle = 0\nto_angle = 7\n", 9,
     {"wall.0.to_angle", "more than a turn"}},
    {"ellipse_with_three_axes", ok + "[[wall]]\nkind = \"ellipse\"\ncentre = [0, 0]\naxes = [3, 2, 1]\n", 7,
     {"wall.0.axes has 3 numbers", "two semi-axes"}},
    {"ellipse_that_is_flat", ok + "[[wall]]\nkind = \"ellipse\"\ncentre = [0, 0]\naxes = [3, 0]\n", 7, {"wall.0.axes.1"}},
    {"parabola_without_width", ok + "[[wall]]\nkind = \"parabola\"\ncentre = [0, 0]\nfocal_length = 1\n", 4,
     {"wall.0.half_width is missing"}},
    {"curve_with_a_loop", ok + "[[wall]]\nkind = \"curve\"\ncentre = [0, 0]\ncosines = [1, 2]\n", 7,
     {"wall.0.cosines make r(3.14", "nowhere below 0"}},
    {"curve_with_an_idle_sine", ok + "[[wall]]\nkind = \"curve\"\ncentre = [0, 0]\ncosines = [3]\nsines = [1]\n", 8,
     {"wall.0.sines.0 is not 0"}},
    {"ellipse_with_a_radius", ok + "[[wall]]\nkind = \"ellipse\"\ncentre = [0, 0]\naxes = [9, 9]\nradius = 9\n", 8,
     {"radius", "circle"}},
    {"arc_in_3d",
     "dimension = 3\n[run]\nuntil = 1\n[[ball]]\nposition = [0, 0, 0]\n[[wall]]\nkind = \"ellipse\"\ncentre = [0, 0, 0]\n"
     "axes = [9, 9]\n", 7, {"wall.0.kind is \"ellipse\"", "dimension 2"}},
    {"segment_in_3d",
     "dimension = 3\n" + run +
         "[[ball]]\nposition = [0, 0, 0]\n[[wall]]\nkind = \"segment\"\nfrom = [0, 0, 0]\nto = [1, 0, 0]\n",
     6,
     {"wall.0.kind is \"segment\"", "dimension 2"}},
    {"circle_in_1d",
     "dimension = 1\n" + run + "[[ball]]\nposition = [0]\n[[wall]]\nkind = \"circle\"\ncentre = [0]\nradius = 1\n",
     6,
     {"wall.0.kind is \"circle\"", "2 or 3"}},
    {"rack_without_rows",
     ok + "[[lattice]]\nkind = \"rack\"\nradius = 0.1\napex = [5, 5]\nrows = 0\n",
     8,
     {"lattice.0.rows is 0"}},
    {"rack_with_count",
     ok + "[[lattice]]\nkind = \"rack\"\nradius = 0.1\napex = [5, 5]\ncount = 15\n",
     8,
     {"lattice.0.count is 15"}},
    {"rack_with_negative_gap",
     ok + "[[lattice]]\nkind = \"rack\"\nradius = 0.1\napex = [5, 5]\ngap = -1\n",
     8,
     {"lattice.0.gap is -1"}},
    {"after_twice", ok + "[observe]\nafter = { events = 3, time = 1.0 }\n", 5, {"observe.after has events and time"}},
    {"after_negative", ok + "[observe]\nafter = { events = -3 }\n", 5, {"observe.after.events is -3"}},
    {"no_exponents", ok + "[observe]\nlyapunov = { exponents = 0 }\n", 5, {"observe.lyapunov.exponents is 0"}},
    {"no_time_between", ok + "[observe]\nlyapunov = { every = 0.0 }\n", 5, {"observe.lyapunov.every", "orthonormalisations"}},
    {"section_without_normal", ok + "[observe]\npoincare = { point = [0, 0] }\n", 5, {"observe.poincare.normal"}},
    {"section_across_nothing",
     ok + "[observe]\npoincare = { point = [0, 0], normal = [0, 0] }\n",
     5,
     {"observe.poincare.normal is zero"}},
    {"one_bin", ok + "[observe]\nphase_space_portion = { bins = 1 }\n", 5, {"observe.phase_space_portion.bins is 1"}},
    {"one_lag", ok + "[observe]\ndiffusion = { lags = 1 }\n", 5, {"observe.diffusion.lags is 1"}},
    {"unknown_key_in_map", ok + "[observe]\nboundary_map = { name = \"b.csv\" }\n", 5, {"\"name\" in observe.boundary_map"}},
    {"one_file_for_two",
     ok + "[output]\nevents = \"a.csv\"\ntrajectory = \"a.csv\"\n",
     6,
     {"output.trajectory", "same name"}},
};

TEST(WrongScenes, each_has_one_problem_with_its_line_and_words) {
  for (const WrongScene& w : wrong_scenes) {
    SCOPED_TRACE(w.name);
    const std::vector<Problem> problems = testing::mistakes(testing::reading(w.text).problems);
    ASSERT_EQ(problems.size(), 1u) << testing::listed(problems);
    EXPECT_EQ(problems[0].file, "test.toml");
    EXPECT_EQ(problems[0].line, w.line) << problems[0].text();
    for (const std::string& words : w.words) {
      EXPECT_NE(problems[0].text().find(words), std::string::npos) << words << "\n" << problems[0].text();
    }
    EXPECT_THROW((void)read_scene(w.text, "test.toml"), InputError);
  }
}

TEST(WrongScenes, several_problems_are_reported_at_once_in_the_order_of_lines) {
  const std::string text = R"(dimension = 2
[space]
kind = "box"
lower = [0, 0]
[[ball]]
position = [1, 1, 1]
mass = -1
velocty = [1, 0]
[[ball]]
radius = "big"
material = "ivory"
[run]
start = 3
until = 2
)";
  try {
    (void)read_scene(text, "break.toml");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    std::vector<int> lines;
    for (const Problem& p : error.problems()) lines.push_back(p.line);
    EXPECT_EQ(lines, (std::vector<int>{2, 6, 7, 8, 9, 10, 11, 14})) << error.what();
    EXPECT_NE(std::string(error.what()).find("break.toml:7: ball.0.mass is -1 (a mass is above 0, or \"inf\").\n"),
              std::string::npos);
  }
}

TEST(WrongScenes, a_key_that_could_not_be_read_is_not_judged_too) {
  // Wrong until and wrong lower: no word about a missing end, a missing lower or an upper that is too low.
  const std::string text = ball + "[run]\nuntil = \"soon\"\n[space]\nkind = \"box\"\nlower = [\"x\", 0]\nupper = [-1, 1]\n";
  const std::vector<Problem> problems = testing::reading(text).problems;
  ASSERT_EQ(problems.size(), 2u) << testing::listed(problems);
  EXPECT_EQ(problems[0].line, 4);
  EXPECT_EQ(problems[1].line, 7);
}

TEST(WrongScenes, a_file_that_cannot_be_read_is_named) {
  for (const std::string& path : {std::string("/nowhere/at/all.toml"), std::filesystem::temp_directory_path().string()}) {
    try {
      (void)read_scene_file(path);
      FAIL() << path;
    } catch (const InputError& error) {
      ASSERT_EQ(error.problems().size(), 1u);
      EXPECT_NE(std::string(error.what()).find("cannot read the scene file \"" + path + "\""), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace carom
