#pragma once
/// What can be seen of a structure, as plain buffers: rods with true sections, membranes, named fields, supports and
/// forces. Knows nothing of solvers; pictures, ParaView files and surface meshes are all made from it.

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/core/types.h"
#include "lissom/geometry/frame.h"
#include "lissom/model/section.h"

namespace lissom {

struct Structure;

/// One rod. `points` has edges + 1 entries, or as many as edges when closed.
struct RodStrip {
  std::string name;
  bool closed = false;
  std::vector<Vec3> points;      ///< m, (points x 3)
  std::vector<Vec3> b, n;        ///< unit material axes, in plane and out of plane, (edges x 3)
  std::vector<double> r_n, r_b;  ///< m, half-extents along n and b, (edges)
  std::vector<double> wall;      ///< m, wall thickness of tubes, (edges); empty: solid
  SectionShape shape = SectionShape::kEllipse;

  int edge_count() const { return static_cast<int>(b.size()); }
  int end_point(int edge) const { return edge + 1 == static_cast<int>(points.size()) ? 0 : edge + 1; }
};

/// One membrane, or the outer surface of a solid.
struct MembraneSheet {
  std::string name;
  std::vector<Vec3> points;                   ///< m, (points x 3)
  std::vector<std::array<int, 3>> triangles;  ///< (triangles x 3), into points
  std::vector<double> smallest_stretch;       ///< below 1: slack, (triangles); empty: unknown
  std::vector<Vec3> tension;  ///< N/m, along the direction of largest pull, (triangles x 3); empty: unknown
};

/// A named quantity. `values` runs per point over the rods and then the sheets, per edge over the rods, or per triangle over
/// the sheets, each in order; NaN: no value.
struct Field {
  enum class Place { kNode, kEdge, kTriangle };
  enum class Colors {
    kSequential,  ///< one-sided quantities: radius, energy density
    kDiverging,   ///< signed quantities, symmetric about zero: negative blue, positive red
    kPale,        ///< one-sided quantities of membranes: rods stand out before them
  };
  std::string name;
  std::string unit;          ///< of the values as stored, SI: "Pa", "1/m"; empty: a pure number
  std::string display_unit;  ///< for people: "MPa", "%"
  double display_scale = 1;  ///< shown value = stored value * display_scale
  Place place = Place::kEdge;
  Colors colors = Colors::kSequential;
  std::vector<double> values;
};

/// Something that stands at a point of the structure.
struct Marker {
  enum class Kind {
    kPin,    ///< position held
    kClamp,  ///< position and direction held
    kForce,  ///< `vector` in N
  };
  Kind kind = Kind::kPin;
  Vec3 at = Vec3::Zero();      ///< m
  Vec3 vector = Vec3::Zero();  ///< N; forces only
};

struct Drawing {
  std::vector<RodStrip> rods = {};
  std::vector<MembraneSheet> membranes = {};  ///< solids come after membranes
  std::vector<Field> fields = {};
  std::vector<Marker> markers = {};

  const Field* field(std::string_view name) const;  ///< null when unknown
  int rod_point_count() const;                      ///< over all rods
  int point_count() const;                          ///< over all rods and membranes
  int edge_count() const;
  int triangle_count() const;
};

/// `structure` in the shape given by the position of every node (m) and the material frame of every edge.
/// Pass the drawn positions and frames for the rest shape.
Drawing make_drawing(const Structure& structure, std::span<const Vec3> positions, std::span<const Frame> frames);

/// Arranges values per node, edge or triangle of the structure (as `place` says) in the order of the drawing.
std::vector<double> field_values(const Structure& structure, Field::Place place, std::span<const double> values);

/// Sizes agree, positions, axes and radii are finite, there is something to draw. Names the rod or field at fault.
Status check_drawing(const Drawing& drawing);

/// Mean over the edges that meet at each point of a rod, in the order of points; NaN where none of them has a value.
std::vector<double> edge_values_at_points(const Drawing& drawing, std::span<const double> values);

/// Values of a field at all points, of rods and of membranes: as edge_values_at_points for edges, the mean weighted by
/// area for triangles; NaN where there is no value.
std::vector<double> values_at_points(const Drawing& drawing, const Field& field);

/// Twice the area of a triangle times its unit normal, m^2.
Vec3 triangle_cross(const MembraneSheet& sheet, int triangle);

}  // namespace lissom
