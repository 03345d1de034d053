#include "lissom/fabrication/contour.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>

#include "lissom/fabrication/cube_cuts.h"
#include "lissom/geometry/frame.h"

namespace lissom {

namespace {

constexpr int kBlock = 6;                         // cells along a side of a block
constexpr int kPoints = kBlock + 1;               // points along it
constexpr int kAxisBits = 20;                     // of a coordinate in a key
constexpr double kNearest = 0.04;                 // of a cell, between a vertex and a point of the lattice
constexpr std::size_t kMostEntries = 20'000'000;  // of blocks and segments that reach into them
// The lattice is turned and shifted, so that nothing which is drawn on round numbers or along axes lies exactly on it.
const Vec3 kTurn(0.3162277, 0.5477225, 0.2236068);    // rotation vector, rad
const Vec3 kOffset(0.4142135, 0.7320508, 0.2360679);  // of a cell

using Key = std::uint64_t;
Key key_of(int x, int y, int z) { return (Key(x) << (2 * kAxisBits)) | (Key(y) << kAxisBits) | Key(z); }

/// A block with the segments that reach into it.
struct Block {
  std::array<int, 3> at;  // in blocks
  std::vector<int> segments;
};

/// Its part of the surface; `keys` of vertices: the edge of the lattice, or none for centres.
struct Patch {
  static constexpr Key kNone = ~Key{0};
  std::vector<Vec3> vertices;
  std::vector<Key> keys;
  std::vector<std::array<int, 3>> triangles;
};

class Lattice {
 public:
  Lattice(const RodField& field, double cell) : field_(field), cell_(cell), axes_(rotation_from_vector(kTurn)) {
    Vec3 low = Vec3::Constant(INFINITY);
    for (int s = 0; s < field.segments(); ++s) low = low.cwiseMin(box(s).low);
    origin_ = low - cell * (Vec3::Ones() + kOffset);
  }

  /// Ascending by place.
  Result<std::vector<Block>> blocks() const {
    std::vector<std::pair<Key, int>> entries;
    for (int s = 0; s < field_.segments(); ++s) {
      const Box own = box(s);
      const Vec3 first = (own.low - origin_) / (cell_ * kBlock), last = (own.high - origin_) / (cell_ * kBlock);
      if (!(last.maxCoeff() * kBlock < (1 << kAxisBits) - 2 * kBlock)) return too_large();
      for (int x = int(first.x()); x <= int(last.x()); ++x) {
        for (int y = int(first.y()); y <= int(last.y()); ++y) {
          for (int z = int(first.z()); z <= int(last.z()); ++z) {
            if (reaches(s, {x, y, z})) entries.emplace_back(key_of(x, y, z), s);
          }
        }
      }
      if (entries.size() > kMostEntries) return too_large();
    }
    std::sort(entries.begin(), entries.end());
    std::vector<Block> blocks;
    for (std::size_t i = 0; i < entries.size(); ++i) {
      const Key key = entries[i].first;
      if (i == 0 || key != entries[i - 1].first) {
        const Key mask = (Key{1} << kAxisBits) - 1;
        blocks.push_back({{int(key >> (2 * kAxisBits)), int(key >> kAxisBits & mask), int(key & mask)}, {}});
      }
      blocks.back().segments.push_back(entries[i].second);
    }
    return blocks;
  }

  Patch patch(const Block& block) const {
    std::array<double, kPoints * kPoints * kPoints> values;
    bool any_in = false, any_out = false;
    for (int z = 0; z < kPoints; ++z) {
      for (int y = 0; y < kPoints; ++y) {
        for (int x = 0; x < kPoints; ++x) {
          double& value = values[index(x, y, z)];
          value = field_.value(point(block, x, y, z), block.segments);
          (value < 0 ? any_in : any_out) = true;
        }
      }
    }
    Patch patch;
    if (!any_in || !any_out) return patch;
    std::unordered_map<Key, int> known;
    for (int z = 0; z < kBlock; ++z) {
      for (int y = 0; y < kBlock; ++y) {
        for (int x = 0; x < kBlock; ++x) add_cube(block, {x, y, z}, values, known, patch);
      }
    }
    return patch;
  }

 private:
  static std::size_t index(int x, int y, int z) { return static_cast<std::size_t>((z * kPoints + y) * kPoints + x); }

  /// Along the axes of the lattice, m.
  struct Box {
    Vec3 low, high;
  };
  Box box(int segment) const {
    const RodField::Reach r = field_.reach(segment);
    const Vec3 from = axes_.transpose() * r.from, to = axes_.transpose() * r.to;
    return {from.cwiseMin(to).array() - r.bound, from.cwiseMax(to).array() + r.bound};
  }

  /// Whether the ball around a block meets what a segment reaches.
  bool reaches(int segment, const std::array<int, 3>& at) const {
    const RodField::Reach r = field_.reach(segment);
    const double side = cell_ * kBlock;
    const Vec3 centre = axes_ * (origin_ + side * (Vec3(at[0], at[1], at[2]) + Vec3::Constant(0.5)));
    const Vec3 line = r.to - r.from;
    const double share = std::clamp((centre - r.from).dot(line) / line.squaredNorm(), 0.0, 1.0);
    return (r.from + share * line - centre).norm() <= r.bound + side * std::sqrt(0.75);
  }

  Vec3 point(const Block& block, int x, int y, int z) const {
    const Vec3 steps(block.at[0] * kBlock + x, block.at[1] * kBlock + y, block.at[2] * kBlock + z);
    return axes_ * (origin_ + cell_ * steps);
  }

  Error too_large() const {
    return {ErrorCode::kRange, "tolerance", "the surface would need too many cells", "allow a larger tolerance"};
  }

  template <class Values>
  void add_cube(const Block& block, const std::array<int, 3>& at, const Values& values,
                std::unordered_map<Key, int>& known, Patch& patch) const {
    int which = 0;
    for (int c = 0; c < 8; ++c) {
      if (values[index(at[0] + (c & 1), at[1] + (c >> 1 & 1), at[2] + (c >> 2 & 1))] < 0) which |= 1 << c;
    }
    const CubeCuts& cuts = cube_cuts()[which];
    if (cuts.triangles.empty()) return;
    std::array<int, kCubeEdges + 4> vertex;
    vertex.fill(-1);
    const auto cut = [&](int e) {
      int& v = vertex[e];
      if (v < 0) v = edge_vertex(block, at, cube_edges()[e], values, known, patch);
      return v;
    };
    for (std::size_t l = 0; l < cuts.centred.size(); ++l) {
      Vec3 sum = Vec3::Zero();
      for (const int e : cuts.centred[l]) sum += patch.vertices[cut(e)];
      vertex[kCubeEdges + l] = static_cast<int>(patch.vertices.size());
      patch.vertices.push_back(sum / double(cuts.centred[l].size()));
      patch.keys.push_back(Patch::kNone);
    }
    for (const std::array<int, 3>& t : cuts.triangles) patch.triangles.push_back({cut(t[0]), cut(t[1]), cut(t[2])});
  }

  template <class Values>
  int edge_vertex(const Block& block, const std::array<int, 3>& at, const CubeEdge& edge, const Values& values,
                  std::unordered_map<Key, int>& known, Patch& patch) const {
    const int x = at[0] + (edge.from & 1), y = at[1] + (edge.from >> 1 & 1), z = at[2] + (edge.from >> 2 & 1);
    const Key key = key_of(block.at[0] * kBlock + x, block.at[1] * kBlock + y, block.at[2] * kBlock + z) |
                    (Key(edge.axis) << (3 * kAxisBits));
    const auto [entry, is_new] = known.emplace(key, static_cast<int>(patch.vertices.size()));
    if (!is_new) return entry->second;
    const int dx = edge.axis == 0 ? 1 : 0, dy = edge.axis == 1 ? 1 : 0, dz = edge.axis == 2 ? 1 : 0;
    const Vec3 from = point(block, x, y, z), to = point(block, x + dx, y + dy, z + dz);
    const double share = root(block, from, to, values[index(x, y, z)], values[index(x + dx, y + dy, z + dz)]);
    patch.vertices.push_back(from + share * (to - from));
    patch.keys.push_back(key);
    return entry->second;
  }

  /// Where the field changes sign between two points: false position, kept from stalling as in the Illinois method.
  double root(const Block& block, const Vec3& from, const Vec3& to, double f0, double f1) const {
    const double most = 2 * cell_;  // beyond, the field says nothing
    f0 = std::clamp(f0, -most, most);
    f1 = std::clamp(f1, -most, most);
    double s0 = 0, s1 = 1, share = 0.5;
    int side = 0;
    for (int i = 0; i < 12 && s1 - s0 > 1e-4; ++i) {
      share = (s0 * f1 - s1 * f0) / (f1 - f0);
      const double f = std::clamp(field_.value(from + share * (to - from), block.segments), -most, most);
      if (std::abs(f) < 1e-4 * cell_) break;
      if ((f < 0) == (f0 < 0)) {
        s0 = share;
        f0 = f;
        if (side == -1) f1 /= 2;
        side = -1;
      } else {
        s1 = share;
        f1 = f;
        if (side == 1) f0 /= 2;
        side = 1;
      }
    }
    return std::clamp(share, kNearest, 1 - kNearest);
  }

  const RodField& field_;
  double cell_;
  Mat3 axes_;    // of the lattice, as columns
  Vec3 origin_;  // m, along these
};

}  // namespace

Result<Surface> contour(const RodField& field, double cell, const Context& context) {
  const Lattice lattice(field, cell);
  const Result<std::vector<Block>> found = lattice.blocks();
  if (!found) return found.error();
  const std::vector<Block>& blocks = found.value();
  std::vector<Patch> patches(blocks.size());
  parallel_for(context.threads, static_cast<int>(blocks.size()), 8, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      patches[i] = lattice.patch(blocks[i]);
    }
  });
  Surface surface;
  std::unordered_map<Key, int> known;
  for (const Patch& patch : patches) {
    std::vector<int> number(patch.vertices.size());
    for (std::size_t v = 0; v < patch.vertices.size(); ++v) {
      const int next = static_cast<int>(surface.vertices.size());
      number[v] = patch.keys[v] == Patch::kNone ? next : known.emplace(patch.keys[v], next).first->second;
      if (number[v] == next) surface.vertices.push_back(patch.vertices[v]);
    }
    for (const std::array<int, 3>& t : patch.triangles) {
      surface.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
    }
  }
  return surface;
}

}  // namespace lissom
