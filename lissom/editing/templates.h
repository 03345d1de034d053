#pragma once
/// Plans to begin with. Each is stable when released and stands up well (tests/unit/templates_test.cpp).

#include <span>
#include <string_view>

#include "lissom/model/model.h"

namespace lissom {

struct Template {
  std::string_view name;      ///< "disc"
  std::string_view title;     ///< "Disc"
  std::string_view sentence;  ///< what it is, for people
  Model (*make)();
};

std::span<const Template> templates();

}  // namespace lissom
