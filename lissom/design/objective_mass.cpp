#include "lissom/design/objective_mass.h"

#include <utility>

#include "lissom/design/part_of_structure.h"
#include "lissom/mechanics/rest_numbers.h"

namespace lissom {

namespace {

constexpr double kFelt = 0.01;  // of the whole

enum class Amount { kMass, kVolume };

/// A rest number with what one of it amounts to.
struct Share {
  int number;
  double value, factor;
};

class MaterialAmount final : public Objective {
 public:
  MaterialAmount(StructurePart part, Amount amount) : part_(std::move(part)), amount_(amount) {}

  std::string_view name() const override { return amount_ == Amount::kMass ? "mass" : "material volume"; }
  std::string_view unit() const override { return amount_ == Amount::kMass ? "kg" : "m^3"; }
  int size() const override { return 1; }
  double scale(const PoseShape& shape) const override { return kFelt * total(shape); }

  void values(const PoseShape& shape, VecX& c) const override { c = VecX::Constant(1, total(shape)); }

  void jacobian(const PoseShape& shape, SparseRows& by_q, SparseRows& by_numbers) const override {
    by_q.resize(1, shape.design.system.layout.size());
    std::vector<Eigen::Triplet<double>> entries;
    for (const Share& s : shares(shape)) entries.emplace_back(0, s.number, s.factor);
    by_numbers.resize(1, RestNumbers(shape.design.system.structure).size());
    by_numbers.setFromTriplets(entries.begin(), entries.end());
  }

  void curvature(const PoseShape&, const VecX&, const VecX&, const VecX&, VecX&, VecX&) const override {}

 private:
  double total(const PoseShape& shape) const {
    double sum = 0;
    for (const Share& s : shares(shape)) sum += s.factor * s.value;
    return sum;
  }

  std::vector<Share> shares(const PoseShape& shape) const {
    const Model& model = shape.design.model;
    const Structure& structure = shape.design.system.structure;
    const RestState& rest = shape.design.system.rest;
    const RestNumbers numbers(structure);
    std::vector<Share> shares;
    if (part_.all() || !part_.rods.empty()) {
      for (const int r : rods_or_all(structure, part_.rods)) {
        const double factor = amount_ == Amount::kMass ? 1 : 1 / model.material(structure.rods[r].material)->density;
        for (const int e : structure.rods[r].edges) {
          shares.push_back({numbers.edge(e, kEdgeMass), rest.edges[e].mass, factor});
        }
      }
    }
    if (part_.all() || !part_.membranes.empty()) {
      for (const int t : triangles_of(structure, part_.membranes)) {
        const StructureMembrane& membrane = structure.membranes[structure.triangles[t].membrane];
        const MembraneMaterial& fabric = *model.membrane_material(membrane.material);
        shares.push_back(
            {numbers.triangle(t, kTriangleArea), rest.triangles[t].area,
             amount_ == Amount::kMass ? structure.triangles[t].density * fabric.area_density : fabric.thickness});
      }
    }
    if (!part_.all()) return shares;
    for (int t = 0; t < static_cast<int>(structure.tetrahedra.size()); ++t) {
      const StructureTetrahedron& own = structure.tetrahedra[t];
      const double density = own.density * model.material(structure.solids[own.solid].material)->density;
      shares.push_back({numbers.tetrahedron(t, kTetrahedronVolume), rest.tetrahedra[t].volume,
                        amount_ == Amount::kMass ? density : 1});
    }
    return shares;
  }

  StructurePart part_;
  Amount amount_;
};

}  // namespace

std::shared_ptr<const Objective> make_mass(StructurePart part) {
  return std::make_shared<MaterialAmount>(std::move(part), Amount::kMass);
}

Result<std::shared_ptr<const Objective>> make_material_volume(const Model& model, const Structure& structure,
                                                              StructurePart part) {
  if (part.all() || !part.rods.empty()) {
    for (const int r : rods_or_all(structure, part.rods)) {
      const StructureRod& rod = structure.rods[r];
      if (model.material(rod.material)->density > 0) continue;
      return Error{ErrorCode::kConflict, "material volume",
                   "material \"" + rod.material + "\" of rod \"" + rod.name + "\" has no density",
                   "give it one; gravity acts only where a pose has it"};
    }
  }
  return std::shared_ptr<const Objective>(std::make_shared<MaterialAmount>(std::move(part), Amount::kVolume));
}

}  // namespace lissom
