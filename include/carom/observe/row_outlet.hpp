#pragma once
// Tables that grow row by row while a run goes on: an observer keeps none of it.

#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "carom/scene/scene.hpp"

namespace carom {

using RowSink = std::function<void(std::span<const double>)>;

/// Where an observer's rows go; nowhere as long as nobody wants them.
class RowOutlet {
 public:
  void lead_to(RowSink sink) { sink_ = std::move(sink); }
  [[nodiscard]] bool open() const noexcept { return static_cast<bool>(sink_); }
  void operator()(std::span<const double> row) const {
    if (sink_) sink_(row);
  }

 private:
  RowSink sink_;
};

/// A table whose rows come as they are measured.
struct StreamedTable {
  std::string name;                  ///< of the quantity
  std::string file;                  ///< that the scene asks for
  std::vector<std::string> columns;
};

/// What [observe] of a scene asks for.
[[nodiscard]] std::vector<StreamedTable> streamed_tables(const Scene& scene);

}  // namespace carom
