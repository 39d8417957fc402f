#include "carom/observe/wall_sequence.hpp"

#include <array>
#include <cmath>
#include <string>

namespace carom {

namespace {

constexpr double times_each = 32;

}  // namespace

WallSequence::WallSequence(std::shared_ptr<const Boundary> boundary, const RowOutlet& outlet, const Subject& subject)
    : boundary_(std::move(boundary)),
      outlet_(&outlet),
      base_(boundary_->pieces().size()),
      words_(subject.mass.size()),
      shares_(base_ <= most_shares ? base_ + 1 : 1) {
  std::size_t size = 1;
  while (base_ > 1 && size * base_ <= most_words) {
    size *= base_;
    ++longest_;
  }
  if (longest_ > 0) counts_.assign(size, 0);
}

void WallSequence::collision(const Collision& c, double, const Subject& subject) {
  const std::optional<Bounce> b = boundary_->bounce(c, subject);
  if (!b) return;
  const Boundary::Piece& piece = boundary_->pieces()[b->piece];
  if (outlet_->open())
    (*outlet_)(std::array{c.time, static_cast<double>(b->piece), static_cast<double>(piece.wall),
                          static_cast<double>(piece.feature), static_cast<double>(b->ball)});
  const std::span<double> shares = shares_.row(bounces_++);
  if (shares.size() > 1) shares[b->piece] += 1;
  shares.back() += 1;
  if (longest_ == 0) return;
  Word& word = words_[b->ball];
  word.code = (word.code * base_ + b->piece) % counts_.size();
  if (word.symbols < longest_) ++word.symbols;
  if (word.symbols < longest_) return;
  ++counts_[word.code];
  ++counted_;
}

double WallSequence::entropy(std::size_t symbols) const {
  std::size_t rest = 1;
  for (std::size_t k = symbols; k < longest_; ++k) rest *= base_;
  double h = 0;
  for (std::size_t from = 0; from < counts_.size(); from += rest) {
    double n = 0;
    for (std::size_t code = from; code < from + rest; ++code) n += static_cast<double>(counts_[code]);
    if (n > 0) h -= n * std::log(n / static_cast<double>(counted_));
  }
  return h / static_cast<double>(counted_);
}

Estimates WallSequence::estimates() const {
  Estimates list;
  const std::size_t pieces = base_ <= most_shares ? base_ : 0;
  std::vector<std::string> names;
  for (std::size_t k = 0; k < pieces; ++k) names.push_back("wall_sequence.share[" + std::to_string(k) + "]");
  if (pieces > 0)
    list = shares_.estimates(names, [pieces](BlockRows::Row row) {
      std::vector<double> share(pieces);
      for (std::size_t k = 0; k < pieces; ++k) share[k] = row[k] / row[pieces];
      return share;
    });
  Estimate h{"wall_sequence.entropy"};
  if (base_ == 1 && bounces_ > 0) h.value = 0;
  if (counted_ > 0) {
    std::size_t n = 1;
    double words = static_cast<double>(base_) * static_cast<double>(base_);
    while (n < longest_ && words * times_each <= static_cast<double>(counted_)) {
      ++n;
      words *= static_cast<double>(base_);
    }
    h.value = entropy(n) - (n > 1 ? entropy(n - 1) : 0.0);
  }
  list.push_back(std::move(h));
  return list;
}

}  // namespace carom
