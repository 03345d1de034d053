#pragma once
/// Named example structures. Each is a function that returns a model; the list is in scenes.cpp.

#include <span>
#include <string_view>

#include "lissom/model/model.h"

namespace lissom {

struct Scene {
  std::string_view name;
  std::string_view description;  ///< one sentence
  Model (*make)();
};

std::span<const Scene> scenes();

}  // namespace lissom
