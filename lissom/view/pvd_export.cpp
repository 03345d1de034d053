#include <cmath>
#include <fmt/format.h>

#include "lissom/view/text.h"
#include "lissom/view/vtk_export.h"

namespace lissom {

Result<std::string> pvd_bytes(std::span<const SeriesEntry> entries) {
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
      "<Collection>\n";
  for (const SeriesEntry& entry : entries) {
    if (!std::isfinite(entry.time)) {
      return Error{ErrorCode::kRange, fmt::format("state \"{}\"", entry.file), "its time is not a finite number", ""};
    }
    text += "<DataSet timestep=\"";
    append_number(text, entry.time);
    text += fmt::format("\" group=\"\" part=\"0\" file=\"{}\"/>\n", xml_escaped(entry.file));
  }
  return text + "</Collection>\n</VTKFile>\n";
}

}  // namespace lissom
