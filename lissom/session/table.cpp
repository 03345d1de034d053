#include "lissom/session/table.h"

#include <cmath>
#include <fmt/format.h>

namespace lissom {

std::string csv_text(const Table& table) {
  std::string text;
  for (size_t i = 0; i < table.columns.size(); ++i) text += (i > 0 ? "," : "") + table.columns[i];
  text += '\n';
  for (const std::vector<double>& row : table.rows) {
    for (size_t i = 0; i < row.size(); ++i) {
      if (i > 0) text += ',';
      if (!std::isnan(row[i])) text += fmt::format("{}", row[i]);
    }
    text += '\n';
  }
  return text;
}

}  // namespace lissom
