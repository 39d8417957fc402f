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
  int rows = 5;                              ///< rack: rows. DEFAULT: 5 (15 balls)
  Number gap = 0.0;                          ///< rack: [length] between neighbours, >= 0. DEFAULT: 0
  Coordinates apex{};                          ///< rack: [length] centre of the first ball
  Coordinates direction{};                     ///< rack: from the apex to the last row. DEFAULT: [1, 0]
  Where where{};
};

/// Balls placed without overlap, with Maxwell velocities and zero total momentum.
struct GasSpec {
  std::int64_t count = 0;
  std::optional<Number> packing_fraction{};  ///< [-] this entry's own share of the space
  std::optional<Number> radius{};            ///< [length]
  Number mass = 1.0;                       ///< [mass] DEFAULT: 1
  Number temperature = 1.0;                ///< k_B T [energy], exact for the sample. DEFAULT: 1
  std::string material{};                    ///< DEFAULT: none
  std::uint64_t seed = 1;                  ///< DEFAULT: 1
  Where where{};
};

enum class WallKind : std::uint8_t { segment, plane, circle, polygon };
enum class WallSide : std::uint8_t { inside, outside };

/// A ball touches a wall at a distance equal to its radius.
struct WallSpec {
  WallKind kind = WallKind::plane;
  Coordinates from{}, to{};               ///< segment: its ends [length]
  Coordinates point{}, normal{};          ///< plane: [length], and the side on which balls stay
  Coordinates centre{};                 ///< circle (sphere in 3-D): [length]
  Number radius = 1.0;                ///< circle: [length], > 0
  WallSide side = WallSide::inside;   ///< circle: where the balls are. DEFAULT: inside
  std::vector<Coordinates> vertices{};  ///< polygon: closed [length]
  Coordinates velocity{};               ///< [length/time] segment and plane. DEFAULT: at rest
  std::optional<Number> restitution{};  ///< e [-], 0..1. DEFAULT: from the materials, else [collision]
  std::string material{};               ///< DEFAULT: none
  Where where{};
};

struct RunSpec {
  Number start = 0.0;                      ///< [time] the clock at the beginning. DEFAULT: 0
  std::optional<Number> until{};             ///< [time] absolute; events at it are included
  std::optional<std::int64_t> events{};      ///< exactly so many collisions
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
  std::vector<WallSpec> walls{};
  RunSpec run;
  EngineSpec engine;
  ObserveSpec observe;
  OutputSpec output;
};

}  // namespace carom
