#include "lissom/view/surface_mesh.h"

#include <algorithm>
#include <fmt/format.h>

#include "lissom/view/tube.h"

namespace lissom {
namespace {

enum class Facing { kOutwards, kInwards };

/// Appends the skin of one rod.
class Skinner {
 public:
  Skinner(SurfaceMesh& mesh, const RodStrip& rod, int sides, int first_point)
      : mesh_(mesh),
        rod_(rod),
        outline_(section_outline(rod.shape, sides)),
        rings_(tube_rings(rod, std::vector<int>(rod.b.size(), 1))),
        first_point_(first_point) {
    if (rod.closed) {
      reversed_ = rings_.back().n.dot(rings_.front().n) < 0;
      rings_.pop_back();
    }
  }

  void run() {
    const int outer = add_vertices(false);
    const bool hollow =
        rod_.shape == SectionShape::kTube && std::all_of(rings_.begin(), rings_.end(), [](const Ring& ring) {
          return ring.wall > 0 && ring.wall < std::min(ring.r_b, ring.r_n);
        });
    add_walls(outer, Facing::kOutwards);
    const int inner = hollow ? add_vertices(true) : outer;
    if (hollow) add_walls(inner, Facing::kInwards);
    if (rod_.closed) return;
    const int last = static_cast<int>(rings_.size()) - 1;
    if (hollow) {
      add_annulus(inner, outer);
      add_annulus(outer + last * sides(), inner + last * sides());
    } else {
      add_cap(0, outer, Facing::kInwards);
      add_cap(last, outer + last * sides(), Facing::kOutwards);
    }
  }

 private:
  int sides() const { return static_cast<int>(outline_.size()); }

  int add_vertices(bool inner) {
    const int first = static_cast<int>(mesh_.vertices.size());
    for (size_t i = 0; i < rings_.size(); ++i) {
      const Ring& ring = rings_[i];
      const double b = inner ? 1 - ring.wall / ring.r_b : 1, n = inner ? 1 - ring.wall / ring.r_n : 1;
      for (const Vec2& p : outline_) {
        mesh_.vertices.push_back(ring_point(ring, p, b, n));
        mesh_.source.push_back(first_point_ + static_cast<int>(i));
      }
    }
    return first;
  }

  void add_triangle(int a, int b, int c, Facing facing) {
    if (facing == Facing::kInwards) std::swap(b, c);
    mesh_.triangles.push_back({a, b, c});
  }

  void add_walls(int first, Facing facing) {
    const int rings = static_cast<int>(rings_.size());
    for (int i = 0; i + (rod_.closed ? 0 : 1) < rings; ++i) {
      const bool around = i + 1 == rings;
      const int shift = around && reversed_ ? sides() / 2 : 0;
      const int ring0 = first + i * sides(), ring1 = around ? first : ring0 + sides();
      for (int k = 0; k < sides(); ++k) {
        const int next = (k + 1) % sides();
        const int upper = (k + shift) % sides(), upper_next = (next + shift) % sides();
        // Faces of a twisted rod are saddles. Opposite diagonals on opposite sides keep its thickness and volume.
        if (k < sides() / 2) {
          add_triangle(ring0 + k, ring0 + next, ring1 + upper_next, facing);
          add_triangle(ring0 + k, ring1 + upper_next, ring1 + upper, facing);
        } else {
          add_triangle(ring0 + k, ring0 + next, ring1 + upper, facing);
          add_triangle(ring0 + next, ring1 + upper_next, ring1 + upper, facing);
        }
      }
    }
  }

  void add_cap(int ring, int first, Facing facing) {
    const int middle = static_cast<int>(mesh_.vertices.size());
    mesh_.vertices.push_back(rings_[ring].centre);
    mesh_.source.push_back(first_point_ + ring);
    for (int k = 0; k < sides(); ++k) add_triangle(middle, first + k, first + (k + 1) % sides(), facing);
  }

  /// Flat ring between two loops, facing along the rod when `outer` comes first and against it otherwise.
  void add_annulus(int one, int other) {
    for (int k = 0; k < sides(); ++k) {
      const int next = (k + 1) % sides();
      add_triangle(one + k, one + next, other + next, Facing::kOutwards);
      add_triangle(one + k, other + next, other + k, Facing::kOutwards);
    }
  }

  SurfaceMesh& mesh_;
  const RodStrip& rod_;
  std::vector<Vec2> outline_;
  std::vector<Ring> rings_;
  int first_point_;
  bool reversed_ = false;  // frames of a closed rod come back after half a turn
};

}  // namespace

Status check_sides(int sides) {
  if (sides >= 4 && sides <= 512 && sides % 2 == 0) return {};
  return Error{ErrorCode::kRange, "sides", fmt::format("a rod cannot have {} sides", sides),
               "use an even number from 4 to 512"};
}

SurfaceMesh rod_surfaces(const Drawing& drawing, int sides) {
  SurfaceMesh mesh;
  int first_point = 0;
  for (const RodStrip& rod : drawing.rods) {
    mesh.first_triangle.push_back(static_cast<int>(mesh.triangles.size()));
    Skinner(mesh, rod, sides, first_point).run();
    first_point += static_cast<int>(rod.points.size());
  }
  return mesh;
}

SurfaceMesh all_surfaces(const Drawing& drawing, int sides) {
  SurfaceMesh mesh = rod_surfaces(drawing, sides);
  int first_point = drawing.rod_point_count();
  for (const MembraneSheet& sheet : drawing.membranes) {
    const int first = static_cast<int>(mesh.vertices.size());
    mesh.first_triangle.push_back(static_cast<int>(mesh.triangles.size()));
    for (const Vec3& p : sheet.points) {
      mesh.vertices.push_back(p);
      mesh.source.push_back(first_point++);
    }
    for (const std::array<int, 3>& t : sheet.triangles)
      mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
  return mesh;
}

}  // namespace lissom
