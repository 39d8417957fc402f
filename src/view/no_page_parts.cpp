#include "page_parts.hpp"

namespace carom::app {

const PageParts* page_parts() { return nullptr; }

}  // namespace carom::app
