#pragma once
/// Mends a surface in a test, with the checks that hold for every one.

#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "lissom/geometry/surface_repair.h"
#include "tests/unit/surface_checks.h"

namespace lissom::samples {

struct Mended {
  Surface surface;
  std::vector<SurfaceNote> notes;
};

/// Mends and checks what every mended surface promises.
inline Mended mend(const Surface& surface, const SurfaceRepairOptions& options = {}) {
  const Result<RepairedSurface> repaired = repair_surface(surface, options, "thing");
  EXPECT_TRUE(repaired) << repaired.error().text();
  if (!repaired) return {};
  EXPECT_EQ(soundness(repaired.value().surface).fault, "");
  return {repaired.value().surface, repaired.value().notes};
}

inline Error refuse(const Surface& surface, const SurfaceRepairOptions& options = {}) {
  const Result<RepairedSurface> repaired = repair_surface(surface, options, "thing");
  EXPECT_FALSE(repaired);
  if (repaired) return {};
  EXPECT_FALSE(repaired.error().where.empty() || repaired.error().message.empty() || repaired.error().hint.empty());
  return repaired.error();
}

/// The texts of all notes, one per line.
inline std::string texts(const std::vector<SurfaceNote>& notes) {
  std::string all;
  for (const SurfaceNote& note : notes) all += note.text() + "\n";
  return all;
}

}  // namespace lissom::samples
