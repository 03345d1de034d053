#pragma once
/// Tables of measurements as people export them: comma-separated text [RFC 4180] whose header names every column with its
/// unit, "force [N], length [mm]".

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/model/units.h"

namespace lissom {

struct CsvCell {
  std::string text;  ///< without spaces around it
  int column = 1;    ///< of its first character in the line, from 1
};

struct CsvRow {
  int line = 1;                ///< in the file, from 1
  std::vector<CsvCell> cells;  ///< as many as the header has
};

struct CsvColumn {
  std::string name;  ///< in lower case, without the unit
  std::string unit;  ///< between brackets or parentheses; empty: none
  int column = 1;    ///< of its first character in the line, from 1
};

class CsvTable {
 public:
  /// Separators are commas, semicolons or tabs, whichever the header has; quoted cells, blank lines and lines that begin with
  /// # are understood. Errors name "file:line:column": no header or no row, columns of one name, rows of another length.
  static Result<CsvTable> parse(std::string_view text, const std::string& file);

  const std::vector<CsvColumn>& columns() const { return columns_; }
  const std::vector<CsvRow>& rows() const { return rows_; }
  const std::string& file() const { return file_; }
  std::optional<std::size_t> find(std::string_view name) const;
  /// kUnknown where there is none of this name.
  Result<std::size_t> required(std::string_view name, std::string_view example) const;

  /// The unit of a column: kUnit, at the header, where it is missing, unknown or measures something else.
  Result<Unit> unit(std::size_t column, Measure measure) const;
  /// A cell in SI: kRange, at the cell, for what is no finite number.
  Result<double> number(const CsvRow& row, std::size_t column, const Unit& unit) const;

  /// "file:7" and "file:7:12".
  std::string place(const CsvRow& row) const;
  std::string place(const CsvRow& row, std::size_t column) const;

 private:
  std::string header_place(std::size_t column) const;

  std::string file_;
  int header_line_ = 1;
  std::vector<CsvColumn> columns_;
  std::vector<CsvRow> rows_;
};

}  // namespace lissom
