#pragma once
// Which walls are hit in which order: a sequence of symbols.

#include <cstdint>
#include <memory>
#include <vector>

#include "carom/observe/block_rows.hpp"
#include "carom/observe/boundary.hpp"
#include "carom/observe/observer.hpp"
#include "carom/observe/row_outlet.hpp"

namespace carom {

/// Rows: time [time], piece, its wall and feature (Boundary::Piece), ball. The pieces of the boundary are the symbols.
///   wall_sequence.share[k] [-]: collisions with piece k over all, for up to `most_shares` pieces;
///   wall_sequence.entropy [nat]: what a symbol says that those before it did not, H_n - H_(n-1) with H_n the entropy of words
///   of n symbols, for the longest words, up to `most_words` different ones, that came up 32 times each on average. It is an
///   upper bound of the entropy of the sequence, up to the words that a finite run has missed.
class WallSequence {
 public:
  static constexpr std::size_t most_shares = 64, most_words = 1 << 16;

  WallSequence(std::shared_ptr<const Boundary> boundary, const RowOutlet& outlet, const Subject& subject);

  static std::vector<std::string> columns() { return {"time", "piece", "wall", "feature", "ball"}; }

  void collision(const Collision& c, double t, const Subject& subject);
  void end(double) {}
  [[nodiscard]] Estimates estimates() const;

 private:
  struct Word {
    std::size_t code = 0;      // the newest symbol is the least digit
    std::size_t symbols = 0;   // so far, up to longest_
  };
  [[nodiscard]] double entropy(std::size_t symbols) const;

  std::shared_ptr<const Boundary> boundary_;
  const RowOutlet* outlet_;
  std::size_t base_, longest_ = 0;       // number of symbols; of those in a word
  std::vector<Word> words_;              // by ball
  std::vector<std::uint64_t> counts_;    // by code of a longest word
  std::uint64_t counted_ = 0;
  BlockRows shares_;                     // by piece, then all
  std::size_t bounces_ = 0;
};

}  // namespace carom
