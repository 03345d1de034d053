#pragma once
/// Centroidal Voronoi tessellation of a surface [Du, Faber, Gunzburger 1999; thesis 5.2.2, 5.4]: cells of nearest points
/// about sites that are the centroids of their cells, so that most cells have six neighbours. Distances are measured
/// through space, but a cell grows along the surface only: the two sides of a thin part stay apart.

#include <cstdint>
#include <string>
#include <vector>

#include "lissom/core/context.h"
#include "lissom/core/result.h"
#include "lissom/geometry/surface_refine.h"

namespace lissom {

struct CellOptions {
  int cells = 64;           ///< at least 4
  uint32_t seed = 1;        ///< where the sites start
  double contrast = 1;      ///< width of cells on white over their width on black, at least 1
  int iterations = 500;     ///< of Lloyd's, at most
  double tolerance = 2e-3;  ///< of a cell's width: all sites move less in an iteration of a finished tessellation
};

struct SurfaceCells {
  RefinedSurface fine;     ///< with at least five edges across each cell
  std::vector<Vec3> site;  ///< m, per cell, on the surface
  std::vector<int> cell;   ///< per vertex of the fine surface
  int iterations = 0;
  double movement = 0;  ///< of the last iteration, the largest of a site, by the width of a cell
  std::vector<std::string>
      notes;  ///< cells that were added where one went all around a thin part, no end of iterations
};

/// A part of a triangle that belongs to one cell.
struct CellPiece {
  int cell = -1;
  std::vector<Vec3> corners;  ///< barycentric weights in the triangle, anticlockwise
};

/// How cells share a triangle of the fine surface. Where an edge has two cells at its ends they meet at the point as far
/// from both sites; where a triangle has three, so do they.
std::vector<CellPiece> cell_pieces(const SurfaceCells& cells, int triangle);

/// Weight of vertex b at the point of an edge (a, b) of the fine surface where the two cells meet.
double crossing(const SurfaceCells& cells, int a, int b);

/// Weights of the point of a triangle of the fine surface where three cells meet.
Vec3 triple_point(const SurfaceCells& cells, int triangle);

/// One connected manifold surface. kRange at `where` for options out of range; kGeometry where the surface is not
/// connected. Every cell of the result is a disc: where one is not, cells are added, and a note says so.
Result<SurfaceCells> tessellate(const Surface& surface, const CellOptions& options, const std::string& where,
                                const Context& context);

}  // namespace lissom
