#pragma once
/// A project: the deformable object that somebody wants printed as one mesh of rods [thesis, chapter 5]. Its surface, how rods
/// lie on it, the shapes that it should take and in which situations, what of the rods may change. Places and numbers only;
/// what becomes of them is said in lissom/posing.

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/model/material.h"
#include "lissom/model/pose.h"

namespace lissom {

struct SurfaceBrief {
  std::string file;            ///< OBJ, PLY, STL or OFF
  std::optional<double> unit;  ///< m per unit of the file
  std::optional<double> size;  ///< m, largest extent along an axis, instead of a unit
  bool fill_holes = false;     ///< small ones
  bool keep_largest = false;   ///< of several pieces
};

/// Cells of a centroidal Voronoi tessellation; rods between them.
struct CellTopology {
  int cells = 64;
  double contrast = 1;  ///< width of cells on white over their width on black
  int seed = 1;
};
/// Rods between neighbouring triangles of the decimated surface.
struct DualTopology {
  int triangles = 200;
};
/// A regular pattern in the plane of a sheet, laid on it.
struct PatternTopology {
  enum class Shape { kHexagons, kQuads, kTriangles };
  Shape shape = Shape::kHexagons;
  double width = 0.02;  ///< m, edge of a cell
};
/// Lines that somebody drew.
struct DrawnTopology {
  std::string file;            ///< OBJ with line elements
  std::optional<double> unit;  ///< m per unit of the file; the document's when absent
};
using Topology = std::variant<CellTopology, DualTopology, PatternTopology, DrawnTopology>;

struct MeshRods {
  std::string material = "TPU 92A";
  int edges = 10;                     ///< of each rod
  double r_n = 1.5e-3, r_b = 1.5e-3;  ///< m, to start with: across the surface and in it
  double shortest = 0.25;             ///< of the mean length: shorter lines are merged into a joint
  int valence = 6;                    ///< most rods that merging may bring to a joint
};

/// A part of a surface or solid that differs from the rest: inside a box, painted at least so dark, and so far inside.
struct DeformerRegion {
  std::optional<Vec3> low, high;      ///< m, corners of the box; everywhere when absent
  double dark = 0;                    ///< least darkness, 0 to 1
  double depth = 0;                   ///< m, least depth below the surface; 0 in shells, which have none
  double blend = 0;                   ///< m, width over which box and depth fade outwards
  double stiffness = 1, density = 1;  ///< factors
};

/// What a surface is made of while poses are found: a shell, or a body that fills it.
struct DeformerBrief {
  enum class Kind { kShell, kSolid };
  std::string name;
  Kind kind = Kind::kShell;
  double modulus = 1e6;  ///< Pa
  double poisson_ratio = 0.4;
  double density = 1000;       ///< kg/m^3
  double thickness = 2e-3;     ///< m, of shells
  std::optional<double> cell;  ///< m, of the tetrahedra of bodies; a twelfth of the size when absent
  std::vector<DeformerRegion> regions;
};

/// One shape that the object should take. What holds or pulls the deformer tells where the rods are held: at the places
/// where it ends there.
struct MeshPose {
  Pose pose;                              ///< name, supports, forces, gravity
  std::string deformer;                   ///< name; or
  std::string mesh;                       ///< file with the posed surface, same vertices in the same order; or
  std::vector<std::array<Vec3, 2>> warp;  ///< m, pairs of a place and where it goes, smooth in between
  double weight = 1;
  bool held_back = false;  ///< not designed for: its error tells how the design does where it was not asked
};

/// Radii at 2, 3 and 4 places of each rod first, then at 4 together with the rest shape.
struct MeshDesign {
  std::string method;       ///< one of brief_methods.h; empty: the fastest for so many parameters
  Vec2 radii{1e-3, 3e-3};   ///< m
  double reach = 3e-3;      ///< m, of the rest shape along each axis; 0: it stays as drawn
  double clearance = 6e-4;  ///< m, that rods should keep where they share no joint; 0: none
  std::array<int, 4> iterations{10, 6, 6, 24};
  double smoothness = 0;       ///< weight of neighbouring controls being alike
  double pin_stiffness = 1e3;  ///< N/m, at each node that is held, to start with
};

struct MeshPrint {
  std::string process = "sls";
  double tolerance = 1e-4;  ///< m, of the surface of the print
  std::optional<Vec3> bed;  ///< m, in the place of that of the process
};

struct RodMeshProject {
  std::string title, source;
  SurfaceBrief surface;
  Topology topology;
  std::vector<Material> materials;  ///< besides the library
  MeshRods rods;
  std::vector<DeformerBrief> deformers;
  std::vector<MeshPose> poses;
  MeshDesign design;
  MeshPrint print;

  /// Everything that can be said without files: names resolve, numbers are possible. Places are JSON pointers.
  Status validate() const;
};

}  // namespace lissom
