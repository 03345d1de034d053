#include "lissom/session/paraview.h"

#include <fmt/format.h>

#include "lissom/view/vtk_export.h"

namespace lissom {

Status write_series(const std::string& stem, const std::vector<double>& times,
                    const std::function<Result<Drawing>(int)>& drawing, Output& output) {
  std::vector<SeriesEntry> entries;
  for (int i = 0; i < static_cast<int>(times.size()); ++i) {
    const Result<Drawing> shape = drawing(i);
    if (!shape) return shape.error();
    const std::string name = fmt::format("{}-{:04}.vtu", stem, i);
    if (const Status s = output.write(name, vtu_bytes(shape.value(), times[i])); !s) return s;
    entries.push_back({times[i], name});
  }
  return output.write(stem + ".pvd", pvd_bytes(entries));
}

}  // namespace lissom
