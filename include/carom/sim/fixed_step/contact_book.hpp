#pragma once
// Which pairs are in contact in this step and were so in the step before: what tells a collision from a contact that lasts.

#include <cstdint>
#include <vector>

#include "carom/core/id.hpp"
#include "carom/predict/event.hpp"

namespace carom {

/// A contact while it lasts; `image` is the one that no wrapping changes. In the world's units.
template <int D>
struct LastingContact {
  EventKind kind = EventKind::none;
  std::uint32_t ball = 0, partner = 0;  ///< ball_ball: ball < partner
  std::int32_t feature = 0;
  Image<D> image{};
  double overlap = 0;        ///< [length unit] of this step, or the deepest: as the method keeps it
  double impulse = 0;        ///< [momentum unit] of this step, or since it began: as the method keeps it
  bool reported = false;     ///< as a collision
  std::int64_t since = 0;    ///< step in which it began
  bool ended = true;         ///< of a contact of the step before: not found again
  std::uint32_t next = ~0u;  ///< another contact of the same ball

  [[nodiscard]] bool same(const LastingContact& o) const {
    return kind == o.kind && ball == o.ball && partner == o.partner && feature == o.feature && image == o.image;
  }
};

/// Contacts are found again through a list for each ball; nothing is allocated once the vectors have grown.
template <int D>
class ContactBook {
 public:
  using Contact = LastingContact<D>;

  explicit ContactBook(std::size_t balls) {
    now_.first.assign(balls, none);
    before_.first.assign(balls, none);
  }

  /// The contact `c` of this step, found or new; `fresh` is called for one that is new in this step. One that goes on takes
  /// over what it was in the step before, and so says `since`. Valid until the next call.
  Contact& touch(const Contact& c, std::int64_t step) {
    if (Contact* found = now_.find(c)) return *found;
    now_.contacts.push_back(c);
    Contact& entry = now_.contacts.back();
    entry.since = step;
    if (Contact* earlier = before_.find(c)) {
      earlier->ended = false;
      entry = *earlier;
      entry.ended = true;
    }
    std::uint32_t& first = now_.first[c.ball];
    entry.next = first;
    first = static_cast<std::uint32_t>(now_.contacts.size() - 1);
    return entry;
  }

  [[nodiscard]] std::vector<Contact>& now() noexcept { return now_.contacts; }
  [[nodiscard]] std::vector<Contact>& before() noexcept { return before_.contacts; }

  /// The step ends: its contacts become those of the step before.
  void turn() {
    std::swap(now_, before_);
    for (const Contact& c : now_.contacts) now_.first[c.ball] = none;
    now_.contacts.clear();
  }

 private:
  static constexpr std::uint32_t none = ~0u;

  struct Page {
    std::vector<Contact> contacts;
    std::vector<std::uint32_t> first;  // by ball: a list of contacts

    [[nodiscard]] Contact* find(const Contact& c) {
      for (std::uint32_t k = first[c.ball]; k != none; k = contacts[k].next)
        if (contacts[k].same(c)) return &contacts[k];
      return nullptr;
    }
  };

  Page now_, before_;
};

}  // namespace carom
