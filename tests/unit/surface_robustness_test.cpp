/// Surfaces damaged in 300 ways, in every kind of file: each ends mended, with a note of what was done, or refused with a
/// place, a reason and a remedy; none takes long or much memory.

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <gtest/gtest.h>
#include <iostream>
#include <sys/resource.h>

#include "lissom/core/file_io.h"
#include "lissom/geometry/surface_file.h"
#include "lissom/geometry/surface_repair.h"
#include "lissom/geometry/surface_scale.h"
#include "tests/unit/surface_checks.h"
#include "tests/unit/surface_damage.h"
#include "tests/unit/surface_samples.h"

namespace lissom {
namespace {

using samples::Damage;
using samples::Fate;
using samples::kDamages;
using samples::Random;
using Options = SurfaceRepairOptions;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr double kLongest = 20;  // s, for one variant
#else
constexpr double kLongest = 2;
constexpr long kMostMemory = 400'000;  // kB, of the whole test program
#endif

std::vector<Surface> sources() {
  std::vector<Surface> made = {samples::icosphere(3, 0.1), samples::torus(28, 16, 0.1, 0.04),
                               samples::sheet(16, 12, 0.2)};
  for (const char* name : {"hat.obj", "spot.obj"}) {
    const std::filesystem::path file = std::filesystem::path("..") / "shared" / "data" / name;
    const Result<std::string> text = read_file(file);
    const Result<RawSurface> raw = text ? read_surface(text.value(), name) : Result<RawSurface>(text.error());
    if (!text) {
      std::cout << "without " << name << ", which lies beside the repository of its authors only\n";
      continue;
    }
    EXPECT_TRUE(raw) << raw.error().text();
    if (raw) made.push_back(surface_in_metres(raw.value(), {.size = 0.23}).value());
  }
  return made;
}

Options some_options(Random& r) {
  Options options;
  if (r.below(2)) options.holes = Options::Holes::kFill;
  if (r.below(3) == 0) options.pieces = Options::Pieces::kKeepLargest;
  if (r.below(4) == 0) options.crossings = Options::Crossings::kRefuse;
  return options;
}

Result<RepairedSurface> bring(const std::string& bytes, const std::string& file, const SurfaceScale& scale,
                              const Options& options) {
  Result<RawSurface> raw = read_surface(bytes, file);
  if (!raw) return raw.error();
  Result<Surface> surface = surface_in_metres(raw.value(), scale);
  if (!surface) return surface.error();
  return repair_surface(std::move(surface).value(), options, file);
}

bool any_mended(const std::vector<SurfaceNote>& notes) {
  return std::any_of(notes.begin(), notes.end(),
                     [](const auto& n) { return n.outcome == SurfaceNote::Outcome::kMended; });
}

/// A mended surface is sound, and stays as it is when it is brought again.
void check_mended(const RepairedSurface& repaired, const Options& options) {
  EXPECT_EQ(samples::soundness(repaired.surface).fault, "");
  for (const SurfaceNote& note : repaired.notes) {
    EXPECT_GT(note.count, 0);
    EXPECT_FALSE(note.what.empty() || note.done.empty());
  }
  const Result<RepairedSurface> again = repair_surface(repaired.surface, options, "again");
  ASSERT_TRUE(again) << again.error().text();
  EXPECT_FALSE(any_mended(again.value().notes)) << again.value().notes.front().text();
  EXPECT_EQ(again.value().surface.triangles, repaired.surface.triangles);
}

/// 300, or LISSOM_MUTANTS.
int variant_count() {
  const char* wanted = std::getenv("LISSOM_MUTANTS");
  return wanted ? std::atoi(wanted) : 300;
}

TEST(SurfaceRobustness, DamagedSurfacesAreMendedOrRefusedWithAReason) {
  const int variants = variant_count();
  ASSERT_GT(variants, 0);
  const std::vector<Surface> made = sources();
  int mended = 0, untouched = 0, refused = 0;
  double longest = 0;
  for (int i = 0; i < variants; ++i) {
    Random random(static_cast<unsigned>(i));
    const Damage& damage = kDamages[i % std::size(kDamages)];
    Surface s = made[(i / std::size(kDamages)) % made.size()];
    damage.apply(s, random);
    const samples::Kind& kind = samples::kKinds[random.below(std::size(samples::kKinds))];
    std::string bytes = kind.bytes(s);
    const bool bytes_too = random.below(damage.name == std::string("nothing") ? 2 : 10) == 0;
    if (bytes_too) samples::damage_bytes(bytes, random);
    const Options options = some_options(random);
    SCOPED_TRACE(std::to_string(i) + ", " + damage.name + ", " + kind.file + (bytes_too ? ", bytes damaged" : ""));

    const std::clock_t start = std::clock();
    const Result<RepairedSurface> repaired = bring(bytes, kind.file, {.size = 0.23}, options);
    longest = std::max(longest, double(std::clock() - start) / CLOCKS_PER_SEC);

    const Fate fate = bytes_too                                                  ? Fate::kAny
                      : std::string(kind.file).find(".stl") != std::string::npos ? damage.in_stl
                                                                                 : damage.fate;
    if (!repaired) {
      const Error& error = repaired.error();
      EXPECT_FALSE(error.where.empty() || error.message.empty() || error.hint.empty()) << error.text();
      ++refused;
      continue;
    }
    EXPECT_NE(fate, Fate::kRefused);
    EXPECT_TRUE(fate == Fate::kAny || !repaired.value().notes.empty());
    check_mended(repaired.value(), options);
    ++(any_mended(repaired.value().notes) ? mended : untouched);
  }
  std::cout << variants << " surfaces: " << mended << " mended, " << untouched << " with nothing to mend, " << refused
            << " refused, longest " << longest << " s\n";
  EXPECT_EQ(mended + untouched + refused, variants);
  EXPECT_GT(mended, variants / 4) << "the test no longer reaches deep";
  EXPECT_GT(refused, variants / 10);
  EXPECT_LT(longest, kLongest);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  rusage usage{};
  ASSERT_EQ(getrusage(RUSAGE_SELF, &usage), 0);
  EXPECT_LT(usage.ru_maxrss, kMostMemory);
#endif
}

/// Bytes alone, many more of them, through the readers.
TEST(SurfaceRobustness, DamagedBytesNeverStopTheReaders) {
  const Surface s = samples::icosphere(1, 0.1);
  int read = 0, refused = 0;
  for (int i = 0; i < 4000; ++i) {
    Random random(static_cast<unsigned>(i));
    const samples::Kind& kind = samples::kKinds[i % std::size(samples::kKinds)];
    std::string bytes = kind.bytes(s);
    for (int k = 1 + random.below(2); k > 0 && !bytes.empty(); --k) samples::damage_bytes(bytes, random);
    const Result<RawSurface> raw = read_surface(bytes, kind.file);
    if (raw) {
      ++read;
      const int n = static_cast<int>(raw.value().points.size());
      for (const auto& t : raw.value().triangles) {
        for (const int v : t) ASSERT_TRUE(v >= 0 && v < n);
      }
      continue;
    }
    ++refused;
    EXPECT_FALSE(raw.error().where.empty() || raw.error().message.empty() || raw.error().hint.empty());
  }
  EXPECT_GT(read, 400);
  EXPECT_GT(refused, 400);
}

}  // namespace
}  // namespace lissom
