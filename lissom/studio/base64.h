#pragma once
/// Base64 with padding [RFC 4648, 4]: how pages send pictures.

#include <optional>
#include <string>
#include <string_view>

namespace lissom {

/// Nothing where the text is no base64.
std::optional<std::string> from_base64(std::string_view text);

}  // namespace lissom
