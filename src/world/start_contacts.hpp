#pragma once
// Who touches whom at the start, and who overlaps.
//
// A gap is judged by f = |r|^2 - sigma^2 (or by the distance to a plane) in wide arithmetic, against the interval that half
// an ulp of doubt in every input, and the evaluation where it is not wide, open around it: 0 inside means contact by right,
// all of it below 0 means an overlap.

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "carom/core/error.hpp"
#include "carom/world/near_pairs.hpp"
#include "carom/world/state.hpp"
#include "carom/world/wall_images.hpp"
#include "carom/world/wall_motion.hpp"
#include "carom/world/world.hpp"

namespace carom::detail {

/// Half an ulp of x in a significand of `bits`: the doubt that rounding an input to that leaves.
template <class Real>
[[nodiscard]] inline Real half_ulp(const Real& x, int bits) {
  using std::frexp;
  using std::ldexp;
  if (x == 0) return Real(0);
  int exponent = 0;
  (void)frexp(x, &exponent);
  return ldexp(Real(1), exponent - 1 - bits);
}

/// Bits that an input is given to: those of a double where it was rounded to one, else those of the world's arithmetic.
template <class Real>
[[nodiscard]] inline int input_bits(bool rounded) {
  return rounded ? significand_bits<double>() : significand_bits<Real>();
}

/// What the evaluation of a sum of at most eight terms of this size adds to the doubt: nothing in double, which is evaluated
/// in twice the precision.
template <class Real>
[[nodiscard]] inline Real evaluation_doubt(const Real& size) {
  if constexpr (std::is_same_v<Real, double>) return Real(0);
  return Real(8 * unit_roundoff<Real>() * size);
}

/// Sign of a value given to within `doubt`, from inputs of `bits`: 0 if it cannot be told from 0. What would be contact in
/// double is never an overlap in a higher precision: users write as many digits as a double has.
template <class Real>
[[nodiscard]] inline int sign_within(const Real& value, const Real& doubt, int bits) {
  using std::ldexp;
  if (value > doubt) return 1;
  return value < -ldexp(doubt, std::max(0, bits - significand_bits<double>())) ? -1 : 0;
}

template <class Real, int D>
class StartContacts {
 public:
  StartContacts(const Scene& scene, World<Real, D>& world, const std::vector<int>& bits, const std::vector<int>& lines,
                std::vector<Problem>& problems)
      : scene_(scene),
        world_(world),
        bits_(bits),
        lines_(lines),
        problems_(problems),
        scene_bits_(input_bits<Real>(scene.rounded)) {}

  void find() {
    std::vector<Vec<Real, D>> positions;
    positions.reserve(world_.balls.size());
    for (const Ball<Real, D>& b : world_.balls) positions.push_back(b.position);
    for_each_near_pair(world_, positions, 0.0,
                       [this](std::uint32_t i, std::uint32_t j, const Image<D>& image) { judge_pair(i, j, image); });
    for (std::uint32_t i = 0; i < world_.balls.size(); ++i)
      world_.walls.for_each([&](const auto& shape) {
        if (world_.walls.opens(index(shape.wall))) return;
        image_ = Image<D>{};
        if (swing_of(world_.walls, shape) != nullptr) return judge_swinging(i, shape);
        if (!world_.space.periodic()) return judge_wall(i, shape);
        const Real near = world_.balls[i].radius * Real(1.001) + far_enough(shape);
        for_each_image(world_.space, shape, world_.balls[i].position, near, [&](const Image<D>& n) {
          image_ = n;
          judge_wall(i, moved_by(world_.space, shape, n));
        });
      });
  }

 private:
  using W = Wide<Real>;
  static constexpr std::size_t most_problems = 20;

  [[nodiscard]] std::string name(std::uint32_t i) const {
    const std::string& given = world_.details[i].name;
    return given.empty() ? fmt::format("ball {}", i) : fmt::format("ball {} (\"{}\")", i, given);
  }
  [[nodiscard]] double in_users_length(const Real& x) const { return static_cast<double>(scaled(x, world_.units.length)); }
  void complain(int line, std::string what, std::string why, std::string hint) {
    if (problems_.size() < most_problems)
      problems_.push_back({scene_.file, line, std::move(what), std::move(why), std::move(hint)});
  }

  void judge_pair(std::uint32_t i, std::uint32_t j, const Image<D>& image) {
    using std::abs;
    using std::sqrt;
    const Ball<Real, D>&a = world_.balls[i], &b = world_.balls[j];
    const Real sigma = a.radius + b.radius;
    if (D > 1 && sigma == 0) return;
    W rr(Real(0));
    Real doubt(0), spread(0);
    for (int k = 0; k < D; ++k) {
      W r = wide_difference<Real>(b.position[k], a.position[k]);
      Real d = half_ulp(a.position[k], bits_[i]) + half_ulp(b.position[k], bits_[j]);
      if (world_.space.periodic()) {
        r = r + wide_product<Real>(Real(image[k]), world_.space.edge[k]);
        d += abs(Real(image[k])) * half_ulp(world_.space.edge[k], scene_bits_);
      }
      rr = rr + r * r;
      doubt += 2 * abs(narrow(r)) * d;
      spread += d * d;
    }
    const Real radii_doubt = half_ulp(a.radius, bits_[i]) + half_ulp(b.radius, bits_[j]);
    doubt += 2 * sigma * radii_doubt + spread + radii_doubt * radii_doubt;
    const W sum = wide_sum<Real>(a.radius, b.radius);
    const Real f = narrow(W(rr - sum * sum));
    doubt += evaluation_doubt<Real>(narrow(W(rr + sum * sum)));
    const int sign = sign_within(f, doubt, std::min(bits_[i], bits_[j]));
    if (sign > 0 || (a.fixed && b.fixed)) return;
    if (sign < 0) {
      if (i == j) {
        complain(lines_[i], fmt::format("{} overlaps its own periodic image", name(i)),
                 "the cell is narrower than the ball", "Make the cell larger");
      } else {
        complain(
            lines_[j],
            fmt::format("{} and {} overlap by {:.6g}", name(i), name(j), in_users_length(Real(sigma - sqrt(narrow(rr))))),
            "balls must start apart", "Reduce \"radius\" or move one of them");
      }
      return;
    }
    if (i == j) return;
    Contact<D> contact;
    contact.partner = j;
    contact.image = image;
    hold_contact(world_, i, contact);
    contact.partner = i;
    contact.image = -image;
    hold_contact(world_, j, contact);
  }

  /// What rounding can hide of a distance.
  template <class Shape>
  [[nodiscard]] Real far_enough(const Shape& shape) const {
    using std::abs;
    Real size(0);
    if constexpr (requires { reach_of(shape); })
      for (int k = 0; k < D; ++k) size += abs(middle_of(shape)[k]) + reach_of(shape) + world_.space.edge[k];
    return 64 * unit_roundoff<Real>() * size;
  }

  [[nodiscard]] Real doubt_of(const Vec<Real, D>& direction, std::uint32_t i, const Vec<Real, D>& reference) const {
    using std::abs;
    Real size = world_.balls[i].radius;
    for (int k = 0; k < D; ++k) size += abs(direction[k]) * (abs(world_.balls[i].position[k]) + abs(reference[k]));
    Real d = evaluation_doubt<Real>(size);
    d += half_ulp(world_.balls[i].radius, bits_[i]);
    for (int k = 0; k < D; ++k)
      d += abs(direction[k]) * (half_ulp(world_.balls[i].position[k], bits_[i]) + half_ulp(reference[k], scene_bits_));
    return d;
  }

  /// A wall that swings, where it is at the start: its displacement is a rounded sine.
  template <class Shape>
  void judge_swinging(std::uint32_t i, const Shape& shape) {
    using std::abs;
    const Ball<Real, D>& b = world_.balls[i];
    const Vec<Real, D> displacement = drift(world_, shape, world_.start), x = b.position - displacement;
    Real size = b.radius + abs(shape.gap(x));
    for (int k = 0; k < D; ++k) size += abs(b.position[k]) + abs(displacement[k]);
    const Real doubt = 16 * unit_roundoff<Real>() * size;
    std::int8_t side = 0;
    if constexpr (std::is_same_v<Shape, Segment<Real>>) {
      if (dot<Real, D>(shape.along, x - shape.from) < 0 || dot<Real, D>(shape.along, x - shape.to) > 0) return;
      int sign = sign_within(shape.height(x), doubt, bits_[i]);
      if (sign == 0)
        sign = dot<Real, D>(shape.direction, b.velocity - wall_velocity(world_, shape, world_.start)) < 0 ? -1 : 1;
      side = static_cast<std::int8_t>(sign);
    }
    if constexpr (std::is_same_v<Shape, Sphere<Real, D>>)
      if (shape.radius + b.radius == 0) return;
    settle(i, shape, Real(shape.gap(x) - b.radius), doubt, side);
  }

  void judge_wall(std::uint32_t i, const Face<Real, D>& face) {
    const Ball<Real, D>& b = world_.balls[i];
    const W distance = face.sign > 0 ? wide_difference<Real>(b.position[face.axis], face.coordinate)
                                     : wide_difference<Real>(face.coordinate, b.position[face.axis]);
    Vec<Real, D> reference = Vec<Real, D>::Zero();
    reference[face.axis] = face.coordinate;
    settle(i, face, narrow(W(distance - W(b.radius))), doubt_of(face.normal(b.position), i, reference));
  }

  void judge_wall(std::uint32_t i, const Plane<Real, D>& plane) {
    using std::abs;
    const Ball<Real, D>& b = world_.balls[i];
    W distance(Real(0));
    Real size(0);
    for (int k = 0; k < D; ++k) {
      const W along = wide_difference<Real>(b.position[k], plane.point[k]);
      distance = distance + along * W(plane.direction[k]);
      size += abs(narrow(along));
    }
    // A component of the unit normal carries an error of at most 3 u: sum of squares, root, quotient.
    const Real tilt = axis_aligned(plane.direction) ? Real(0) : Real(3 * unit_roundoff<Real>() * size);
    settle(i, plane, narrow(W(distance - W(b.radius))), doubt_of(plane.direction, i, plane.point) + tilt);
  }

  void judge_wall(std::uint32_t i, const Sphere<Real, D>& sphere) {
    using std::abs;
    using std::sqrt;
    const Ball<Real, D>& b = world_.balls[i];
    const W reach =
        sphere.inside ? wide_difference<Real>(sphere.radius, b.radius) : wide_sum<Real>(sphere.radius, b.radius);
    if (sphere.inside && !(narrow(reach) > 0)) {
      complain(lines_[i], fmt::format("{} does not fit into wall {}", name(i), label(sphere)),
               "its radius is not below that of the circle", "Reduce \"radius\"");
      return;
    }
    W rr(Real(0));
    Real doubt(0), spread(0);
    for (int k = 0; k < D; ++k) {
      const W r = wide_difference<Real>(b.position[k], sphere.centre[k]);
      const Real d = half_ulp(b.position[k], bits_[i]) + half_ulp(sphere.centre[k], scene_bits_);
      rr = rr + r * r;
      doubt += 2 * abs(narrow(r)) * d;
      spread += d * d;
    }
    const Real radii_doubt = half_ulp(b.radius, bits_[i]) + half_ulp(sphere.radius, scene_bits_);
    doubt += 2 * narrow(reach) * radii_doubt + spread + radii_doubt * radii_doubt;
    const W outside = rr - reach * reach;
    doubt += evaluation_doubt<Real>(narrow(W(rr + reach * reach)));
    const W f = sphere.inside ? W(Real(0)) - outside : outside;
    // As a length, for the message: f = (|r| - reach)(|r| + reach).
    const Real sum = sqrt(narrow(rr)) + narrow(reach);
    if (sum > 0) settle(i, sphere, Real(narrow(f) / sum), Real(doubt / sum));
  }

  void judge_wall(std::uint32_t i, const Segment<Real>& segment) requires(D == 2) {
    using std::abs;
    const Ball<Real, D>& b = world_.balls[i];
    W height(Real(0)), before(Real(0)), beyond(Real(0));
    Real size(0);
    for (int k = 0; k < D; ++k) {
      const W along = wide_difference<Real>(b.position[k], segment.from[k]);
      height = height + along * W(segment.direction[k]);
      before = before + along * W(segment.along[k]);
      beyond = beyond + wide_difference<Real>(b.position[k], segment.to[k]) * W(segment.along[k]);
      size += abs(narrow(along));
    }
    if (narrow(before) < 0 || narrow(beyond) > 0) return;  // the ends judge for themselves
    const Real tilt = axis_aligned(segment.direction) ? Real(0) : Real(4 * unit_roundoff<Real>() * size);
    const Real doubt = doubt_of(segment.direction, i, segment.from) + tilt;
    const Real h = narrow(height);
    int side = sign_within(h, doubt, bits_[i]);
    if (side == 0) {  // on the wall: the side that the velocity points to
      const Real rate = dot<Real, D>(segment.direction, b.velocity - segment.velocity);
      const Real pull = dot<Real, D>(segment.direction, world_.acceleration);
      side = rate > 0 || (rate == 0 && pull > 0) ? 1 : -1;
    }
    settle(i, segment, narrow(W(side > 0 ? height : W(-h)) - W(b.radius)), doubt, static_cast<std::int8_t>(side));
  }

  /// A curved wall. Its place is rounded, so more than the inputs is in doubt: some u of all coordinates.
  template <class Shape>
    requires is_curved<Shape>
  void judge_wall(std::uint32_t i, const Shape& shape) {
    using std::abs;
    const Ball<Real, D>& b = world_.balls[i];
    Real size = b.radius;
    if constexpr (requires { shape.size(); }) {
      size += shape.size();
    } else {
      size += shape.radius;
      if (!shape.spans(Vec<Real, D>(b.position - shape.centre), Real(0))) return;  // the ends judge for themselves
    }
    for (int k = 0; k < D; ++k) size += abs(b.position[k]) + abs(shape.centre[k]);
    const Real doubt = ldexp_of(Real(16 * size), -std::min(bits_[i], scene_bits_));
    if constexpr (requires { shape.inside; }) {
      settle(i, shape, Real(shape.gap(b.position) - b.radius), doubt, shape.home());
    } else {
      Real height;
      if constexpr (requires { shape.form(b.position); }) {
        height = shape.form(Vec<Real, D>(b.position - shape.centre));
      } else {
        height = shape.height(b.position);
      }
      const Real gap = shape.gap(b.position) - b.radius;
      std::int8_t side = height < 0 ? -1 : 1;
      if (b.radius == 0 && abs(gap) <= doubt) {  // on the wall: the side that the velocity points to
        const Vec<Real, D> left = shape.normal(b.position);
        const Real rate = dot<Real, D>(left, b.velocity - shape.velocity), pull = dot<Real, D>(left, world_.acceleration);
        side = rate > 0 || (rate == 0 && pull > 0) ? 1 : -1;
      }
      settle(i, shape, gap, doubt, side);
    }
  }
  [[nodiscard]] static Real ldexp_of(const Real& x, int exponent) {
    using std::ldexp;
    return ldexp(x, exponent);
  }

  template <class Shape>
  void settle(std::uint32_t i, const Shape& shape, const Real& gap, const Real& doubt, std::int8_t side = 0) {
    const int sign = sign_within(gap, doubt, bits_[i]);
    if (sign > 0 || world_.balls[i].fixed) return;
    if (sign < 0) {
      const std::string where = label(shape);
      const bool face = !where.empty() && where[0] >= 'x';
      complain(lines_[i],
               fmt::format("{} reaches {:.6g} {} {}", name(i), in_users_length(Real(-gap)),
                           face ? "out of the box through face" : "across wall", where),
               "a ball starts inside its space, at least its radius away from every wall",
               "Move the ball or reduce \"radius\"");
      return;
    }
    Contact<D> contact;
    contact.party = Party::wall;
    contact.partner = index(shape.wall);
    contact.feature = shape.feature;
    contact.image = image_;
    contact.side = side;
    hold_contact(world_, i, contact);
  }

  [[nodiscard]] static bool axis_aligned(const Vec<Real, D>& n) {
    int zeros = 0;
    for (int k = 0; k < D; ++k) zeros += n[k] == 0;
    return zeros == D - 1;
  }
  template <class Shape>
  [[nodiscard]] std::string label(const Shape& shape) const {
    return world_.walls.labels[index(shape.wall)];
  }

  const Scene& scene_;
  World<Real, D>& world_;
  const std::vector<int>& bits_;
  const std::vector<int>& lines_;
  std::vector<Problem>& problems_;
  int scene_bits_;
  Image<D> image_{};  // of the wall that is judged
};

template <class Real, int D>
void find_start_contacts(const Scene& scene, World<Real, D>& world, const std::vector<int>& bits,
                         const std::vector<int>& lines, std::vector<Problem>& problems) {
  StartContacts<Real, D>(scene, world, bits, lines, problems).find();
}

}  // namespace carom::detail
