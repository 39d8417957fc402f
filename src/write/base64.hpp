#pragma once
// Bytes as text: base64 [RFC 4648, section 4].

#include <string>
#include <string_view>

namespace carom {

void append_base64(std::string& text, std::string_view bytes);

}  // namespace carom
