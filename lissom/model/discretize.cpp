#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

#include "lissom/core/nearest_name.h"
#include "lissom/model/discretize_parts.h"
#include "lissom/model/expand_plan.h"
#include "lissom/model/limits.h"
#include "lissom/model/sampling.h"
#include "lissom/model/structure.h"

namespace lissom {

std::string rod_place(size_t rod) { return fmt::format("/rods/{}", rod); }

std::string rod_label(const Model& model, size_t rod) {
  const std::string& name = model.rods[rod].name;
  return name.empty() ? fmt::format("rod {}", rod) : fmt::format("rod \"{}\"", name);
}

Status measure_edges(RodShape& shape, const std::string& where, const std::string& label) {
  const size_t nodes = shape.points.size(), edges = shape.closed ? nodes : nodes - 1;
  shape.lengths.resize(edges);
  shape.edge_tangents.resize(edges);
  for (size_t i = 0; i < edges; ++i) {
    const Vec3 edge = shape.points[(i + 1) % nodes] - shape.points[i];
    const double length = edge.norm();
    if (!(length > 0)) {
      return Error{ErrorCode::kGeometry, where, fmt::format("edge {} of {} has no length", i, label),
                   "use fewer edges, a smaller merge distance, or points further apart"};
    }
    shape.lengths[i] = length;
    shape.edge_tangents[i] = edge / length;
  }
  for (size_t i = shape.closed ? 0 : 1; i < edges; ++i) {
    if (1 + shape.edge_tangents[(i + edges - 1) % edges].dot(shape.edge_tangents[i]) > 1e-9) continue;
    return Error{ErrorCode::kGeometry, where, fmt::format("{} doubles back on itself at node {}", label, i),
                 "end the rod there and start another one"};
  }
  return {};
}

namespace {

constexpr size_t kShownRemarks = 8;  // of one kind

Section section_at(const SectionProfile& profile, double place, bool closed) {
  const auto value = [&](const std::vector<double>& controls) {
    const size_t n = controls.size();
    if (n == 1) return controls[0];
    const double u = place * double(closed ? n : n - 1);
    const size_t i = std::min(static_cast<size_t>(u), closed ? n - 1 : n - 2);
    const double s = u - double(i);
    return (1 - s) * controls[i] + s * controls[(i + 1) % n];
  };
  return {profile.shape, value(profile.r_n), value(profile.r_b), profile.wall};
}

Status check_rod(const Model& model, size_t r) {
  const Rod& rod = model.rods[r];
  if (!model.material(rod.material)) {
    std::vector<std::string> names;
    for (const Material& own : model.materials) names.push_back(own.name);
    for (const Material& known : material_library()) names.push_back(known.name);
    return Error{ErrorCode::kUnknown, rod_place(r) + "/material",
                 fmt::format("{} is of a material \"{}\" that is not known", rod_label(model, r), rod.material),
                 suggestion(rod.material, names)};
  }
  const SectionProfile& profile = rod.section;
  if (profile.r_n.empty() || profile.r_n.size() != profile.r_b.size()) {
    return Error{
        ErrorCode::kType, rod_place(r) + "/section",
        fmt::format("the section has {} half-extents along n and {} along b", profile.r_n.size(), profile.r_b.size()),
        "give the same number of both, at least one"};
  }
  for (size_t i = 0; i < profile.r_n.size(); ++i) {
    const Section section{profile.shape, profile.r_n[i], profile.r_b[i], profile.wall};
    if (Status s = section.validate(rod_place(r) + "/section"); !s) return s;
  }
  return {};
}

/// Cuts every rod. Node tangents and points are those of the curves, not yet merged.
Status sample_rods(Draft& draft, double refine) {
  const Model& model = draft.model;
  double nodes = 0;
  std::vector<int> counts;
  for (size_t r = 0; r < model.rods.size(); ++r) {
    if (Status s = check_rod(model, r); !s) return s;
    const Result<int> edges = edge_count(model.rods[r], r < draft.cut_rods_from ? refine : 1, rod_place(r));
    if (!edges) return edges.error();
    counts.push_back(edges.value());
    nodes += edges.value() + 1;
    if (nodes > kMostNodes) {
      return Error{ErrorCode::kRange, rod_place(r),
                   fmt::format("the structure would have more than {} nodes", kMostNodes), "use fewer or longer edges"};
    }
  }
  for (size_t r = 0; r < model.rods.size(); ++r) {
    Result<CurveSamples> samples = sample(model.rods[r].curve, counts[r], rod_place(r) + "/curve");
    if (!samples) return samples.error();
    CurveSamples cut = std::move(samples).value();
    draft.drawn.push_back({std::move(cut.points), std::move(cut.tangents), {}, {}, {}, cut.closed});
    if (Status s = measure_edges(draft.drawn.back(), rod_place(r), rod_label(model, r)); !s) return s;
  }
  return {};
}

void set_edges(Draft& draft) {
  Structure& s = draft.structure;
  double length = 0;
  for (size_t r = 0; r < s.rods.size(); ++r) {
    StructureRod& rod = s.rods[r];
    const int edges = draft.drawn[r].edges();
    for (int i = 0; i < edges; ++i) {
      StructureEdge edge;
      edge.node0 = rod.nodes[static_cast<size_t>(i)];
      edge.node1 = rod.nodes[static_cast<size_t>(i + 1) % rod.nodes.size()];
      edge.rod = static_cast<int>(r);
      edge.section = section_at(draft.model.rods[r].section, (i + 0.5) / edges, rod.closed);
      rod.edges.push_back(static_cast<int>(s.edges.size()));
      s.edges.push_back(edge);
      length += draft.drawn[r].lengths[static_cast<size_t>(i)];
    }
  }
  size_t edges = s.edges.size();
  if (edges == 0) {  // membranes and solids alone
    for (const StructureTriangle& t : s.triangles) {
      for (int i = 0; i < 3; ++i, ++edges) length += (s.nodes[t.node[i]] - s.nodes[t.node[(i + 1) % 3]]).norm();
    }
    for (const StructureTetrahedron& t : s.tetrahedra) {
      for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < i; ++j, ++edges) length += (s.nodes[t.node[i]] - s.nodes[t.node[j]]).norm();
      }
    }
  }
  s.mean_edge_length = length / double(edges);
}

void set_components(Structure& s) {
  std::vector<int> parent(s.nodes.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int i) {
    while (parent[static_cast<size_t>(i)] != i) {
      int& p = parent[static_cast<size_t>(i)];
      p = parent[static_cast<size_t>(p)];
      i = p;
    }
    return i;
  };
  const auto join = [&](int i, int j) {
    const int a = root(i), b = root(j);
    parent[static_cast<size_t>(std::max(a, b))] = std::min(a, b);
  };
  for (const StructureEdge& edge : s.edges) join(edge.node0, edge.node1);
  for (const StructureTriangle& t : s.triangles) {
    join(t.node[0], t.node[1]);
    join(t.node[0], t.node[2]);
  }
  for (const StructureTetrahedron& t : s.tetrahedra) {
    for (int i = 1; i < 4; ++i) join(t.node[0], t.node[i]);
  }
  s.component.assign(s.nodes.size(), -1);
  for (size_t i = 0; i < s.nodes.size(); ++i) {
    const size_t r = static_cast<size_t>(root(static_cast<int>(i)));
    s.component[i] = r == i ? s.components++ : s.component[r];
  }
}

void set_drawn_frames(Draft& draft) {
  Structure& s = draft.structure;
  set_joint_normals(draft);
  std::vector<std::string> remarks;
  for (size_t r = 0; r < s.rods.size(); ++r) {
    const StructureRod& rod = s.rods[r];
    const Vec3& start = draft.joint_normals[static_cast<size_t>(rod.nodes.front())];
    const Vec3& end = draft.joint_normals[static_cast<size_t>(rod.nodes.back())];
    set_frames(draft.drawn[r], draft.model.rods[r].axes, start, end, rod_label(draft.model, r), remarks);
    for (size_t i = 0; i < rod.edges.size(); ++i) {
      s.edges[static_cast<size_t>(rod.edges[i])].drawn = draft.drawn[r].frames[i];
    }
  }
  for (size_t i = 0; i < std::min(remarks.size(), kShownRemarks); ++i) s.notes.push_back(remarks[i]);
  if (remarks.size() > kShownRemarks) {
    s.notes.push_back(fmt::format("{} more rods have such remarks on their normals", remarks.size() - kShownRemarks));
  }
}

/// Of a model without a plan, or one whose plan is expanded.
Result<Structure> discretize_parts(const Model& model, double refine, size_t cut_rods_from) {
  if (model.rods.empty() && model.membranes.empty() && model.solids.empty()) {
    return Error{ErrorCode::kGeometry, "/rods", "there is no rod, no membrane and no solid", "describe at least one"};
  }
  Draft draft{model, {}, {}, {}, {}, {}, {}, cut_rods_from};
  for (const NetworkFile& file : model.network_files) {
    draft.structure.notes.insert(draft.structure.notes.end(), file.notes.begin(), file.notes.end());
  }
  if (Status s = sample_rods(draft, refine); !s) return s.error();
  if (Status s = cut_membranes(draft, refine); !s) return s.error();
  if (Status s = check_solids(draft); !s) return s.error();
  if (Status s = merge_nodes(draft); !s) return s.error();
  if (Status s = set_membranes(draft); !s) return s.error();
  if (Status s = set_solids(draft); !s) return s.error();
  set_edges(draft);
  set_components(draft.structure);
  set_drawn_frames(draft);
  if (Status s = set_rest_shapes(draft); !s) return s.error();
  if (Status s = set_joints_and_pairs(draft); !s) return s.error();
  if (Status s = check_supports(draft); !s) return s.error();
  note_turning_angles(draft);
  note_loose_ends(draft);
  return std::move(draft.structure);
}

/// Of a model that a plan was appended to, with the notes on it.
Result<Structure> discretize_whole(const Model& whole, double refine, size_t cut_rods_from,
                                   const std::vector<std::string>& notes) {
  Result<Structure> structure = discretize_parts(whole, refine, cut_rods_from);
  if (structure) {
    std::vector<std::string>& all = structure.value().notes;
    all.insert(all.begin(), notes.begin(), notes.end());
  }
  return structure;
}

}  // namespace

Result<Structure> discretize(const Model& model, double refine) {
  if (!model.plan) return discretize_parts(model, refine, model.rods.size());
  const Result<ExpandedPlan> plan = expand_plan(model, refine);
  if (!plan) return plan.error();
  return discretize_whole(with_plan_expanded(model, plan.value()), refine, model.rods.size(), plan.value().notes);
}

Result<Structure> discretize(const Model& model, const ExpandedPlan& plan) {
  return discretize_whole(with_plan_expanded(model, plan), plan.refine, model.rods.size(), plan.notes);
}

}  // namespace lissom
