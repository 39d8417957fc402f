#pragma once
// The page of `carom view`, bundled when carom is built (bundle.mjs).

#include <string_view>
#include <vector>

namespace carom::app {

/// A page is head, its data, middle, the script of its dimension, tail; each in pieces.
struct PageParts {
  using Text = std::vector<std::string_view>;

  Text head, middle;
  Text flat;   ///< script for 1-D and 2-D
  Text solid;  ///< script for 3-D
  Text tail;
};

/// nullptr: carom was built without node and npm.
[[nodiscard]] const PageParts* page_parts();

}  // namespace carom::app
