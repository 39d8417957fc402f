#pragma once
// The page of `carom view`, written as its data come.

#include <string>
#include <string_view>

#include "carom/write/output_file.hpp"
#include "page_parts.hpp"
#include "write/json_text.hpp"

namespace carom::app {

/// The page with `elements` as its data. No text of theirs can end a script: "<" is escaped.
class ViewPage {
 public:
  /// Writes what comes before the data. Throws OutputError.
  ViewPage(std::string path, const PageParts& parts, int dimension);

  void json(std::string_view id, const Json& object);
  void bytes(std::string_view id, std::string_view data);
  void chunk(std::string_view data);

  [[nodiscard]] bool failed() const noexcept { return file_.failed(); }

  /// Writes what comes after the data. Throws OutputError if anything could not be written.
  void finish();

 private:
  void element(std::string_view attributes, std::string_view text);

  OutputFile file_;
  const PageParts& parts_;
  int dimension_;
};

/// The page of a run that has only begun: its log is fetched from the server that the page comes from.
[[nodiscard]] std::string live_page(const PageParts& parts, int dimension, const Json& scene, std::string_view start);

/// JSON that may stand in a script of an HTML page.
[[nodiscard]] std::string json_in_page(const Json& object);

}  // namespace carom::app
