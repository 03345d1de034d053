#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numeric>

#include "lissom/core/nearest_name.h"
#include "lissom/geometry/point_grid.h"
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

constexpr double kDefaultMerge = 1e-6;  // of the size of the structure
constexpr size_t kShownRemarks = 8;     // of one kind

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

/// Numbers the nodes in the order of the rods; points within the merge distance become the first of them.
Status merge_nodes(Draft& draft) {
  Structure& s = draft.structure;
  Vec3 low = draft.drawn.empty() ? draft.membranes[0].points[0] : draft.drawn[0].points[0], high = low;
  double shortest = std::numeric_limits<double>::infinity();
  size_t total = 0;
  for (const RodShape& rod : draft.drawn) {
    for (const Vec3& p : rod.points) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    for (double length : rod.lengths) shortest = std::min(shortest, length);
    total += rod.points.size();
  }
  for (const MembraneMesh& membrane : draft.membranes) {
    for (const Vec3& p : membrane.points) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    for (const std::array<int, 3>& t : membrane.triangles) {
      const double side = (membrane.points[t[1]] - membrane.points[t[0]]).norm();
      if (side > 0) shortest = std::min(shortest, side);
    }
    total += membrane.points.size();
  }
  s.size = (high - low).norm();
  const double asked = draft.model.merge_distance;
  if (!std::isfinite(asked) || asked > s.size) {
    return Error{ErrorCode::kRange, "/merge_distance", fmt::format("the merge distance is {:g} m", asked),
                 fmt::format("the whole structure measures {:g} m: use less", s.size)};
  }
  const double distance = asked > 0 ? asked : kDefaultMerge * s.size;
  PointGrid grid(distance, std::max(shortest / 2, 1e-9 * s.size), asked < 0 ? 0 : total);
  for (size_t r = 0; r < draft.drawn.size(); ++r) {
    RodShape& rod = draft.drawn[r];
    StructureRod out;
    out.name = draft.model.rods[r].name;
    out.material = draft.model.rods[r].material;
    out.closed = rod.closed;
    out.nodes.reserve(rod.points.size());
    bool moved = false;
    for (Vec3& p : rod.points) {
      int node = static_cast<int>(s.nodes.size());
      if (asked >= 0) node = grid.insert(p);
      if (node == static_cast<int>(s.nodes.size())) s.nodes.push_back(p);
      const Vec3& merged = s.nodes[static_cast<size_t>(node)];
      moved = moved || merged != p;
      p = merged;
      out.nodes.push_back(node);
    }
    if (moved) {
      if (Status status = measure_edges(rod, rod_place(r), rod_label(draft.model, r)); !status) return status;
    }
    s.rods.push_back(std::move(out));
  }
  for (size_t m = 0; m < draft.membranes.size(); ++m) {
    const Membrane& membrane = draft.model.membranes[m];
    StructureMembrane out;
    out.name = membrane.name;
    out.material = membrane.material;
    out.pre_stretch = membrane.pre_stretch;
    out.warp_angle = membrane.warp_angle;
    out.bending = membrane.bending;
    out.rest_folds = membrane.rest_folds;
    for (const Vec3& p : draft.membranes[m].points) {
      int node = static_cast<int>(s.nodes.size());
      if (asked >= 0) node = grid.insert(p);
      if (node == static_cast<int>(s.nodes.size())) s.nodes.push_back(p);
      out.nodes.push_back(node);
    }
    s.membranes.push_back(std::move(out));
  }
  draft.passages.assign(s.nodes.size(), 0);
  for (const StructureRod& rod : s.rods) {
    for (int node : rod.nodes) ++draft.passages[static_cast<size_t>(node)];
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
  if (edges == 0) {  // membranes alone
    for (const StructureTriangle& t : s.triangles) {
      for (int i = 0; i < 3; ++i, ++edges) length += (s.nodes[t.node[i]] - s.nodes[t.node[(i + 1) % 3]]).norm();
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
  if (model.rods.empty() && model.membranes.empty()) {
    return Error{ErrorCode::kGeometry, "/rods", "there is no rod and no membrane", "describe at least one"};
  }
  Draft draft{model, {}, {}, {}, {}, {}, {}, cut_rods_from};
  for (const NetworkFile& file : model.network_files) {
    draft.structure.notes.insert(draft.structure.notes.end(), file.notes.begin(), file.notes.end());
  }
  if (Status s = sample_rods(draft, refine); !s) return s.error();
  if (Status s = cut_membranes(draft, refine); !s) return s.error();
  if (Status s = merge_nodes(draft); !s) return s.error();
  if (Status s = set_membranes(draft); !s) return s.error();
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
