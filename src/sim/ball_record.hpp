#pragma once
// A ball in a saved state, in few bytes: what is as in the ball before it, or follows from its last collision, is a mark.
//
// marks, [kind], position, velocity, time, stamp, images, [last collision], [contacts], [what is rare]
//
// In double, in space, a ball of a gas that has collided takes some 80 bytes: 48 of position and velocity, 8 of the offset of
// its time, and whole numbers of one byte for seven bits.

#include <cstdint>
#include <limits>

#include "carom/world/world.hpp"

namespace carom {

/// Writes or reads ball by ball, by their numbers: `records(ball, detail)`. Names are left alone: they are the scene's.
template <class Archive, class Real, int D>
class BallRecords {
 public:
  explicit BallRecords(Archive& archive) : archive_(archive) {}

  // The two are constant when they are written.
  void operator()(auto& ball, auto& detail) {
    if constexpr (!Archive::reads) marks_ = marks_of(ball, detail);
    whole(marks_);
    kind(ball, detail);
    for (int k = 0; k < D; ++k) archive_(ball.position[k]);
    for (int k = 0; k < D; ++k) archive_(ball.velocity[k]);
    time(ball.time);
    whole(ball.stamp);
    for (auto& n : detail.image) whole(n);
    last_collision(ball, detail);
    contacts(ball, detail);
    rest(ball, detail);
  }

 private:
  enum Mark : std::uint32_t {
    other_kind = 1,     ///< than the ball before
    in_contact = 2,
    hit_now = 4,        ///< the last collision was at the stored time
    met = 8,            ///< somebody
    own_contact = 16,   ///< one, which the last collision left behind
    hit_before = 32,    ///< the last collision was at another time
    met_wall = 64,
    has_contacts = 128, ///< others
    has_reach = 256,
    gone = 512,
    rare = 1024         ///< rests, is part of a body, or has a place in the order on a line
  };

  struct Kind {
    Real radius = Real(-1), mass = Real(0);
    std::uint32_t material = 0;
    bool fixed = false;
    bool operator==(const Kind&) const = default;
  };

  [[nodiscard]] static Kind kind_of(const auto& ball, const auto& detail) {
    return {ball.radius, detail.mass, detail.material, ball.fixed};
  }
  [[nodiscard]] static bool is_own(const auto& ball, const auto& detail) {
    if (detail.contacts.size() != 1) return false;
    const Contact<D>& c = detail.contacts[0];
    return c.acted && !c.left && c.side == 0 && c.own_stamp == ball.stamp && c.party == detail.last_party &&
           c.partner == detail.last_partner && c.feature == detail.last_feature;
  }
  [[nodiscard]] std::uint32_t marks_of(const auto& ball, const auto& detail) const {
    const auto mark = [](bool set, Mark m) { return set ? std::uint32_t{m} : 0; };
    const bool own = is_own(ball, detail);
    return mark(kind_of(ball, detail) != kind_, other_kind) | mark(ball.in_contact, in_contact) |
           mark(!detail.last_hit.is_never() && detail.last_hit == ball.time, hit_now) |
           mark(!detail.last_hit.is_never() && detail.last_hit != ball.time, hit_before) |
           mark(detail.last_partner != nobody || detail.last_party == Party::wall || detail.last_feature != 0, met) |
           mark(detail.last_party == Party::wall, met_wall) | mark(own, own_contact) |
           mark(!own && !detail.contacts.empty(), has_contacts) | mark(detail.reach != 0, has_reach) |
           mark(!ball.alive, gone) | mark(ball.held != 0 || detail.body != -1 || detail.rank != 0, rare);
  }

  void kind(auto& ball, auto& detail) {
    if (marked(other_kind)) {
      if constexpr (!Archive::reads) kind_ = kind_of(ball, detail);
      archive_(kind_.radius);
      archive_(kind_.mass);
      archive_(kind_.material);
      archive_(kind_.fixed);
    }
    if constexpr (Archive::reads) {
      ball.radius = kind_.radius;
      detail.mass = kind_.mass;
      detail.material = kind_.material;
      ball.fixed = kind_.fixed;
      ball.in_contact = marked(in_contact);
      ball.alive = !marked(gone);
    }
  }

  void last_collision(auto& ball, auto& detail) {
    if constexpr (Archive::reads) {
      detail.last_hit = marked(hit_now) ? ball.time : Time<Real>::never();
      detail.last_party = marked(met_wall) ? Party::wall : Party::ball;
      detail.last_partner = nobody;
      detail.last_feature = 0;
    }
    if (marked(hit_before)) time(detail.last_hit);
    if (!marked(met)) return;
    whole(detail.last_partner);
    whole(detail.last_feature);
  }

  void contacts(auto& ball, auto& detail) {
    if constexpr (Archive::reads) detail.contacts.clear();
    if (marked(own_contact)) {
      if constexpr (Archive::reads) {
        Contact<D>& c = detail.contacts.emplace_back();
        c.party = detail.last_party;
        c.partner = detail.last_partner;
        c.feature = detail.last_feature;
        c.acted = true;
        c.own_stamp = ball.stamp;
      }
      whole(detail.contacts[0].partner_stamp);
      for (auto& n : detail.contacts[0].image.turns) whole(n);
    }
    if (!marked(has_contacts)) return;
    archive_.size(detail.contacts);
    for (auto& c : detail.contacts) {
      archive_(c.party);
      whole(c.partner);
      whole(c.feature);
      for (auto& n : c.image.turns) whole(n);
      archive_(c.side);
      archive_(c.acted);
      whole(c.own_stamp);
      whole(c.partner_stamp);
      archive_(c.left);
    }
  }

  void rest(auto& ball, auto& detail) {
    if constexpr (Archive::reads) {
      detail.reach = Real(0);
      ball.held = 0;
      detail.body = -1;
      detail.rank = 0;
    }
    if (marked(has_reach)) archive_(detail.reach);
    if (!marked(rare)) return;
    archive_(ball.held);
    whole(detail.body);
    whole(detail.rank);
  }

  void time(auto& t) {
    whole(t.epoch);
    archive_(t.offset);
  }
  void whole(auto& n) { archive_.whole(n); }
  [[nodiscard]] bool marked(Mark m) const { return (marks_ & m) != 0; }

  static constexpr std::uint32_t nobody = std::numeric_limits<std::uint32_t>::max();

  Archive& archive_;
  std::uint32_t marks_ = 0;
  Kind kind_;
};

}  // namespace carom
