#include "apps/cli/arguments.h"

#include "apps/cli/terminal.h"
#include "lissom/model/units.h"

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

Result<double> length_of(const std::string& text, const char* option) {
  const Result<Quantity> quantity = parse_quantity(text);
  if (quantity && quantity.value().unit.dimension == dimension(Measure::kLength) && quantity.value().value > 0) {
    return quantity.value().value;
  }
  return Error{ErrorCode::kUnit, option, "\"" + text + "\" is not a length",
               "write a number with its unit, such as \"5 mm\""};
}

void print_json_list(const std::string& name, const std::vector<std::string>& entries) {
  std::string text = "{\"" + name + "\": [";
  for (size_t i = 0; i < entries.size(); ++i) text += (i > 0 ? ",\n  " : "\n  ") + entries[i];
  print(text + "\n]}\n");
}

}  // namespace lissom::cli
