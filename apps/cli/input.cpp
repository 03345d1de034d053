#include "apps/cli/input.h"

#include <vector>

#include "lissom/core/file_io.h"
#include "lissom/core/nearest_name.h"
#include "scenes/scenes.h"

namespace lissom::cli {

namespace {
constexpr std::string_view kScene = "scene:";
}

Result<Document> read_input(const std::string& input) {
  if (std::filesystem::path(input).extension() == ".obj") {
    return Error{ErrorCode::kUnsupported, input, "a drawing has no materials, sections and supports",
                 "name it in the networks of a document, or make one with `lissom convert`"};
  }
  if (!input.starts_with(kScene)) return read_document_file(input);
  const std::string name = input.substr(kScene.size());
  std::vector<std::string> known;
  for (const Scene& scene : scenes()) {
    if (scene.name == name) return Document{name, {}, scene.make()};
    known.emplace_back(scene.name);
  }
  return Error{ErrorCode::kUnknown, input, "there is no scene \"" + name + "\"", suggestion(name, known)};
}

Result<SavedResult> read_saved(const std::string& path) {
  const Result<std::string> text = read_file(path);
  if (!text) return text.error();
  return read_result(text.value(), path);
}

Result<Drawable> read_drawable(const std::string& input, const std::string& pose) {
  if (!input.starts_with(kScene)) {
    const Result<std::string> text = read_file(input);
    if (!text) return text.error();
    if (is_result(text.value())) {
      Result<SavedResult> saved = read_result(text.value(), input);
      if (!saved) return saved.error();
      return make_drawable(std::move(saved).value());
    }
  }
  Result<Document> document = read_input(input);
  if (!document) return document.error();
  return make_drawable(std::move(document).value(), pose);
}

}  // namespace lissom::cli
