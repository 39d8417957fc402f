#pragma once
// Where results and messages go, and whether a person is looking.

#include <ostream>

#include "carom/write/summary_table.hpp"

namespace carom::app {

struct Console {
  std::ostream& out;             ///< the result
  std::ostream& err;             ///< messages
  bool err_is_terminal = false;  ///< progress may be shown
  Colour colour = Colour::off;   ///< of the result

  /// Standard output and error. Colour on a terminal, unless NO_COLOR is set.
  [[nodiscard]] static Console standard();
};

}  // namespace carom::app
