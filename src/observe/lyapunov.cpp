#include "carom/observe/lyapunov.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "carom/core/random.hpp"

namespace carom {

namespace {

constexpr double grown = 1e3;               // then displacements are made orthonormal
constexpr double epochs_in_a_time = 4096;   // of the shortest length over the largest speed (carom/core/clock.hpp)
constexpr std::size_t all_of = 16;          // coordinates: a system of up to so many is measured in full

std::size_t phase_space(const Subject& s) {
  return 2 * static_cast<std::size_t>(s.free) * static_cast<std::size_t>(s.dimension);
}

/// The rows' columns become orthonormal in the order of their numbers (the modified process of Gram and Schmidt); logs[k]
/// is the logarithm of the length that column k had beyond those before it. A column without length stays 0.
void gram_schmidt(double* rows, std::size_t row_count, std::size_t columns, std::vector<double>& logs,
                  std::vector<double>& along) {
  for (std::size_t k = 0; k < columns; ++k) {
    double square = 0;
    for (std::size_t r = 0; r < row_count; ++r) square += rows[r * columns + k] * rows[r * columns + k];
    const double length = std::sqrt(square);
    logs[k] = std::log(length);
    if (length == 0) continue;
    std::fill(along.begin(), along.end(), 0.0);
    for (std::size_t r = 0; r < row_count; ++r) {
      double* row = rows + r * columns;
      row[k] /= length;
      const double unit = row[k];
      for (std::size_t j = k + 1; j < columns; ++j) along[j] += unit * row[j];
    }
    for (std::size_t r = 0; r < row_count; ++r) {
      double* row = rows + r * columns;
      const double unit = row[k];
      for (std::size_t j = k + 1; j < columns; ++j) row[j] -= unit * along[j];
    }
  }
}

}  // namespace

std::size_t Lyapunov::count(const LyapunovSpec& spec, const Subject& subject) {
  const std::size_t all = phase_space(subject);
  if (spec.exponents) return std::min(all, static_cast<std::size_t>(*spec.exponents));
  return all <= all_of ? all : 1;
}

Lyapunov::Lyapunov(const LyapunovSpec& spec, const Scene& scene, const Subject& subject)
    : epoch_length_(subject.epoch_length),
      begun_(subject.moment),
      coordinates_(phase_space(subject)),
      flow_(scene, subject, count(spec, subject), subject.epoch_length * epochs_in_a_time),
      done_(subject.moment),
      sums_(flow_.count() + 1),
      logs_(flow_.count()),
      along_(flow_.count()) {
  if (spec.every) every_ = *spec.every;
  if (spec.finite_time) spans_.emplace(*spec.finite_time, flow_.count());
  const std::size_t columns = flow_.count();
  const std::span<double> rows = flow_.rows();
  for (std::size_t r = 0; r < flow_.row_count(); ++r) {
    RandomStream draws(r, 0);
    for (std::size_t j = 0; j < columns; ++j)
      rows[r * columns + j] = columns == coordinates_ ? (r == j ? 1.0 : 0.0) : 2 * draws.uniform() - 1;
  }
  orthonormalise(begun_);  // and what it took is not counted
  passed_ = 0;
  sums_ = BlockRows(columns + 1);
  if (spans_) spans_.emplace(*spec.finite_time, columns);
}

void Lyapunov::orthonormalise(const Time<double>& now) {
  flow_.advance_to(now);
  gram_schmidt(flow_.rows().data(), flow_.row_count(), flow_.count(), logs_, along_);
  const std::span<double> sums = sums_.row(passed_++);
  for (std::size_t k = 0; k < logs_.size(); ++k) {
    sums[k] += logs_[k];
    if (spans_) spans_->add(k, logs_[k]);
  }
  sums.back() += elapsed(done_, now) * epoch_length_;
  done_ = now;
}

void Lyapunov::finish_spans(const Time<double>& now) {
  while (spans_) {
    const double whole = static_cast<double>(spans_->spans() + 1) * spans_->length() / epoch_length_;
    const Time<double> due = after(begun_, whole);
    if (now < due) return;
    orthonormalise(due);
    spans_->next();
  }
}

void Lyapunov::collision(const Collision& c, double, const Subject&) {
  const Time<double> now{c.epoch, c.offset / epoch_length_};
  if (spans_) finish_spans(now);
  flow_.collision(c);
  const bool due = every_ ? elapsed(done_, now) * epoch_length_ >= *every_ : flow_.largest_of_last() > grown;
  if (due) orthonormalise(now);
}

void Lyapunov::end(double t) {
  const Time<double> now = after(begun_, t / epoch_length_);
  finish_spans(now);
  if (done_ < now) orthonormalise(now);
}

Estimates Lyapunov::estimates() const {
  const std::size_t n = flow_.count();
  std::vector<std::string> names;
  for (std::size_t k = 0; k < n; ++k) names.push_back("lyapunov.exponents[" + std::to_string(k) + "]");
  Estimates list = sums_.estimates(names, [n](BlockRows::Row row) {
    std::vector<double> lambda(n);
    for (std::size_t k = 0; k < n; ++k) lambda[k] = row[k] / row[n];
    return lambda;
  });
  std::stable_sort(list.begin(), list.end(), [](const Estimate& a, const Estimate& b) { return a.value > b.value; });
  for (std::size_t k = 0; k < n; ++k) list[k].name = names[k];
  const Estimates exponents = list;
  if (n == coordinates_) {
    list.push_back(sums_.estimate("lyapunov.sum", [n](BlockRows::Row row) {
      double sum = 0;
      for (std::size_t k = 0; k < n; ++k) sum += row[k];
      return sum / row[n];
    }));
    const Estimate volume = list.back();
    list.push_back(sums_.estimate("lyapunov.entropy", [n](BlockRows::Row row) {
      double sum = 0;
      for (std::size_t k = 0; k < n; ++k) sum += std::max(row[k], 0.0);
      return sum / row[n];
    }));
    if (volume.value < -3 * volume.error) {
      Estimate dimension{"lyapunov.dimension"};
      double above = 0;
      for (std::size_t k = 0; k < n; ++k) {
        if (above + exponents[k].value < 0) {
          dimension.value = static_cast<double>(k) + above / -exponents[k].value;
          break;
        }
        above += exponents[k].value;
      }
      list.push_back(std::move(dimension));
    }
  }
  if (spans_)
    for (Estimate& e : spans_->estimates()) list.push_back(std::move(e));
  return list;
}

std::optional<Table> Lyapunov::table() const {
  if (!spans_) return std::nullopt;
  return spans_->table();
}

}  // namespace carom
