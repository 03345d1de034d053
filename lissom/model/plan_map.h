#pragma once
/// How the fabric and the radii of an expanded plan move with its control points, while the triangles stay as they are
/// [mathematics (6.1), corrected]: nodes of rods follow their splines, inner vertices of the fabric follow the nodes by
/// harmonic weights (cotangents of the mesh as expanded, which reproduce that mesh).

#include <memory>
#include <span>
#include <vector>

#include "lissom/model/expand_plan.h"

namespace lissom {

/// How good the triangles are at other places of their corners.
struct MeshQuality {
  double smallest_angle = 0;  ///< rad; negative when a triangle is turned over
  /// Least of angle / angle as expanded over all triangles, angle the smallest of a triangle: 1 as expanded, negative
  /// when one is turned over.
  double ratio = 1;
  int triangle = -1;  ///< the one with the least ratio
};

/// For use by any number of threads.
class PlanMap {
 public:
  /// Of a plan and what it was expanded to.
  static Result<PlanMap> make(const Plan& plan, const ExpandedPlan& expanded);
  ~PlanMap();
  PlanMap(PlanMap&&) noexcept;
  PlanMap& operator=(PlanMap&&) noexcept;

  int points() const;    ///< C, control points
  int nodes() const;     ///< N, nodes of rods and ghosts, the first vertices of the fabric
  int vertices() const;  ///< V, vertices of the fabric

  /// m, (V x 2), of the control points at m, (C x 2).
  MatX positions(const MatX& controls) const;
  /// d positions / d controls at these controls, (2V x 2C); rows and columns x0, y0, x1, y1, ... Constant unless the plan
  /// has arcs.
  SparseMatrix position_jacobian(const MatX& controls) const;
  bool linear() const;  ///< no arcs
  /// The change of position_jacobian' y along v at these controls: zero without arcs. y: (V x 2), v and result: (C x 2).
  MatX position_curvature(const MatX& controls, const MatX& y, const MatX& v) const;

  /// m, (N), of the radii of control points, (C); for r_n and r_b alike. Where a spline dips to nothing between thick and
  /// thin, the radius is a twentieth of the smallest at the ends of the piece.
  VecX radii(const VecX& controls) const;
  /// d radii / d controls, (N x C).
  SparseMatrix radius_jacobian(const VecX& controls) const;

  MeshQuality quality(const MatX& positions) const;

 private:
  struct Impl;
  explicit PlanMap(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace lissom
