#include "lissom/model/csv_table.h"

#include <algorithm>
#include <fmt/format.h>

#include "lissom/core/nearest_name.h"

namespace lissom {

namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r'; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

/// Text as it may be shown to people: short and printable.
std::string shown(std::string_view text) {
  std::string out;
  for (const char c : text.substr(0, 24)) out += static_cast<unsigned char>(c) < ' ' || c == '\x7f' ? '?' : c;
  return text.size() > 24 ? out + "..." : out;
}

/// Whichever separator the header has most of.
char separator_of(std::string_view header) {
  char best = ',';
  for (const char c : {';', '\t'}) {
    if (std::count(header.begin(), header.end(), c) > std::count(header.begin(), header.end(), best)) best = c;
  }
  return best;
}

/// The cells of a line; nothing where a quote stays open.
std::optional<std::vector<CsvCell>> cells_of(std::string_view line, char separator) {
  std::vector<CsvCell> cells;
  std::size_t at = 0;
  while (true) {
    std::size_t begin = at;
    while (begin < line.size() && is_space(line[begin]) && line[begin] != separator) ++begin;
    CsvCell cell{{}, static_cast<int>(begin) + 1};
    if (begin < line.size() && line[begin] == '"') {
      for (at = begin + 1;; ++at) {
        if (at >= line.size()) return std::nullopt;
        if (line[at] != '"') {
          cell.text += line[at];
        } else if (at + 1 < line.size() && line[at + 1] == '"') {
          cell.text += line[at++];
        } else {
          break;
        }
      }
      at = std::min(line.find(separator, at), line.size());
    } else {
      at = std::min(line.find(separator, begin), line.size());
      cell.text = trimmed(line.substr(begin, at - begin));
    }
    cells.push_back(std::move(cell));
    if (at >= line.size()) return cells;
    ++at;
  }
}

/// "Force [N]" -> "force", "N".
CsvColumn column_of(const CsvCell& cell) {
  CsvColumn column{{}, {}, cell.column};
  std::string_view name = cell.text;
  for (const auto& [open, close] : {std::pair{'[', ']'}, std::pair{'(', ')'}}) {
    const std::size_t begin = name.find(open);
    if (begin == std::string_view::npos || name.back() != close) continue;
    column.unit = trimmed(name.substr(begin + 1, name.size() - begin - 2));
    name = trimmed(name.substr(0, begin));
    break;
  }
  for (const char c : name) column.name += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return column;
}

}  // namespace

Result<CsvTable> CsvTable::parse(std::string_view text, const std::string& file) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  CsvTable table;
  table.file_ = file;
  char separator = ',';
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (trimmed(line).empty() || trimmed(line).starts_with('#')) continue;
    const bool header = table.columns_.empty();
    if (header) separator = separator_of(line);
    std::optional<std::vector<CsvCell>> cells = cells_of(line, separator);
    if (!cells) {
      return Error{ErrorCode::kSyntax, fmt::format("{}:{}", file, number), "a quotation mark is not closed",
                   "close it in the same line"};
    }
    if (header) {
      table.header_line_ = number;
      for (const CsvCell& cell : *cells) {
        table.columns_.push_back(column_of(cell));
        const std::string& name = table.columns_.back().name;
        const auto same = [&name](const CsvColumn& c) { return c.name == name && !name.empty(); };
        if (std::count_if(table.columns_.begin(), table.columns_.end(), same) < 2) continue;
        return Error{ErrorCode::kConflict, table.header_place(table.columns_.size() - 1),
                     fmt::format("two columns are called \"{}\"", shown(name)), "rename or remove one of them"};
      }
      continue;
    }
    if (cells->size() != table.columns_.size()) {
      return Error{ErrorCode::kType, fmt::format("{}:{}", file, number),
                   fmt::format("this row has {} cells, the header {}", cells->size(), table.columns_.size()),
                   separator == ',' ? "write decimal points, not commas, and one cell for each column"
                                    : "write one cell for each column"};
    }
    table.rows_.push_back({number, std::move(*cells)});
  }
  if (table.columns_.empty()) {
    return Error{ErrorCode::kType, file, "the file is empty", "begin with a header such as \"force [N], length [mm]\""};
  }
  if (table.rows_.empty()) {
    return Error{ErrorCode::kType, fmt::format("{}:{}", file, table.header_line_), "there are no rows after the header",
                 "add one row for each measurement"};
  }
  return table;
}

std::optional<std::size_t> CsvTable::find(std::string_view name) const {
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (columns_[i].name == name) return i;
  }
  return std::nullopt;
}

Result<std::size_t> CsvTable::required(std::string_view name, std::string_view example) const {
  if (const std::optional<std::size_t> found = find(name)) return *found;
  std::vector<std::string> known;
  for (const CsvColumn& column : columns_) known.push_back(column.name);
  const std::string near = nearest_name(std::string(name), known);
  return Error{ErrorCode::kUnknown, fmt::format("{}:{}", file_, header_line_),
               fmt::format("there is no column \"{}\"", name),
               near.empty() ? fmt::format("begin the file with a header such as \"{}\"", example)
                            : fmt::format("is it the one called \"{}\"?", shown(near))};
}

std::string CsvTable::header_place(std::size_t column) const {
  return fmt::format("{}:{}:{}", file_, header_line_, columns_[column].column);
}

std::string CsvTable::place(const CsvRow& row) const { return fmt::format("{}:{}", file_, row.line); }

std::string CsvTable::place(const CsvRow& row, std::size_t column) const {
  return fmt::format("{}:{}:{}", file_, row.line, row.cells[column].column);
}

Result<Unit> CsvTable::unit(std::size_t column, Measure measure) const {
  const CsvColumn& own = columns_[column];
  if (own.unit.empty()) {
    return Error{ErrorCode::kUnit, header_place(column), fmt::format("the column \"{}\" has no unit", shown(own.name)),
                 fmt::format("write \"{} [{}]\", for example", own.name, measure == Measure::kLength ? "mm" : "N")};
  }
  Result<Unit> unit = parse_unit(own.unit);
  Error error;
  if (!unit) {
    error = unit.error();
  } else if (!compatible(dimension(measure), unit.value().dimension)) {
    error = wrong_dimension(measure, unit.value().dimension);
    // What scales show.
    const bool weighed = measure == Measure::kForce && unit.value().dimension == dimension(Measure::kMass);
    if (weighed) error.hint = "write gf or kgf for the weight of a mass";
  } else {
    return unit;
  }
  error.where = header_place(column);
  error.message = fmt::format("column \"{}\": {}", shown(own.name), error.message);
  return error;
}

Result<double> CsvTable::number(const CsvRow& row, std::size_t column, const Unit& unit) const {
  Result<double> number = to_si(row.cells[column].text, unit);
  if (number) return number;
  const std::string& text = row.cells[column].text;
  const bool comma = text.find(',') != std::string::npos;
  return Error{ErrorCode::kRange, place(row, column),
               text.empty() ? fmt::format("the cell under \"{}\" is empty", shown(columns_[column].name))
                            : fmt::format("\"{}\" is not a finite number", shown(text)),
               comma ? "write a decimal point" : "correct it or remove the row"};
}

}  // namespace lissom
