#pragma once
/// Where rods are: a function of space that is negative inside them and zero on their surface, with rounded valleys where
/// rods meet. Nearly a distance close to the surface, large and meaningless far away.

#include <array>
#include <span>
#include <vector>

#include "lissom/fabrication/rod_pieces.h"

namespace lissom {

/// Stations first to last of a piece.
struct FieldPart {
  const RodPiece* piece = nullptr;
  int group = 0;  ///< parts of one piece have one group; only different groups are blended
  int first = 0, last = 0;
  /// kOpen: the plane of the end belongs to another part, or nothing there is wanted.
  enum class Cap { kOpen, kFlat, kRound };
  std::array<Cap, 2> cap{Cap::kOpen, Cap::kOpen};
};

/// Between two stations sections slide along the straight line between their centres, each in a plane between those of
/// the stations: x belongs to the share s of the way at which (x - centre) . t changes its sign. Within a section the
/// distance is (g - 1) / |grad g| with g = sqrt((u / r_b)^2 + (v / r_n)^2) for ellipses [Taubin 1994], and as usual for
/// rectangles. Two groups a and b are united as min(a, b) - max(k - |a - b|, 0)^2 / (4 k), with k a share of the
/// thinner half-extent times sin^2 of the angle between the normals: valleys are filled, rods that go on in line get no
/// bulge, and those that pass each other at a distance no bridge.
class RodField {
 public:
  /// `cell` (m): spacing of the points between which the surface will be straight. Facets with corners on a convex surface
  /// lie inside it; the field is moved outwards by what they lose on average, so that volumes are kept.
  /// Stations between which the rod is straight within an eighth of `tolerance` (m) are left out.
  RodField(const std::vector<FieldPart>& parts, double cell, double tolerance);

  /// Outside of the points within `bound` of the line between its ends a segment changes nothing.
  struct Reach {
    Vec3 from, to;     ///< m
    double bound = 0;  ///< m
  };
  int segments() const { return static_cast<int>(segments_.size()); }
  Reach reach(int segment) const;
  /// The field at x, if only these segments are near.
  double value(const Vec3& x, std::span<const int> segments) const;

 private:
  struct Segment {
    const RodStation *from = nullptr, *to = nullptr;
    SectionShape shape = SectionShape::kEllipse;
    int group = 0;
    FieldPart::Cap cap0 = FieldPart::Cap::kOpen, cap1 = FieldPart::Cap::kOpen;
    double bound = 0;  // m, farther from its axis it changes nothing
  };
  struct Hit {
    int group = 0;
    double distance = 0, thin = 0;  // m
    Vec3 direction;                 // unit, in which the distance grows
  };
  bool hit(const Segment& segment, const Vec3& x, Hit& found) const;
  Hit section_hit(const Segment& segment, double share, double beyond, const Vec3& offset) const;

  double cell_;
  std::vector<Segment> segments_;
};

/// Share of the thinner half-extent over which valleys between rods are rounded.
inline constexpr double kValley = 0.5;

}  // namespace lissom
