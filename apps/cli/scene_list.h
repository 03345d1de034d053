#pragma once
/// The scenes that this build has.

#include <span>

#if __has_include("scenes/scenes.h")
#include "scenes/scenes.h"
#else
#include <string_view>

#include "lissom/model/model.h"
namespace lissom {
struct Scene {
  std::string_view name, description;
  Model (*make)();
};
}  // namespace lissom
#endif

namespace lissom::cli {

inline std::span<const Scene> scene_list() {
#if __has_include("scenes/scenes.h")
  return scenes();
#else
  return {};
#endif
}

}  // namespace lissom::cli
