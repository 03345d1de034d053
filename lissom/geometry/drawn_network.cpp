#include "lissom/geometry/drawn_network.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "lissom/geometry/surface_locate.h"
#include "lissom/geometry/surface_note.h"
#include "lissom/geometry/surface_topology.h"

namespace lissom {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Walks over the segments of a drawing.
class Drawer {
 public:
  Drawer(const Surface& surface, const ObjLines& drawn, double corner, const std::string& where)
      : surface_(surface), drawn_(drawn), corner_(corner), where_(where), mates_(side_mates(surface.triangles)) {
    segments_at_.resize(drawn.points.size());
    for (int s = 0; s < static_cast<int>(drawn.segments.size()); ++s) {
      for (const int p : drawn.segments[at(s)]) segments_at_[at(p)].push_back(s);
    }
  }

  Result<SurfaceNetwork> run() {
    if (drawn_.segments.empty()) {
      return Error{ErrorCode::kGeometry, where_, "the drawing has no lines", "draw OBJ line elements (l)"};
    }
    for (const Vec3& x : drawn_.points) place_.push_back(nearest_place(surface_, x));
    joint_.assign(place_.size(), -1);
    used_.assign(drawn_.segments.size(), 0);
    for (int p = 0; p < static_cast<int>(place_.size()); ++p) {
      const std::size_t count = segments_at_[at(p)].size();
      if (count > 0 && (count != 2 || turn_at(p) > corner_)) add_joint(p);
    }
    for (int p = 0; p < static_cast<int>(place_.size()); ++p) {
      if (joint_[at(p)] < 0) continue;
      for (const int s : segments_at_[at(p)]) {
        if (Status status = follow(p, s); !status) return status.error();
      }
    }
    return rings();
  }

 private:
  void add_joint(int point) {
    joint_[at(point)] = static_cast<int>(network_.joints.size());
    network_.joints.push_back({place_[at(point)], SurfaceJoint::Kind::kInside});
  }

  /// Of a point with two segments, rad.
  double turn_at(int point) const {
    std::array<Vec3, 2> towards;
    for (std::size_t k = 0; k < 2; ++k) {
      const int other = far_end(segments_at_[at(point)][k], point);
      towards[k] = (drawn_.points[at(other)] - drawn_.points[at(point)]).normalized();
    }
    return std::acos(std::clamp(-towards[0].dot(towards[1]), -1.0, 1.0));
  }

  int far_end(int segment, int point) const {
    const std::array<int, 2>& ends = drawn_.segments[at(segment)];
    return ends[0] == point ? ends[1] : ends[0];
  }

  /// From a joint along a segment to the next joint.
  Status follow(int from, int segment) {
    if (used_[at(segment)] != 0) return {};
    SurfaceLine line{{joint_[at(from)], -1}, {}, false, {}};
    int point = from;
    while (true) {
      used_[at(segment)] = 1;
      const int next = far_end(segment, point);
      const std::vector<int> patch = triangles_near(surface_, mates_, place_[at(point)], place_[at(next)]);
      const std::optional<SurfacePath> piece = shortest_path(surface_, patch, place_[at(point)], place_[at(next)]);
      if (!piece) {
        return Error{ErrorCode::kGeometry, where_,
                     fmt::format("points {} and {} of the drawing, near {}, have no path between them on the surface",
                                 point + 1, next + 1, in_millimetres(position(surface_, place_[at(point)]))),
                     "draw them apart, on one piece of the surface"};
      }
      line.path.insert(line.path.end(), piece->begin(), piece->end());
      std::vector<int> both;
      std::set_union(line.patch.begin(), line.patch.end(), patch.begin(), patch.end(), std::back_inserter(both));
      line.patch = std::move(both);
      point = next;
      if (joint_[at(point)] >= 0) break;
      segment = segments_at_[at(point)][segments_at_[at(point)][0] == segment ? 1 : 0];
    }
    line.joint[1] = joint_[at(point)];
    network_.lines.push_back(std::move(line));
    return {};
  }

  /// Closed lines without joints get three, a third of their points apart.
  Result<SurfaceNetwork> rings() {
    for (int s = 0; s < static_cast<int>(used_.size()); ++s) {
      if (used_[at(s)] != 0) continue;
      std::vector<int> ring{drawn_.segments[at(s)][0]};
      int segment = s;
      do {
        ring.push_back(far_end(segment, ring.back()));
        const std::vector<int>& both = segments_at_[at(ring.back())];
        segment = both[both[0] == segment ? 1 : 0];
      } while (segment != s);
      ring.pop_back();
      if (ring.size() < 3) {
        return Error{ErrorCode::kGeometry, where_, "a ring of the drawing has fewer than three points",
                     "draw it finer"};
      }
      for (std::size_t k = 0; k < 3; ++k) add_joint(ring[k * ring.size() / 3]);
      for (std::size_t k = 0; k < 3; ++k) {
        const int p = ring[k * ring.size() / 3];
        for (const int next : segments_at_[at(p)]) {
          if (Status status = follow(p, next); !status) return status.error();
        }
      }
    }
    return std::move(network_);
  }

  const Surface& surface_;
  const ObjLines& drawn_;
  const double corner_;  // rad
  const std::string& where_;
  std::vector<int> mates_;                     // per side
  std::vector<std::vector<int>> segments_at_;  // per point
  std::vector<SurfacePlace> place_;            // per point
  std::vector<int> joint_;                     // per point; -1: none
  std::vector<char> used_;                     // per segment
  SurfaceNetwork network_;
};

}  // namespace

Result<SurfaceNetwork> drawn_network(const Surface& surface, const ObjLines& drawn, double corner,
                                     const std::string& where) {
  return Drawer(surface, drawn, corner, where).run();
}

}  // namespace lissom
