#include "apps/cli/input.h"

#include <vector>

#include "apps/cli/scene_list.h"
#include "lissom/core/nearest_name.h"

namespace lissom::cli {

Result<Document> read_input(const std::string& input) {
  constexpr std::string_view kScene = "scene:";
  if (!input.starts_with(kScene)) return read_document_file(input);
  const std::string name = input.substr(kScene.size());
  std::vector<std::string> known;
  for (const Scene& scene : scene_list()) {
    if (scene.name == name) return Document{name, {}, scene.make()};
    known.emplace_back(scene.name);
  }
  return Error{ErrorCode::kUnknown, input, "there is no scene \"" + name + "\"", suggestion(name, known)};
}

}  // namespace lissom::cli
