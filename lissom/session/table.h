#pragma once
/// Tables of numbers as CSV: a header with units in the names, numbers in full.

#include <string>
#include <vector>

namespace lissom {

struct Table {
  std::vector<std::string> columns;       ///< "load_factor", "displacement_m", ...
  std::vector<std::vector<double>> rows;  ///< each as long as `columns`; NaN: an empty cell
};

std::string csv_text(const Table& table);

}  // namespace lissom
