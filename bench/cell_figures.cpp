/// How stiff a triangle, a square and a hexagon of rods are, and sheets of them [thesis, figures 5.2 and 5.3], in figures: rows
/// of name, metric, value, unit separated by tabs.
///
///     cell_figures [FOLDER]      FOLDER: receives cell-stiffness.png and cell-sheets.png
///
/// One side of each cell is held; a corner is put everywhere within a third of a side of its place, in the plane. Sheets of about
/// the same size with about as many cells of each shape hang from their upper side and carry the same weight at the lower one.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "bench/timing.h"
#include "lissom/core/file_io.h"
#include "lissom/equilibrium/settled.h"
#include "lissom/geometry/line_patterns.h"
#include "lissom/view/canvas.h"
#include "scenes/cells.h"
#include "scenes/parts.h"

namespace lissom {
namespace {

constexpr double kRadius = 1e-3;                        // m, of the rods of sheets
constexpr int kEdges = 10;                              // of a rod
constexpr int kGrid = 15;                               // places along each axis of a field
constexpr double kReach = scene_models::kCellSide / 3;  // m
constexpr double kSoft = 2e-4;                          // J, below which a place counts as easily reached
constexpr double kWeight = 1;                           // N, at the lower side of a sheet
constexpr double kCellArea = 1.1e-3;                    // m^2, of a cell of a sheet

/// Sheets of the shapes of scenes/cells.h, in their order.
struct SheetShape {
  ObjLines (*pattern)(double, int, int);
  double side;  ///< m, of a cell of kCellArea
  int columns, rows;
};
const std::array<SheetShape, 3>& sheet_shapes() {
  static const std::array<SheetShape, 3> all{{{triangle_pattern, std::sqrt(kCellArea / (std::sqrt(3.0) / 4)), 4, 5},
                                              {square_pattern, std::sqrt(kCellArea), 6, 6},
                                              {hexagon_pattern, std::sqrt(kCellArea / (1.5 * std::sqrt(3.0))), 6, 6}}};
  return all;
}

std::string name_of(std::size_t shape) { return std::string(scene_models::cell_shapes()[shape].name); }

struct Settled {
  System system;
  Equilibrium found;
};

/// The first pose of a model; nothing, with the reason on standard error, where it takes no stable shape.
std::optional<Settled> settle(const Model& model) {
  Result<System> system = make_system(model);
  if (!system) return std::fprintf(stderr, "%s\n", system.error().text().c_str()), std::nullopt;
  Result<Equilibrium> found = settled(model, system.value(), model.poses[0], "/poses/0", {});
  if (!found) return std::fprintf(stderr, "%s\n", found.error().text().c_str()), std::nullopt;
  if (found.value().verdict != Verdict::kStable) {
    return std::fprintf(stderr, "%s: %s\n", model.title.c_str(), found.value().message.c_str()), std::nullopt;
  }
  return Settled{std::move(system).value(), std::move(found).value()};
}

/// Elastic energy of a cell with its corner moved, J; nothing where no stable shape was found.
std::optional<double> energy_at(std::size_t shape, const Vec2& by) {
  const std::optional<Settled> cell = settle(scene_models::moved_cell(scene_models::cell_shapes()[shape], by));
  return cell ? std::optional<double>(cell->found.energy) : std::nullopt;
}

struct FieldOfEnergies {
  std::vector<double> value;  ///< J, (kGrid x kGrid), rows along x from the lowest; NaN: no stable shape
};

Vec2 place(int i, int j) { return kReach * (2 * Vec2(i, j) / (kGrid - 1) - Vec2::Ones()); }

FieldOfEnergies field_of(std::size_t shape) {
  FieldOfEnergies field;
  int soft = 0;
  for (int j = 0; j < kGrid; ++j) {
    for (int i = 0; i < kGrid; ++i) {
      const std::optional<double> energy = energy_at(shape, place(i, j));
      field.value.push_back(energy.value_or(std::numeric_limits<double>::quiet_NaN()));
      soft += energy && *energy < kSoft ? 1 : 0;
    }
  }
  row(name_of(shape), "easily reached part of the field", 100.0 * soft / (kGrid * kGrid), "%");
  for (const auto& [what, by] :
       {std::pair("pulled up by a sixth of a side", Vec2(0, scene_models::kCellSide / 6)),
        std::pair("pulled aside by a sixth of a side", Vec2(scene_models::kCellSide / 6, 0))}) {
    row(name_of(shape), what, 1e3 * energy_at(shape, by).value_or(std::numeric_limits<double>::quiet_NaN()), "mJ");
  }
  return field;
}

constexpr Color kInk{0.1, 0.1, 0.12}, kPaper{1, 1, 1}, kFaint{0.7, 0.7, 0.72};

Result<std::string> draw_fields(const std::vector<FieldOfEnergies>& fields) {
  constexpr int kPanel = 420, kHeight = 470;
  constexpr double kScale = 5200;  // px/m
  Canvas canvas(ImageFormat::kPng, kPanel * static_cast<int>(fields.size()) + 110, kHeight);
  canvas.fill(kPaper);
  const ColorRange range{-7, -2};  // of the logarithm
  for (std::size_t f = 0; f < fields.size(); ++f) {
    const scene_models::CellShape& shape = scene_models::cell_shapes()[f];
    const std::vector<Vec2> corners = scene_models::cell_corners(shape);
    const Vec2 origin(kPanel * (static_cast<double>(f) + 0.5), kHeight - 70);
    const auto px = [&](const Vec2& x) { return Vec2(origin[0] + kScale * x[0], origin[1] - kScale * x[1]); };
    const double cell = 2 * kReach / (kGrid - 1);
    for (int j = 0; j < kGrid; ++j) {
      for (int i = 0; i < kGrid; ++i) {
        const double energy = fields[f].value[static_cast<std::size_t>(j * kGrid + i)];
        const Vec2 at = corners[static_cast<std::size_t>(shape.moved)] + place(i, j) + Vec2(-cell / 2, cell / 2);
        const Color color = std::isfinite(energy)
                                ? range.color(Field::Colors::kSequential, std::log10(std::max(energy, 1e-9)))
                                : kNoValueColor;
        canvas.rectangle(px(at), Vec2::Constant(kScale * cell + 0.5), color);
      }
    }
    std::vector<Vec2> outline;
    for (const Vec2& x : corners) outline.push_back(px(x));
    canvas.outline(outline, {kInk, 5});
    canvas.polyline(std::vector<Vec2>{outline[0], outline[1]}, {kInk, 11});
    canvas.disc(outline[static_cast<std::size_t>(shape.moved)], 9, kInk);
    canvas.text(Vec2(origin[0], kHeight - 24), name_of(f), {18, kInk, TextStyle::Weight::kBold, 0.5});
  }
  const double x = kPanel * static_cast<double>(fields.size()) + 20;
  std::vector<Color> colors;
  for (int k = 0; k <= 16; ++k) colors.push_back(map_color(Field::Colors::kSequential, k / 16.0));
  canvas.gradient(Vec2(x, 60), Vec2(18, 300), colors);
  for (int decade = -7; decade <= -2; ++decade) {
    const double y = 360 - 300 * (decade + 7) / 5.0;
    canvas.text(Vec2(x + 24, y), "1e" + std::to_string(decade + 3), {13, kInk, TextStyle::Weight::kRegular, 0, 0.5});
  }
  canvas.text(Vec2(x, 46), "energy, mJ", {13, kInk});
  return canvas.finish("Energy of cells whose corner is moved");
}

enum class HungBy { kUpperSide, kUpperCorners };

Selector joints_where(const ObjLines& lines, const std::function<bool(const Vec3&)>& wanted) {
  Selector all;
  all.kind = Selector::Kind::kUnion;
  for (const Vec3& x : lines.points) {
    if (wanted(x)) all.parts.push_back(scene_models::at_point(x));
  }
  return all;
}

/// Joints of the upper side, or the outermost two of them, are held; the weight hangs from those of the lower side.
Pose hung_pose(const ObjLines& lines, const Vec3& low, const Vec3& high, HungBy by) {
  constexpr double kNear = 1e-6;  // m
  double left = high[0], right = low[0];
  for (const Vec3& x : lines.points) {
    if (x[1] < high[1] - kNear) continue;
    left = std::min(left, x[0]);
    right = std::max(right, x[0]);
  }
  const auto held = [&](const Vec3& x) {
    const bool corner = x[0] < left + kNear || x[0] > right - kNear;
    return x[1] > high[1] - kNear && (by == HungBy::kUpperSide || corner);
  };
  Pose pose;
  pose.name = "hung";
  pose.supports = {scene_models::held_in_plane(), scene_models::hold(joints_where(lines, held), SupportKind::kPin)};
  pose.forces = {{joints_where(lines, [&](const Vec3& x) { return x[1] < low[1] + kNear; }), Vec3(0, -kWeight, 0), true,
                  Scaling::kProportional}};
  return pose;
}

std::optional<Settled> hang(std::size_t number, HungBy by) {
  const SheetShape& shape = sheet_shapes()[number];
  const ObjLines lines = shape.pattern(shape.side, shape.columns, shape.rows);
  Vec3 low = lines.points.front(), high = low;
  for (const Vec3& x : lines.points) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  Model model = scene_models::sheet(name_of(number), lines, kRadius, "TPU 92A", kEdges);
  model.poses = {hung_pose(lines, low, high, by)};
  std::optional<Settled> sheet = settle(model);
  if (!sheet) return std::nullopt;
  // The weight's work by the weight: the mean way of the loaded joints.
  const Structure& structure = sheet->system.structure;
  const Result<std::vector<int>> loaded = select(model, structure, model.poses[0].forces[0].at, "loaded");
  if (!loaded) return std::fprintf(stderr, "%s\n", loaded.error().text().c_str()), std::nullopt;
  double lowered = 0;
  for (const int n : loaded.value()) {
    lowered += (structure.nodes[static_cast<std::size_t>(n)] - sheet->found.state.position(n))[1];
  }
  const std::string name =
      "sheet of " + name_of(number) + "s by its upper " + (by == HungBy::kUpperSide ? "side" : "corners");
  row(name, "height", 1e3 * (high[1] - low[1]), "mm");
  row(name, "cells", static_cast<double>(lines.segments.size()) - static_cast<double>(lines.points.size()) + 1, "");
  row(name, "lowered by", 1e3 * lowered / static_cast<double>(loaded.value().size()), "mm");
  return sheet;
}

Result<std::string> draw_sheets(const std::vector<Settled>& sheets) {
  constexpr int kPanel = 420, kHeight = 480;
  constexpr double kScale = 1500;  // px/m
  Canvas canvas(ImageFormat::kPng, kPanel * static_cast<int>(sheets.size()), kHeight);
  canvas.fill(kPaper);
  for (std::size_t f = 0; f < sheets.size(); ++f) {
    const Structure& structure = sheets[f].system.structure;
    const auto px = [&](const Vec3& x) {
      return Vec2(kPanel * (static_cast<double>(f) + 0.5) + kScale * x[0], 200 - kScale * x[1]);
    };
    for (const bool deformed : {false, true}) {
      for (const StructureRod& rod : structure.rods) {
        std::vector<Vec2> line;
        for (const int node : rod.nodes) {
          line.push_back(
              px(deformed ? sheets[f].found.state.position(node) : structure.nodes[static_cast<std::size_t>(node)]));
        }
        canvas.polyline(line, {deformed ? Color{0.0, 0.45, 0.7} : kFaint, deformed ? 3.0 : 1.5});
      }
    }
    canvas.text(Vec2(kPanel * (static_cast<double>(f) + 0.5), kHeight - 20), name_of(f) + "s",
                {18, kInk, TextStyle::Weight::kBold, 0.5});
  }
  return canvas.finish("Sheets of triangles, squares and hexagons that carry the same weight");
}

int write(const std::filesystem::path& file, const Result<std::string>& bytes) {
  if (!bytes) return std::fprintf(stderr, "%s\n", bytes.error().text().c_str()), 1;
  const Status status = write_file(file, bytes.value());
  if (!status) return std::fprintf(stderr, "%s\n", status.error().text().c_str()), 1;
  return 0;
}

int run(const char* folder) {
  std::vector<FieldOfEnergies> fields;
  std::vector<Settled> sheets;
  for (std::size_t shape = 0; shape < sheet_shapes().size(); ++shape) {
    fields.push_back(field_of(shape));
    hang(shape, HungBy::kUpperSide);
    std::optional<Settled> sheet = hang(shape, HungBy::kUpperCorners);
    if (!sheet) return 1;
    sheets.push_back(std::move(*sheet));
  }
  if (folder == nullptr) return 0;
  const std::filesystem::path to(folder);
  return write(to / "cell-stiffness.png", draw_fields(fields)) + write(to / "cell-sheets.png", draw_sheets(sheets));
}

}  // namespace
}  // namespace lissom

int main(int argc, char** argv) { return lissom::run(argc > 1 ? argv[1] : nullptr); }
