#include "apps/cli/arguments.h"

#include "apps/cli/terminal.h"

namespace lissom::cli {

std::optional<Vec3> axis_named(const std::string& name) {
  if (name.empty()) return std::nullopt;
  return Vec3::Unit(name == "x" ? 0 : name == "y" ? 1 : 2);
}

Viewpoint camera_named(const std::string& name) {
  return name == "top"     ? Viewpoint::top()
         : name == "front" ? Viewpoint::front()
         : name == "right" ? Viewpoint::right()
                           : Viewpoint::iso();
}

ImageFormat format_named(const std::string& name) { return name == "svg" ? ImageFormat::kSvg : ImageFormat::kPng; }

void print_json_list(const std::string& name, const std::vector<std::string>& entries) {
  std::string text = "{\"" + name + "\": [";
  for (size_t i = 0; i < entries.size(); ++i) text += (i > 0 ? ",\n  " : "\n  ") + entries[i];
  print(text + "\n]}\n");
}

}  // namespace lissom::cli
