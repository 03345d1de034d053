#pragma once
/// What takes the shape of a pose in the place of the rods: the surface as a shell, or a body that fills it [thesis 4.2.3,
/// 5.4]. Both are ordinary structures; their equilibria are those of any other.

#include <optional>
#include <string>
#include <vector>

#include "lissom/core/context.h"
#include "lissom/core/result.h"
#include "lissom/geometry/surface.h"
#include "lissom/geometry/tetrahedra_embedding.h"
#include "lissom/mechanics/system.h"
#include "lissom/model/model.h"
#include "lissom/model/rod_mesh.h"

namespace lissom {

class Deformer {
 public:
  /// Errors at `where`: bodies need a closed surface, tetrahedra that are small enough.
  static Result<Deformer> make(const DeformerBrief& brief, const Surface& surface, const std::string& where);

  /// The surface's vertices in the equilibrium of a pose, m. kConflict at `where` with the reason where none is stable.
  Result<std::vector<Vec3>> posed(const Pose& pose, const std::string& where, const Context& context) const;

  /// How much each vertex of the surface belongs to what a selector names, 0 to 1. An error where it names nothing.
  Result<VecX> selected(const Selector& selector, const std::string& where) const;

 private:
  Deformer() = default;
  /// Places of the surface's vertices when the nodes of the structure are at `nodes` (m).
  std::vector<Vec3> on_surface(const std::vector<Vec3>& nodes) const;

  Model model_;
  System system_;                            // the same for all poses: no rods, so no frames that a pose could ask for
  std::optional<SolidEmbedding> embedding_;  // of the surface's vertices, in bodies
};

}  // namespace lissom
