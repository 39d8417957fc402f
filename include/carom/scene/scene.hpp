#pragma once
// What the user wrote: plain structs, one a table of the scene file (or filled in code), copied into a world.
// Lengths, times and masses are in one coherent set of units of the user's choice.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "carom/core/number.hpp"

namespace carom {

/// A vector of the scene: as many components as the scene has dimensions.
using Coordinates = std::vector<Number>;

/// Where in the scene file something stands.
struct Where {
  int line = 0;  ///< 1-based; 0: set in code or by --set
};

enum class SpaceKind : std::uint8_t { open, box, periodic };

struct SpaceSpec {
  SpaceKind kind = SpaceKind::open;    ///< DEFAULT: open
  Coordinates lower{};                   ///< [length] box, periodic: the smallest coordinates
  Coordinates upper{};                   ///< [length] box, periodic: the largest coordinates
  std::optional<Number> restitution{};   ///< e of the faces [-], 0..1. DEFAULT: from the materials, else [collision]
  std::string material{};                ///< of the faces. DEFAULT: none
  Where where{};
};

struct MotionSpec {
  Coordinates acceleration{};  ///< [length/time^2] uniform, on every ball that is not fixed. DEFAULT: none
  std::optional<Number> magnetic{};  ///< [rad/time] 2-D: cyclotron frequency of every ball that is not fixed, > 0
                                     ///< anticlockwise. DEFAULT: none
  Where where{};
};

enum class LawKind : std::uint8_t { restitution, stick, merge };

/// What becomes of contacts at one instant: pair by pair in the order of events until all part, or all at once.
enum class Simultaneous : std::uint8_t { sequential, symmetric };

/// What is done about infinitely many impacts in finite time.
enum class Regularise : std::uint8_t { stop, rest, viscoelastic };

struct CollisionSpec {
  LawKind law = LawKind::restitution;         ///< DEFAULT: restitution
  Number restitution = 1.0;                   ///< e [-], 0..1. DEFAULT: 1 (elastic)
  Simultaneous simultaneous = Simultaneous::sequential;  ///< DEFAULT: sequential
  Number contact_time = 0.0;                  ///< [time], >= 0: t_c of the TC model. DEFAULT: 0 (off)
  Regularise regularise = Regularise::stop;   ///< DEFAULT: the run stops
  std::optional<Number> reference_speed{};    ///< [length/time], > 0: viscoelastic: where restitution holds as given
  Where where{};
};

struct MaterialSpec {
  std::string name{};
  Number restitution = 1.0;  ///< e [-], 0..1
  Where where{};
};

struct MaterialPairSpec {
  std::string first{}, second{};
  Number restitution = 1.0;  ///< e [-], 0..1
  Where where{};
};

struct BallSpec {
  std::string name{};       ///< DEFAULT: none
  Coordinates position{};   ///< [length]
  Coordinates velocity{};   ///< [length/time]. DEFAULT: zero
  Number radius = 0.5;    ///< [length], >= 0; 0 is a point particle. DEFAULT: 0.5
  Number mass = 1.0;      ///< [mass], > 0 or inf (keeps its velocity). DEFAULT: 1
  std::string material{};   ///< DEFAULT: none
  bool fixed = false;     ///< never moves: infinite mass, zero velocity. DEFAULT: false
  Number radius_growth = 0.0;  ///< [length/time], >= 0: the radius grows from the run's start. DEFAULT: 0
  Where where{};
};

enum class LatticeKind : std::uint8_t { chain, square, hexagonal, cubic, fcc, rack };

/// Balls on a lattice that fills [space]; a rack is a triangle of rows of touching (or gapped) balls.
struct LatticeSpec {
  LatticeKind kind = LatticeKind::square;
  std::int64_t count = 0;                    ///< balls; rack: follows from rows
  std::optional<Number> packing_fraction{};    ///< [-] sets the radius where none is given
  std::optional<Number> radius{};              ///< [length]
  Number mass = 1.0;                         ///< [mass] DEFAULT: 1
  std::string material{};                      ///< DEFAULT: none
  std::optional<Number> temperature{};         ///< k_B T [energy]. DEFAULT: at rest
  std::uint64_t seed = 1;                    ///< of the velocities. DEFAULT: 1
  Number radius_growth = 0.0;                ///< [length/time], >= 0, from the run's start. DEFAULT: 0
  int rows = 5;                              ///< rack: rows. DEFAULT: 5 (15 balls)
  Number gap = 0.0;                          ///< rack: [length] between neighbours, >= 0. DEFAULT: 0
  Coordinates apex{};                          ///< rack: [length] centre of the first ball
  Coordinates direction{};                     ///< rack: from the apex to the last row. DEFAULT: [1, 0]
  Where where{};
};

/// Balls placed without overlap, with Maxwell velocities and zero total momentum, or with one speed; where the space is open
/// and there are closed tables, inside those.
struct GasSpec {
  std::int64_t count = 0;
  std::optional<Number> packing_fraction{};  ///< [-] this entry's own share of the space
  std::optional<Number> radius{};            ///< [length]
  Number mass = 1.0;                       ///< [mass] DEFAULT: 1
  Number temperature = 1.0;                ///< k_B T [energy], exact for the sample. DEFAULT: 1
  std::optional<Number> speed{};           ///< [length/time] of every ball, its direction drawn. DEFAULT: as the temperature says
  std::string material{};                    ///< DEFAULT: none
  std::uint64_t seed = 1;                  ///< DEFAULT: 1
  Number radius_growth = 0.0;              ///< [length/time], >= 0, from the run's start. DEFAULT: 0
  Where where{};
};

enum class WallKind : std::uint8_t { segment, plane, circle, polygon, arc, ellipse, parabola, curve };
enum class WallSide : std::uint8_t { inside, outside };

/// A wall that swings about its place: displaced by amplitude sin(omega t + phase).
struct OscillationSpec {
  Coordinates amplitude{};  ///< [length]
  Number omega = 1.0;       ///< [rad/time], > 0
  Number phase = 0.0;       ///< [rad] DEFAULT: 0
};

/// A ball touches a wall at a distance equal to its radius.
struct WallSpec {
  WallKind kind = WallKind::plane;
  Coordinates from{}, to{};              ///< segment, arc: its ends; arc: DEFAULT as its angles say [length]
  Coordinates point{}, normal{};         ///< plane: [length], and the side on which balls stay
  Coordinates centre{};                  ///< circle (sphere in 3-D), arc, ellipse, curve; parabola: its vertex [length]
  Number radius = 1.0;                   ///< circle, arc: [length], > 0
  WallSide side = WallSide::inside;      ///< circle, ellipse, curve: where the balls are. DEFAULT: inside
  Number from_angle = 0.0, to_angle = 0.0;  ///< arc: [rad], anticlockwise from the one to the other; balls on both sides
  std::vector<Number> axes{};            ///< ellipse: semi-axes [length], > 0
  Number angle = 0.0;                    ///< ellipse, parabola, curve: turned by, anticlockwise [rad]. DEFAULT: 0
  Number focal_length = 1.0;             ///< parabola: y^2 = 4 f x before it is turned [length], > 0; balls on both sides
  Number half_width = 1.0;               ///< parabola: |y| at its ends [length], > 0
  std::vector<Number> cosines{}, sines{};  ///< curve: r(theta) = sum of cosines[k] cos k theta + sines[k] sin k theta [length]
  std::vector<Coordinates> vertices{};   ///< polygon: closed [length]
  bool opening = false;                  ///< a gap: balls whose centre comes to it leave, and are counted. DEFAULT: false
  Coordinates velocity{};                ///< [length/time] DEFAULT: at rest
  std::optional<OscillationSpec> oscillation{};  ///< DEFAULT: none
  std::optional<Number> restitution{};   ///< e [-], 0..1. DEFAULT: from the materials, else [collision]
  std::string material{};                ///< DEFAULT: none
  int table = -1;                        ///< the [[table]] that it is a piece of; -1: none
  Where where{};
};

enum class TableKind : std::uint8_t {
  rectangle, circle, ellipse, stadium, mushroom, sinai, lorentz, polygon, triangle, wedge, cardioid, pinball, annulus, cradle, pool
};
enum class TableLattice : std::uint8_t { triangular, square };

/// A ready-made set of walls (and, for some kinds, a space): see carom/scene/tables.hpp for the pieces of each kind.
struct TableSpec {
  TableKind kind = TableKind::rectangle;
  Coordinates centre{};        ///< [length] DEFAULT: the origin
  Number angle = 0.0;          ///< turned by, anticlockwise about its centre [rad]. DEFAULT: 0; wedge: see `opening_angle`
  Coordinates size{};          ///< rectangle, sinai: width and height [length]
  Number radius = 1.0;         ///< circle, stadium, sinai, lorentz, pinball, cradle (of a ball) [length], > 0
  Number length = 1.0;         ///< stadium: of the straight parts; wedge: of a side; pool: of the long side [length]
  std::vector<Number> axes{};  ///< ellipse: semi-axes [length]
  Number cap_radius = 1.0, stem_width = 0.5, stem_length = 1.0;  ///< mushroom [length]
  std::int64_t sides = 3;      ///< polygon
  Number side = 1.0;           ///< polygon: length of a side [length]
  std::vector<Number> lengths{};  ///< triangle: its three sides [length]
  Number opening_angle = 1.0;  ///< wedge: between its two sides [rad]; written `angle`
  TableLattice lattice = TableLattice::triangular;  ///< lorentz
  Number spacing = 2.5;        ///< lorentz, pinball: of the centres [length]
  Number inner = 0.5, outer = 1.0;  ///< annulus: radii [length]
  Number offset = 0.0;         ///< annulus: of the inner circle's centre [length]. DEFAULT: 0
  Number scale = 1.0;          ///< cardioid: r = scale (1 + cos theta) [length]
  std::int64_t count = 5;      ///< cradle: balls
  bool periodic = true;        ///< sinai: in a periodic cell, else in a box
  std::optional<Number> restitution{};
  std::string material{};
  Where where{};
};

struct RunSpec {
  Number start = 0.0;                      ///< [time] the clock at the beginning. DEFAULT: 0
  std::optional<Number> until{};             ///< [time] absolute; events at it are included
  std::optional<std::int64_t> events{};      ///< exactly so many collisions
  std::optional<Number> until_packing{};     ///< [-] share of the space that growing balls fill: the run ends as they reach it
  std::optional<Number> until_reduced_pressure{};  ///< [-] > 1: p V / (N k_B T) of growing balls, over blocks of collisions
  std::optional<std::int64_t> rescale_every{};     ///< growing balls: every so many collisions the velocities are scaled so that
                                                   ///< the kinetic energy is that of the start. DEFAULT: never
  std::optional<Number> sample_every{};      ///< [time] between frames
  std::uint64_t seed = 0;                  ///< DEFAULT: 0
  Where where{};
};

enum class SearchKind : std::uint8_t { automatic, all_pairs, cells, neighbour_list };
enum class QueueKind : std::uint8_t { automatic, heap, calendar };

/// DEFAULT: chosen by carom. The events are the same whatever is chosen.
struct EngineSpec {
  SearchKind search = SearchKind::automatic;
  QueueKind queue = QueueKind::automatic;
  bool vectors = true;  ///< use the vector instructions that the processor has. DEFAULT true; the results are the same
  Where where{};
};

/// Sampled at equal distances of time.
struct RadialDistributionSpec {
  std::optional<Number> every{};  ///< [time] between samples. DEFAULT: 10 mean free times of Enskog's theory
  std::optional<Number> r_max{};  ///< [length] DEFAULT: 4 mean diameters, or half of the shortest period if that is less
  std::int64_t bins = 200;        ///< from 0 to r_max. DEFAULT: 200
};
struct LagsSpec {
  std::optional<Number> every{};           ///< [time] between samples, and between lags. DEFAULT: see Samplers
  std::int64_t lags = 100;                 ///< curves run from 0 to lags every. DEFAULT: 100
  std::optional<std::int64_t> origins{};   ///< looked back at at a time; each holds 24 bytes a ball. DEFAULT: 10, fewer from
                                           ///< 10^5 balls on, so that 10^6 vectors suffice, but at least 1
};

/// Exponential growth of small displacements.
struct LyapunovSpec {
  std::optional<std::int64_t> exponents{};  ///< the largest so many. DEFAULT: all of a system of up to 16, else 1
  std::optional<Number> every{};            ///< [time] between orthonormalisations. DEFAULT: chosen from the growth
  std::optional<Number> finite_time{};      ///< [time] span of finite-time exponents. DEFAULT: not measured
};
/// A table that goes to a file.
struct TableFileSpec {
  std::string file{};  ///< DEFAULT: the key's name with ".csv"
};
/// Crossings of a line, from one side to the other.
struct PoincareSpec {
  Coordinates point{}, normal{};  ///< [length]; crossings towards the normal count
  std::string file{};             ///< DEFAULT: "poincare.csv"
};
/// How many balls have not left through an opening.
struct SurvivalSpec {
  std::optional<Number> from{}, to{};  ///< [time] the escape rate is fitted between them. DEFAULT: the whole run
  std::int64_t bins = 100;             ///< of the curve
  std::string file{};                  ///< of the curve. DEFAULT: "survival.csv"
  std::string departures{};            ///< file of who left when and where. DEFAULT: "departures.csv"
};
/// The part of the boundary map's cells that the orbit visits.
struct PhaseSpaceSpec {
  std::int64_t bins = 100;  ///< along each of the two axes
};

/// What to measure; nothing is measured that is not asked for.
struct ObserveSpec {
  std::optional<std::int64_t> after_events{};  ///< start measuring after so many collisions. DEFAULT: at once
  std::optional<Number> after_time{};          ///< [time] start measuring then. DEFAULT: at once
  bool pressure = false;
  bool collision_rate = false;
  bool mean_free_path = false;
  bool speed_histogram = false;
  std::optional<RadialDistributionSpec> radial_distribution{};
  std::optional<LagsSpec> mean_squared_displacement{};
  std::optional<LagsSpec> velocity_autocorrelation{};
  std::optional<LyapunovSpec> lyapunov{};
  std::optional<TableFileSpec> boundary_map{};
  std::optional<PoincareSpec> poincare{};
  std::optional<SurvivalSpec> survival{};
  std::optional<LagsSpec> diffusion{};
  std::optional<LagsSpec> angle_autocorrelation{};
  bool rotation_number = false;
  bool caustic = false;
  std::optional<PhaseSpaceSpec> phase_space_portion{};
  std::optional<TableFileSpec> wall_sequence{};
  Where where{};
};

/// When frames are written, beside the start and the end: each run.sample_every of time, or at every collision.
enum class FramesAt : std::uint8_t { samples, events };

struct OutputSpec {
  std::string events{};      ///< file for the event log. DEFAULT: none
  std::string trajectory{};  ///< file for the frames: .h5 (H5MD), .xyz (extended XYZ) or .csv. DEFAULT: none
  std::string ledger{};      ///< file for the energy and momentum at each frame. DEFAULT: none
  FramesAt trajectory_frames = FramesAt::samples;  ///< DEFAULT: samples
  std::string checkpoint{};  ///< file for the state, written at the end and on Ctrl-C. DEFAULT: none
  std::optional<Number> checkpoint_every_time{};          ///< [time] and each such span of the scene's time
  std::optional<std::int64_t> checkpoint_every_events{};  ///< and after each so many collisions
  Where where{};
};

/// One key of the scene that the runs of an ensemble differ in: one of listed values, of equal steps through a range, or drawn.
struct VarySpec {
  std::string key{};                     ///< dotted path, as --set takes it
  std::vector<std::string> values{};     ///< TOML values
  std::optional<Number> from{}, to{};    ///< a range
  std::int64_t steps = 0;                ///< > 1: so many values from `from` to `to`, both included; 0: drawn, uniform; with
                                         ///< neither values nor range what is drawn depends on the key [Ensemble]
  Where where{};
};

/// How the lists of several keys are combined: each value of one with each of the others, or the k-th of all together.
enum class Combine : std::uint8_t { grid, zip };

/// Many runs of one scene.
struct EnsembleSpec {
  std::optional<std::int64_t> count{};  ///< runs at each combination of the listed values. DEFAULT: 1
  std::uint64_t seed = 1;               ///< of what is drawn: a function of seed, run and key. DEFAULT: 1
  std::vector<VarySpec> vary{};
  Where where{};
  Combine combine = Combine::grid;      ///< DEFAULT: grid
};

struct Scene {
  std::string file{};   ///< for messages; empty: made in code
  std::string title{};
  bool rounded = false;  ///< its numbers are the doubles, half an ulp in doubt; see `rounded_to_double`. DEFAULT: false
  int dimension = 2;     ///< 1, 2 or 3. DEFAULT: 2
  SpaceSpec space;
  MotionSpec motion;
  CollisionSpec collision;
  std::vector<MaterialSpec> materials{};
  std::vector<MaterialPairSpec> material_pairs{};
  std::vector<BallSpec> balls{};
  std::vector<LatticeSpec> lattices{};
  std::vector<GasSpec> gases{};
  std::vector<WallSpec> walls{};    ///< those of [[wall]], then those of [[table]]
  std::vector<TableSpec> tables{};  ///< as written
  bool tables_in = false;           ///< their walls, balls and space are in this scene; see `with_tables`. DEFAULT: false
  std::optional<EnsembleSpec> ensemble{};
  RunSpec run;
  EngineSpec engine;
  ObserveSpec observe;
  OutputSpec output;
};

}  // namespace carom
