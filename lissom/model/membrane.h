#pragma once
/// Membranes as the user describes them: a flat (or meshed) piece of fabric with orthotropic stretch stiffness, optional
/// bending stiffness, and a pre-stretch. Rods share nodes with a membrane wherever their nodes and its vertices coincide.

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/core/types.h"

namespace lissom {

/// Orthotropic sheet material; only stiffness per width enters stretch [mathematics 3.1]. Axis 1 is the warp (course)
/// direction, axis 2 the weft (wale).
struct MembraneMaterial {
  std::string name;
  double stiffness_1 = 0, stiffness_2 = 0;  ///< N/m, Y = Young's modulus times thickness along axes 1 and 2
  double poisson_ratio = 0;                 ///< mu; a pull along 1 narrows 2 by mu sqrt(Y1 / Y2)
  double thickness = 0;                     ///< m; 0: no resistance to bending
  double area_density = 0;                  ///< kg/m^2
  std::string source;                       ///< where the numbers come from

  double shear() const;  ///< N/m, sqrt(Y1 Y2) / (2 (1 + mu))
  double bend() const;   ///< N m, D = sqrt(Y1 Y2) h^2 / (12 (1 - mu^2)) [mathematics 3.2]

  /// Refuses what no fabric can be: stiffness <= 0, mu outside (-1, 1), negative thickness or density.
  Status validate(const std::string& where) const;
};

/// Fabrics that ship with lissom, each with its source.
std::span<const MembraneMaterial> membrane_library();
const MembraneMaterial* find_membrane_material(std::string_view name);

/// Rectangle in the xy plane cut into cells_x by cells_y cells of two triangles each, diagonals alternating.
struct MembraneGrid {
  Vec2 corner = Vec2::Zero(), size = Vec2::Zero();  ///< m
  int cells_x = 1, cells_y = 1;
};

/// Disc or annulus in the xy plane with its first spoke along x. An annulus has rings x sectors cells of two triangles
/// each; a disc has rings of 6, 12, 18, ... edges scaled so that the outermost has `sectors` of them.
struct MembraneDisc {
  Vec2 centre = Vec2::Zero();           ///< m
  double radius = 0, inner_radius = 0;  ///< m; inner radius 0: full disc
  int rings = 1, sectors = 6;
};

/// Equilateral triangles of side `edge` in the xy plane: `rows` strips of 2 `columns` triangles from `corner`.
struct MembraneTriangles {
  Vec2 corner = Vec2::Zero();  ///< m
  double edge = 0;             ///< m
  int columns = 1, rows = 1;
};

/// Triangles given one by one; each is at rest in its own plane. Orientation consistent.
struct MembraneMesh {
  std::vector<Vec3> points;                   ///< m, (n x 3)
  std::vector<std::array<int, 3>> triangles;  ///< (t x 3)
  /// By triangle, multiplies the stiffness to stretch and to bend as a change of Young's modulus at equal thickness does;
  /// empty: 1 everywhere.
  std::vector<double> stiffness = {};
  std::vector<double> density = {};  ///< by triangle, multiplies the area density; empty: 1 everywhere
};

/// The angles between triangles at which bending is free of stress.
enum class RestFolds {
  kAsDrawn,
  kFlat,  ///< a flat sheet that is drawn bent
};

using MembraneShape = std::variant<MembraneGrid, MembraneDisc, MembraneTriangles, MembraneMesh>;

struct Membrane {
  std::string name;
  MembraneShape shape;
  std::string material;  ///< name in Model::membrane_materials or in the library
  /// Along axes 1 and 2: the drawn shape is the rest shape stretched by these [mathematics 6.2].
  Vec2 pre_stretch = Vec2::Ones();
  double warp_angle = 0;  ///< rad, from x to axis 1 in the plane of the drawing
  double bending = 1;     ///< multiplies the bending stiffness of the material; 0 switches bending off
  RestFolds rest_folds = RestFolds::kAsDrawn;
};

}  // namespace lissom
