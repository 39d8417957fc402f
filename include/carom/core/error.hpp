#pragma once
// What the user did wrong, every problem at once, each with its place, its reason and a way out.

#include <stdexcept>
#include <string>
#include <vector>

namespace carom {

/// One thing wrong in a scene or on the command line: `file:line: what (why). hint`.
struct Problem {
  std::string file;  ///< scene file; empty: set in code or on the command line
  int line = 0;      ///< 1-based; 0: no line
  std::string what;  ///< what is wrong, with the value found
  std::string why;   ///< the rule that it breaks; may be empty
  std::string hint;  ///< what to do; may be empty

  [[nodiscard]] std::string text() const;
};

/// The input cannot be run. Carries all problems found (exit status 2).
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<Problem> problems);
  explicit InputError(Problem problem) : InputError(std::vector<Problem>{std::move(problem)}) {}

  [[nodiscard]] const std::vector<Problem>& problems() const noexcept { return problems_; }

 private:
  std::vector<Problem> problems_;
};

}  // namespace carom
