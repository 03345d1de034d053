#pragma once
/// The files of measurements that a calibration names.

#include <filesystem>
#include <string>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/design/calibration_steps.h"

namespace lissom {

struct MeasurementFiles {
  std::vector<MeasurementData> data;  ///< one for each entry, in its order
  std::vector<std::string> notes;     ///< sentences worth telling: columns that were not read
};

/// Files are looked for in `folder`, that of the document, and below. Columns of pairs: force and length, or displacement; of
/// shapes: pose, place (as on the command line: a set, "beam:0.5") or node (a number, as in results), and x, y, z of which
/// an empty cell is not measured; of both: sigma. Errors name the entry, or file, line and column.
Result<MeasurementFiles> read_measurements(const Design& base, const std::filesystem::path& folder);

}  // namespace lissom
