#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

#include "lissom/model/plan_dxf.h"

namespace lissom {

namespace {

/// Collects groups; hands out handles.
class Dxf {
 public:
  Dxf& text(int code, std::string_view value) {
    out_ += fmt::format("{}\n{}\n", code, value);
    return *this;
  }
  Dxf& whole(int code, int value) { return text(code, std::to_string(value)); }
  Dxf& real(int code, double value) { return text(code, fmt::format("{:.12g}", value == 0 ? 0.0 : value)); }
  /// In millimetres.
  Dxf& point(int code, const Vec2& p) { return real(code, 1000 * p.x()).real(code + 10, 1000 * p.y()); }
  Dxf& handle() { return text(5, fmt::format("{:X}", ++handle_)); }
  int last_handle() const { return handle_; }
  std::string& bytes() { return out_; }

 private:
  std::string out_;
  int handle_ = 0x20;
};

void table(Dxf& dxf, std::string_view name, const std::vector<std::string>& entries, std::string_view kind,
           const auto& rest) {
  dxf.text(0, "TABLE").text(2, name).handle().text(100, "AcDbSymbolTable").whole(70, static_cast<int>(entries.size()));
  if (name == "DIMSTYLE") dxf.text(100, "AcDbDimStyleTable");
  for (const std::string& entry : entries) {
    dxf.text(0, name);
    if (name == "DIMSTYLE") {
      dxf.text(105, fmt::format("{:X}", 0x1000));
    } else {
      dxf.handle();
    }
    dxf.text(100, "AcDbSymbolTableRecord").text(100, kind).text(2, entry);
    if (name != "BLOCK_RECORD") dxf.whole(70, 0);
    rest(entry);
  }
  dxf.text(0, "ENDTAB");
}

void tables(Dxf& dxf) {
  const auto nothing = [](const std::string&) {};
  dxf.text(0, "SECTION").text(2, "TABLES");
  table(dxf, "VPORT", {}, "AcDbViewportTableRecord", nothing);
  table(dxf, "LTYPE", {"ByBlock", "ByLayer", "Continuous"}, "AcDbLinetypeTableRecord",
        [&](const std::string&) { dxf.text(3, "").whole(72, 65).whole(73, 0).real(40, 0); });
  table(dxf, "LAYER",
        {"0", std::string(kRodLayer), std::string(kGhostLayer), std::string(kFrameLayer), std::string(kMarkLayer)},
        "AcDbLayerTableRecord", [&](const std::string& name) {
          dxf.whole(62, name == kGhostLayer                         ? 8
                        : name == kFrameLayer || name == kMarkLayer ? 5
                                                                    : 7)
              .text(6, "Continuous");
        });
  table(dxf, "STYLE", {"Standard"}, "AcDbTextStyleTableRecord", [&](const std::string&) {
    dxf.real(40, 0).real(41, 1).real(50, 0).whole(71, 0).real(42, 2.5).text(3, "txt").text(4, "");
  });
  table(dxf, "VIEW", {}, "AcDbViewTableRecord", nothing);
  table(dxf, "UCS", {}, "AcDbUCSTableRecord", nothing);
  table(dxf, "APPID", {"ACAD", "LISSOM"}, "AcDbRegAppTableRecord", nothing);
  table(dxf, "DIMSTYLE", {"Standard"}, "AcDbDimStyleTableRecord", nothing);
  table(dxf, "BLOCK_RECORD", {"*Model_Space", "*Paper_Space"}, "AcDbBlockTableRecord", nothing);
  dxf.text(0, "ENDSEC");
  dxf.text(0, "SECTION").text(2, "BLOCKS");
  for (const char* name : {"*Model_Space", "*Paper_Space"}) {
    dxf.text(0, "BLOCK").handle().text(100, "AcDbEntity").text(8, "0").text(100, "AcDbBlockBegin").text(2, name);
    dxf.whole(70, 0).point(10, Vec2::Zero()).real(30, 0).text(3, name).text(1, "");
    dxf.text(0, "ENDBLK").handle().text(100, "AcDbEntity").text(8, "0").text(100, "AcDbBlockEnd");
  }
  dxf.text(0, "ENDSEC");
}

Dxf& entity(Dxf& dxf, std::string_view name, std::string_view layer, std::string_view kind) {
  return dxf.text(0, name).handle().text(100, "AcDbEntity").text(8, layer).text(100, kind);
}

void polyline(Dxf& dxf, const DrawnLine& line, std::string_view layer) {
  const int vertices = static_cast<int>(line.path.size()) + (line.closed ? 0 : 1);
  entity(dxf, "LWPOLYLINE", layer, "AcDbPolyline").whole(90, vertices).whole(70, line.closed ? 1 : 0);
  if (line.r_b) dxf.real(43, 2000 * *line.r_b);
  for (const PathPiece& piece : line.path) {
    dxf.point(10, piece.from);
    if (piece.kind == PathPiece::Kind::kArc) dxf.real(42, std::tan(sweep_of(piece) / 4));
  }
  if (!line.closed) dxf.point(10, line.path.back().to);
}

/// Bezier pieces as a spline with triple knots.
void spline(Dxf& dxf, const DrawnLine& line, std::string_view layer) {
  const int pieces = static_cast<int>(line.path.size());
  entity(dxf, "SPLINE", layer, "AcDbSpline").whole(70, line.closed ? 9 : 8).whole(71, 3);
  dxf.whole(72, 3 * pieces + 5).whole(73, 3 * pieces + 1).whole(74, 0);
  for (int k = 0; k <= pieces; ++k) {
    for (int i = 0; i < (k == 0 || k == pieces ? 4 : 3); ++i) dxf.real(40, k);
  }
  dxf.point(10, line.path.front().from).real(30, 0);
  for (const PathPiece& piece : line.path) {
    for (const Vec2& p : {piece.a, piece.b, piece.to}) dxf.point(10, p).real(30, 0);
  }
}

void straight(Dxf& dxf, const Vec2& from, const Vec2& to, std::string_view layer) {
  entity(dxf, "LINE", layer, "AcDbLine").point(10, from).real(30, 0).point(11, to).real(31, 0);
}

void marks(Dxf& dxf, const PlanDrawing& drawing) {
  const DrawingFrame frame = frame_of(drawing);
  const Vec2 &low = frame.frame_low, &high = frame.frame_high;
  DrawnLine box;
  box.closed = true;
  const std::array<Vec2, 4> corner{low, Vec2(high.x(), low.y()), high, Vec2(low.x(), high.y())};
  for (std::size_t k = 0; k < 4; ++k) box.path.push_back(PathPiece::line(corner[k], corner[(k + 1) % 4]));
  polyline(dxf, box, kFrameLayer);
  constexpr double kRuler = 0.1, kBelow = 0.01;  // m
  const Vec2 start = low - Vec2(0, kBelow);
  straight(dxf, start, start + Vec2(kRuler, 0), kMarkLayer);
  for (int k = 0; k <= 10; ++k) {
    const Vec2 foot = start + Vec2(k * kRuler / 10, 0);
    straight(dxf, foot, foot + Vec2(0, k % 5 == 0 ? 4e-3 : 2e-3), kMarkLayer);
  }
  entity(dxf, "TEXT", kMarkLayer, "AcDbText")
      .point(10, start - Vec2(0, 5e-3))
      .real(30, 0)
      .real(40, 4)
      .text(1, "100 mm");
  dxf.text(100, "AcDbText");
}

/// Text of one group stays on its line.
std::string one_line(std::string_view name) {
  std::string text(name.substr(0, 200));
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  return text;
}

}  // namespace

std::string write_dxf_drawing(const PlanDrawing& drawing) {
  Dxf dxf;
  tables(dxf);
  dxf.text(0, "SECTION").text(2, "ENTITIES");
  for (const DrawnLine& line : drawing.lines) {
    if (line.path.empty()) continue;
    const std::string_view layer = line.role == PlanRole::kGhost ? kGhostLayer : kRodLayer;
    if (line.path.front().kind == PathPiece::Kind::kCubic) {
      spline(dxf, line, layer);
    } else {
      polyline(dxf, line, layer);
    }
    dxf.text(1001, "LISSOM").text(1000, one_line(line.name));
    if (line.r_n && line.r_b) dxf.real(1040, 1000 * *line.r_n).real(1040, 1000 * *line.r_b);
  }
  marks(dxf, drawing);
  dxf.text(0, "ENDSEC");
  dxf.text(0, "SECTION").text(2, "OBJECTS");
  dxf.text(0, "DICTIONARY").handle().text(100, "AcDbDictionary").whole(281, 1);
  dxf.text(0, "ENDSEC").text(0, "EOF");
  Dxf head;
  head.text(0, "SECTION").text(2, "HEADER").text(9, "$ACADVER").text(1, "AC1015");
  head.text(9, "$HANDSEED").text(5, fmt::format("{:X}", std::max(dxf.last_handle(), 0x1000) + 1));
  head.text(9, "$INSUNITS").whole(70, 4).text(9, "$MEASUREMENT").whole(70, 1).text(0, "ENDSEC");
  return head.bytes() + dxf.bytes();
}

}  // namespace lissom
