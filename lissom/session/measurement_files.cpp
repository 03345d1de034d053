#include "lissom/session/measurement_files.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <fmt/format.h>
#include <limits>
#include <utility>

#include "lissom/core/file_io.h"
#include "lissom/core/nearest_name.h"
#include "lissom/design/brief_space.h"
#include "lissom/model/csv_table.h"
#include "lissom/session/place_name.h"

namespace lissom {

namespace {

constexpr std::uintmax_t kLargestCsv = std::uintmax_t{64} << 20;  // bytes

constexpr std::string_view kPairsExample = "force [N], length [mm]";
constexpr std::string_view kShapesExample = "place, x [mm], y [mm], z [mm]";

/// A column of numbers.
struct Numbers {
  std::size_t column = 0;
  Unit unit;
};

class FileReader {
 public:
  FileReader(const Design& base, const std::filesystem::path& folder, std::vector<std::string>& notes)
      : base_(base), folder_(folder), notes_(notes) {}

  std::string where;  ///< of the entry

  Result<MeasurementData> operator()(const ForceLengthBrief& brief) {
    const Result<CsvTable> table = read(brief.file, where + "/force_length/file");
    if (!table) return table.error();
    const CsvTable& csv = table.value();
    ForceLengthData data;
    data.brief = brief;
    data.where = where;
    const bool change = !csv.find("length") && csv.find("displacement");
    if (change) data.meaning = ForceLengthData::Length::kChange;
    const Result<Numbers> force = numbers(csv, "force", Measure::kForce, kPairsExample);
    if (!force) return force.error();
    const Result<Numbers> length = numbers(csv, change ? "displacement" : "length", Measure::kLength, kPairsExample);
    if (!length) return length.error();
    const bool by_force = brief.prescribed == ForceLengthBrief::Prescribed::kForce;
    const Result<std::optional<Numbers>> sigma = sigmas(csv, by_force ? Measure::kLength : Measure::kForce);
    if (!sigma) return sigma.error();
    note_unread(csv, {"force", change ? "displacement" : "length", "sigma"});
    for (const CsvRow& row : csv.rows()) {
      ForceLengthPair pair;
      pair.where = csv.place(row);
      const Result<double> f = csv.number(row, force.value().column, force.value().unit);
      if (!f) return f.error();
      const Result<double> l = csv.number(row, length.value().column, length.value().unit);
      if (!l) return l.error();
      const Result<std::optional<double>> s = sigma_of(csv, row, sigma.value());
      if (!s) return s.error();
      pair.force = f.value();
      pair.length = l.value();
      pair.sigma = s.value();
      data.pairs.push_back(std::move(pair));
    }
    return MeasurementData(std::move(data));
  }

  Result<MeasurementData> operator()(const ShapesBrief& brief) {
    const Result<CsvTable> table = read(brief.file, where + "/shapes/file");
    if (!table) return table.error();
    const CsvTable& csv = table.value();
    ShapeData data;
    data.brief = brief;
    data.where = where;
    std::array<std::optional<Numbers>, 3> axes;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string name(1, "xyz"[i]);
      if (!csv.find(name)) continue;
      const Result<Numbers> axis = numbers(csv, name, Measure::kLength, kShapesExample);
      if (!axis) return axis.error();
      axes[i] = axis.value();
    }
    if (!axes[0] && !axes[1] && !axes[2]) return csv.required("x", kShapesExample).error();
    const Result<std::optional<Numbers>> sigma = sigmas(csv, Measure::kLength);
    if (!sigma) return sigma.error();
    note_unread(csv, {"pose", "place", "node", "x", "y", "z", "sigma"});
    for (const CsvRow& row : csv.rows()) {
      const Result<int> pose = pose_of(csv, row, brief.pose);
      if (!pose) return pose.error();
      Result<MeasuredPlace> place = place_of(csv, row, axes, sigma.value());
      if (!place) return place.error();
      shape(data, pose.value()).places.push_back(std::move(place).value());
    }
    return MeasurementData(std::move(data));
  }

 private:
  Result<CsvTable> read(const std::string& file, const std::string& place) const {
    const Result<std::string> text = read_file_below(folder_, file, kLargestCsv);
    if (text) return CsvTable::parse(text.value(), file);
    Error error = text.error();
    error.where = place;
    return error;
  }

  static Result<Numbers> numbers(const CsvTable& csv, std::string_view name, Measure measure,
                                 std::string_view example) {
    const Result<std::size_t> column = csv.required(name, example);
    if (!column) return column.error();
    Result<Unit> unit = csv.unit(column.value(), measure);
    if (!unit) return unit.error();
    return Numbers{column.value(), std::move(unit).value()};
  }

  static Result<std::optional<Numbers>> sigmas(const CsvTable& csv, Measure measure) {
    if (!csv.find("sigma")) return std::optional<Numbers>();
    Result<Numbers> found = numbers(csv, "sigma", measure, {});
    if (!found) return found.error();
    return std::optional<Numbers>(std::move(found).value());
  }

  static Result<std::optional<double>> sigma_of(const CsvTable& csv, const CsvRow& row,
                                                const std::optional<Numbers>& sigma) {
    if (!sigma) return std::optional<double>();
    const Result<double> value = csv.number(row, sigma->column, sigma->unit);
    if (!value) return value.error();
    if (value.value() > 0) return std::optional<double>(value.value());
    return Error{ErrorCode::kRange, csv.place(row, sigma->column), "a standard deviation has to be positive",
                 "give the uncertainty of the instrument, or leave the column out"};
  }

  Result<int> pose_of(const CsvTable& csv, const CsvRow& row, const std::string& otherwise) const {
    const std::vector<Pose>& poses = base_.model.poses;
    const std::optional<std::size_t> column = csv.find("pose");
    const std::string name = column ? row.cells[*column].text : otherwise;
    std::vector<std::string> known;
    for (std::size_t i = 0; i < poses.size(); ++i) {
      if (poses[i].name == name || (name.empty() && poses.size() == 1)) return static_cast<int>(i);
      known.push_back(poses[i].name);
    }
    const std::string place = column ? csv.place(row, *column) : csv.place(row);
    if (name.empty()) {
      return Error{ErrorCode::kUnknown, place, "it is not said which pose was measured",
                   "name it in a column \"pose\", or as \"pose\" in the document"};
    }
    return Error{ErrorCode::kUnknown, place, fmt::format("there is no pose \"{}\"", name), suggestion(name, known)};
  }

  Result<int> node_of(const CsvTable& csv, const CsvRow& row) const {
    const std::optional<std::size_t> by_place = csv.find("place"), by_node = csv.find("node");
    if (by_place && !row.cells[*by_place].text.empty()) {
      const std::string& text = row.cells[*by_place].text;
      const std::string place = csv.place(row, *by_place);
      const Result<Selector> selector = parse_place(base_.model, text, place);
      if (!selector) return selector.error();
      const Result<std::vector<int>> nodes = select(base_.model, base_.system.structure, selector.value(), place);
      if (!nodes) return nodes.error();
      if (nodes.value().size() == 1) return nodes.value().front();
      return Error{ErrorCode::kConflict, place, fmt::format("\"{}\" are {} nodes", text, nodes.value().size()),
                   "name one of them, such as \"beam:0.5\" or \"beam:end\""};
    }
    if (!by_node) return csv.required("place", kShapesExample).error();
    const std::string& text = row.cells[*by_node].text;
    const int count = static_cast<int>(base_.system.structure.nodes.size());
    int node = -1;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), node);
    if (code == std::errc() && end == text.data() + text.size() && node >= 0 && node < count) return node;
    return Error{ErrorCode::kUnknown, csv.place(row, *by_node), fmt::format("there is no node \"{}\"", text),
                 fmt::format("nodes have the numbers 0 to {}; names of places go into a column \"place\"", count - 1)};
  }

  Result<MeasuredPlace> place_of(const CsvTable& csv, const CsvRow& row,
                                 const std::array<std::optional<Numbers>, 3>& axes,
                                 const std::optional<Numbers>& sigma) const {
    MeasuredPlace place;
    place.where = csv.place(row);
    place.place.setConstant(std::numeric_limits<double>::quiet_NaN());
    const Result<int> node = node_of(csv, row);
    if (!node) return node.error();
    place.node = node.value();
    bool any = false;
    for (std::size_t i = 0; i < 3; ++i) {
      if (!axes[i] || row.cells[axes[i]->column].text.empty()) continue;
      const Result<double> value = csv.number(row, axes[i]->column, axes[i]->unit);
      if (!value) return value.error();
      place.place[static_cast<int>(i)] = value.value();
      any = true;
    }
    if (!any) {
      return Error{ErrorCode::kType, place.where, "no coordinate of this place is given",
                   "give one, or remove the row"};
    }
    const Result<std::optional<double>> own = sigma_of(csv, row, sigma);
    if (!own) return own.error();
    place.sigma = own.value();
    return place;
  }

  /// Of this pose, after those that were begun before.
  static ShapeData::Shape& shape(ShapeData& data, int pose) {
    for (ShapeData::Shape& known : data.shapes) {
      if (known.pose == pose) return known;
    }
    return data.shapes.emplace_back(ShapeData::Shape{pose, {}});
  }

  void note_unread(const CsvTable& csv, std::initializer_list<std::string_view> read) {
    for (const CsvColumn& column : csv.columns()) {
      if (column.name.empty() || std::find(read.begin(), read.end(), column.name) != read.end()) continue;
      notes_.push_back(fmt::format("column \"{}\" of {} was not read", column.name, csv.file()));
    }
  }

  const Design& base_;
  const std::filesystem::path& folder_;
  std::vector<std::string>& notes_;
};

}  // namespace

Result<MeasurementFiles> read_measurements(const Design& base, const std::filesystem::path& folder) {
  MeasurementFiles files;
  FileReader reader(base, folder, files.notes);
  const std::vector<MeasurementBrief>& entries = base.model.calibration->measurements;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    reader.where = fmt::format("/calibration/measurements/{}", i);
    Result<MeasurementData> data = std::visit(reader, entries[i]);
    if (!data) return data.error();
    files.data.push_back(std::move(data).value());
  }
  return files;
}

}  // namespace lissom
