#pragma once
// The event queue on a bounded increasing calendar: constant time a change, whatever the number of balls.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "carom/predict/event.hpp"
#include "carom/queue/calendar.hpp"

namespace carom {

/// The same order as any other queue: buckets follow each other in time, and within a bucket events are sorted by `precedes`.
template <class Real, int D>
class CalendarQueue {
  static_assert(std::is_same_v<Real, double>, "the calendar counts its buckets in double");

 public:
  using EventType = Event<double, D>;
  static constexpr const char* name = "calendar";

  void reset(std::uint32_t slots) {
    events_.assign(slots, EventType{});
    serial_.assign(slots, 0);
    agenda_.clear();
    head_ = 0;
    started_ = false;
  }
  void assign(std::uint32_t slot, const EventType& event) {
    events_[slot] = event;
    ++serial_[slot];
    if (started_) enter(slot);
  }
  [[nodiscard]] const EventType& top() const {
    settle();
    return head_ < agenda_.size() ? events_[agenda_[head_].slot] : nothing_;
  }
  [[nodiscard]] std::uint32_t top_slot() const {
    settle();
    return head_ < agenda_.size() ? agenda_[head_].slot : 0;
  }

 private:
  static constexpr double wanted = 16;           // entries in a bucket
  static constexpr std::int64_t judged = 4096;   // buckets after which the width is judged

  struct Entry {
    std::uint32_t slot;
    std::uint32_t serial;
  };

  /// A slot's event, which is not yet in, takes its place.
  void enter(std::uint32_t slot) const {
    if (events_[slot].kind == EventKind::none) return;
    const std::int64_t bucket = calendar_.bucket(events_[slot].time);
    if (bucket > calendar_.current()) {
      calendar_.push(slot, bucket);
      return;
    }
    const auto before = [this](const Entry& a, const Entry& b) { return earlier(a, b); };
    const Entry entry{slot, serial_[slot]};
    // Entries that have become stale are of no account in the order, but must not spoil the search for a place.
    agenda_.erase(agenda_.begin(), agenda_.begin() + static_cast<std::ptrdiff_t>(head_));
    head_ = 0;
    std::erase_if(agenda_, [this](const Entry& e) { return serial_[e.slot] != e.serial; });
    agenda_.insert(std::upper_bound(agenda_.begin(), agenda_.end(), entry, before), entry);
  }
  [[nodiscard]] bool earlier(const Entry& a, const Entry& b) const {
    if (precedes(events_[a.slot], events_[b.slot])) return true;
    return !precedes(events_[b.slot], events_[a.slot]) && a.slot < b.slot;
  }

  /// Goes on until the first entry of the agenda is a live one, or nothing is left.
  void settle() const {
    if (!started_) start();
    while (true) {
      while (head_ < agenda_.size() && serial_[agenda_[head_].slot] != agenda_[head_].serial) ++head_;
      if (head_ < agenda_.size()) return;
      agenda_.clear();
      head_ = 0;
      if (buckets_ >= judged && (taken_ < wanted / 4 * judged || taken_ > wanted * 4 * judged)) start();
      const bool any = calendar_.next(
          [this](std::uint32_t slot) {
            if (events_[slot].kind == EventKind::none) return;
            if (calendar_.bucket(events_[slot].time) != calendar_.current()) return;
            agenda_.push_back({slot, serial_[slot]});
          },
          [this](std::uint32_t slot) {
            return calendar_.bucket(events_[slot].kind == EventKind::none ? Time<double>::never() : events_[slot].time);
          });
      if (!any) {
        if (!start()) return;
        continue;
      }
      std::sort(agenda_.begin(), agenda_.end(), [this](const Entry& a, const Entry& b) { return earlier(a, b); });
      agenda_.erase(std::unique(agenda_.begin(), agenda_.end(), [](const Entry& a, const Entry& b) { return a.slot == b.slot; }),
                    agenda_.end());
      ++buckets_;
      taken_ += static_cast<double>(agenda_.size());
    }
  }

  /// Enters all events in a calendar whose width suits the next quarter of them. False if there are none.
  bool start() const {
    started_ = true;
    agenda_.clear();
    head_ = 0;
    buckets_ = 0;
    taken_ = 0;
    Time<double> first = Time<double>::never();
    for (const EventType& e : events_)
      if (e.kind != EventKind::none && e.time < first) first = e.time;
    std::vector<double> waits;
    for (const EventType& e : events_)
      if (e.kind != EventKind::none) waits.push_back(elapsed(first, e.time));
    double width = 1;
    if (!waits.empty()) {
      const std::size_t quarter = waits.size() / 4;
      std::nth_element(waits.begin(), waits.begin() + static_cast<std::ptrdiff_t>(quarter), waits.end());
      width = std::clamp(wanted * waits[quarter] / static_cast<double>(quarter + 1), 0x1p-20, 0x1p40);
    }
    calendar_.reset(first.is_never() ? Time<double>{} : first, width, ring);
    for (std::uint32_t slot = 0; slot < events_.size(); ++slot) enter(slot);
    return !waits.empty();
  }

  static constexpr std::uint32_t ring = 256;

  // Which bucket is being emptied is no part of what is in the queue: `top` goes on to the next one.
  std::vector<EventType> events_;                // by slot
  std::vector<std::uint32_t> serial_;            // by slot: changes with its event
  mutable std::vector<Entry> agenda_;            // of the bucket at hand, in order from head_ on
  mutable std::size_t head_ = 0;
  mutable bool started_ = false;
  mutable std::int64_t buckets_ = 0;
  mutable double taken_ = 0;
  mutable Calendar calendar_;
  EventType nothing_;
};

}  // namespace carom
