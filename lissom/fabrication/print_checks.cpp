#include "lissom/fabrication/print_checks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "lissom/fabrication/near_rods.h"

namespace lissom {

namespace {

using Weight = PrintFinding::Weight;

std::vector<PrintFinding> thin_rods(const Structure& structure, const std::vector<RodPiece>& pieces,
                                    const PrintProcess& process) {
  std::vector<PrintFinding> findings;
  int rod = -1;
  for (const RodPiece& piece : pieces) {
    for (const RodStation& s : piece.stations) {
      const double diameter = 2 * std::min(s.r_b, s.r_n);
      if (diameter >= process.diameter * (1 - 1e-9)) continue;
      const bool same = rod == piece.rod && !findings.empty();
      if (same && diameter >= findings.back().value) continue;
      if (!same) findings.emplace_back();
      rod = piece.rod;
      findings.back() = {
          Weight::kError, "thin rod", print_place(structure.rods[rod].name, s.centre), diameter,
          fmt::format("it is {:.3g} mm thick there; {} wants {:.3g} mm: make it thicker or choose another "
                      "process",
                      1e3 * diameter, process.name, 1e3 * process.diameter)};
    }
  }
  std::stable_sort(findings.begin(), findings.end(),
                   [](const PrintFinding& a, const PrintFinding& b) { return a.value < b.value; });
  return findings;
}

std::vector<PrintFinding> near_findings(const Structure& structure, const std::vector<RodPiece>& pieces,
                                        const PrintProcess& process, double cell) {
  std::vector<PrintFinding> findings;
  for (const NearRods& near : near_rods(pieces, std::max(process.gap, cell))) {
    const std::string &first = structure.rods[near.rod0].name, &second = structure.rods[near.rod1].name;
    const std::string rods = fmt::format("{} and {}", first, near.rod0 == near.rod1 ? "itself" : second);
    const bool touch = near.gap <= 0;
    PrintFinding finding{
        Weight::kError, touch ? "rods touch" : "rods are close", print_place(rods, near.place), near.gap, {}};
    if (touch) {
      finding.remedy = fmt::format(
          "they overlap by {:.2g} mm where they share no joint, and would be one piece: move them "
          "apart, or join them in the document",
          -1e3 * near.gap);
    } else if (near.gap < process.gap) {
      finding.remedy = fmt::format("{:.2g} mm lie between them, and would fuse below {:.2g} mm: move them apart",
                                   1e3 * near.gap, 1e3 * process.gap);
    } else {
      finding.remedy = fmt::format(
          "{:.2g} mm lie between them, less than the {:.2g} mm that the surface resolves: give a "
          "smaller tolerance",
          1e3 * near.gap, 1e3 * cell);
    }
    findings.push_back(std::move(finding));
  }
  std::stable_sort(findings.begin(), findings.end(),
                   [](const PrintFinding& a, const PrintFinding& b) { return a.value < b.value; });
  return findings;
}

std::string in_mm(const Vec3& size) {
  return fmt::format("{:.1f} x {:.1f} x {:.1f} mm", 1e3 * size.x(), 1e3 * size.y(), 1e3 * size.z());
}

std::vector<PrintFinding> bed_findings(const std::vector<RodSolid>& solids, const PrintProcess& process) {
  const SolidBox box = solid_box(solids);
  Vec3 size = box.high - box.low;
  const Vec3 turned(size.y(), size.x(), size.z());
  const auto excess = [&](const Vec3& s) { return (s - process.bed).cwiseMax(0).maxCoeff(); };
  if (excess(turned) < excess(size)) size = turned;  // a quarter turn on the bed is free
  if (excess(size) <= 0) return {};
  for (const std::array<int, 3>& axes : {std::array{0, 2, 1}, {2, 1, 0}, {1, 2, 0}, {2, 0, 1}}) {
    const Vec3 laid(size[axes[0]], size[axes[1]], size[axes[2]]);
    if (excess(laid) > 0) continue;
    return {{Weight::kWarning, "fits only on another side", in_mm(laid) + " on a bed of " + in_mm(process.bed), 0,
             "turn it so that its longest sides lie along those of the bed"}};
  }
  std::string by;
  constexpr const char* kAxes[] = {"x", "y", "z"};
  for (int i = 0; i < 3; ++i) {
    const double over = size[i] - process.bed[i];
    if (over > 0) by += fmt::format("{}{:.1f} mm too long along {}", by.empty() ? "" : ", ", 1e3 * over, kAxes[i]);
  }
  return {{Weight::kError, "too large", in_mm(size) + " on a bed of " + in_mm(process.bed), excess(size),
           by + ": use a larger printer, or cut the structure into parts that are joined later"}};
}

}  // namespace

std::string print_place(const std::string& rods, const Vec3& place) {
  const auto mm = [](double x) { return 1e3 * x + 0.0; };
  return fmt::format("{} at ({:.1f}, {:.1f}, {:.1f}) mm", rods, mm(place.x()), mm(place.y()), mm(place.z()));
}

std::vector<PrintFinding> print_checks(const Structure& structure, const std::vector<RodSolid>& solids,
                                       const PrintProcess& process, double tolerance) {
  const std::vector<RodPiece> pieces = rod_pieces(structure, tolerance);
  double cell = 0;
  for (const RodSolid& solid : solids) cell = std::max(cell, solid.cell);
  std::vector<PrintFinding> findings = thin_rods(structure, pieces, process);
  for (const PrintFinding& f : near_findings(structure, pieces, process, cell)) findings.push_back(f);
  for (const PrintFinding& f : bed_findings(solids, process)) findings.push_back(f);
  const auto tube = std::find_if(pieces.begin(), pieces.end(),
                                 [](const RodPiece& piece) { return piece.shape == SectionShape::kTube; });
  if (tube != pieces.end()) {
    findings.push_back(
        {Weight::kWarning, "full tubes", print_place(structure.rods[tube->rod].name, tube->stations[0].centre),
         2 * tube->stations[0].r_b,
         "tubes are printed full, which makes them heavier and stiffer than they were computed: give the rods "
         "round sections of the same bending stiffness"});
  }
  return findings;
}

SolidBox solid_box(const std::vector<RodSolid>& solids) {
  SolidBox box{Vec3::Constant(INFINITY), Vec3::Constant(-INFINITY)};
  for (const RodSolid& solid : solids) {
    for (const std::array<int, 3>& t : solid.surface.triangles) {
      for (const int v : t) {
        box.low = box.low.cwiseMin(solid.surface.vertices[v]);
        box.high = box.high.cwiseMax(solid.surface.vertices[v]);
      }
    }
  }
  return box;
}

}  // namespace lissom
