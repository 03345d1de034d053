#pragma once
/// A document that travels inside a program.

#include <string_view>

namespace lissom {

struct DesignText {
  std::string_view name;   ///< "butterfly"
  std::string_view title;  ///< "Butterfly"
  std::string_view text;   ///< of the document
};

}  // namespace lissom
