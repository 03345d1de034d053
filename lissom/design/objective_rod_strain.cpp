#include "lissom/design/objective_rod_strain.h"

#include <array>
#include <utility>

#include "lissom/design/objective_stencils.h"
#include "lissom/design/section_strain.h"
#include "lissom/mechanics/joint_explicit.h"

namespace lissom {

namespace {

constexpr double kFelt = 1e-3;

/// What a place is made of, besides its unknowns and rest numbers.
struct PlaceStencil : ObjectiveStencil {
  SectionShape shape = SectionShape::kEllipse;
  double wall = 0, poisson_ratio = 0;
};

/// Half-extent from the ratio of bending and axial stiffness, the mean square of a coordinate over the section.
template <class T>
T half_extent(const PlaceStencil& s, const T& mean_square) {
  using std::sqrt;
  switch (s.shape) {
    case SectionShape::kEllipse:
      return T(2) * sqrt(mean_square);
    case SectionShape::kRectangle:
      return sqrt(T(T(3) * mean_square));
    case SectionShape::kTube:  // R^2 + (R - wall)^2 = 4 mean square
      return (sqrt(T(T(8) * mean_square - T(s.wall * s.wall))) + T(s.wall)) * T(0.5);
  }
  return T(0);
}

/// `spring`: rest numbers in PairRestIndex order.
template <class T>
T strain_of_place(const PlaceStencil& s, const FrameT<T>& first, const FrameT<T>& second, double near, const T* spring,
                  const T& axial, const T& stretch_stiffness) {
  const Curvature<T> k = curvature(first, second);
  const T per = T(1) / spring[kPairLength];
  const SectionState<T> state{axial,
                              (k.kappa_1 - spring[kKappa1]) * per,
                              (k.kappa_2 - spring[kKappa2]) * per,
                              (twist(first, second, near) - spring[kRestTwist]) * per,
                              half_extent<T>(s, spring[kBend1] / stretch_stiffness),
                              half_extent<T>(s, spring[kBend2] / stretch_stiffness)};
  return section_strain(s.shape, state, s.poisson_ratio);
}

template <class T>
Vec3T<T> side(const T* from, const T* to) {
  return {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
}

template <class T>
T length_of(const Vec3T<T>& side) {
  using std::sqrt;
  return sqrt(T(side.dot(side)));
}

/// Unknowns: three nodes, two rolls. Numbers: the pair, then length and E A of both edges.
struct InnerStrain {
  struct Stencil : PlaceStencil {
    std::array<Vec3, 2> t, b;  // anchors
    double twist = 0;
  };
  template <class T>
  static T value(const T* x, const T* rest, const Stencil& s) {
    const Vec3T<T> e1 = side(x, x + 3), e2 = side(x + 3, x + 6);
    const FrameT<T> first = edge_frame<T>(e1, x[9], s.t[0], s.b[0]), second = edge_frame<T>(e2, x[10], s.t[1], s.b[1]);
    const T* edges = rest + kPairRestCount;
    const T whole = edges[0] + edges[2];
    const T axial = (length_of(e1) + length_of(e2)) / whole - T(1);
    const T stretch = (edges[0] * edges[1] + edges[2] * edges[3]) / whole;  // as bending stiffnesses are averaged
    return strain_of_place<T>(s, first, second, s.twist, rest, axial, stretch);
  }
};

/// Unknowns: two nodes, roll, joint rotation. Numbers: the connection, then length and E A of the edge.
struct HeldStrain {
  struct Stencil : PlaceStencil {
    Vec3 t, b;  // anchor of the edge
    Mat3 rotation;
    Frame rest_frame;
    double twist = 0;
    int direction = 1;
  };
  template <class T>
  static T value(const T* x, const T* rest, const Stencil& s) {
    const Vec3T<T> e = side(x, x + 3), r(x[7], x[8], x[9]);
    const FrameT<T> edge = edge_frame<T>(e, x[6], s.t, s.b);
    const Vec3T<T> turn(rest[kRestTurn], rest[kRestTurn + 1], rest[kRestTurn + 2]);
    const auto held_axis = [&](const Vec3& axis) {
      const Vec3T<T> at_rest = rotated_by_vector<T>(turn, axis.cast<T>());
      return rotated_by_vector<T>(r, Vec3T<T>(s.rotation.cast<T>() * at_rest));
    };
    const FrameT<T> held{held_axis(s.rest_frame.t), held_axis(s.rest_frame.b)};
    const T* own = rest + kConnectionRestCount;
    const bool leaves = s.direction > 0;
    return strain_of_place<T>(s, leaves ? held : edge, leaves ? edge : held, s.twist, rest,
                              length_of(e) / own[0] - T(1), own[1]);
  }
};

/// Unknowns: joint node, far nodes, rolls. Numbers: all connections of the joint, then length and E A of the edge.
struct CorotationalStrain {
  struct Stencil : PlaceStencil {
    CorotationalAnchors anchors;
    int place = 0;  // among the edges of the joint
  };
  template <class T>
  static T value(const T* x, const T* rest, const Stencil& s) {
    std::array<FrameT<T>, kMaxCorotationalEdges> edge, held;
    corotational_frames<T>(x, rest, s.anchors, edge.data(), held.data());
    const T* own = rest + s.anchors.count * kConnectionRestCount;
    const int i = s.place;
    const bool leaves = s.anchors.edge[i].direction > 0;
    return strain_of_place<T>(s, leaves ? held[i] : edge[i], leaves ? edge[i] : held[i], s.anchors.edge[i].twist,
                              rest + i * kConnectionRestCount, length_of(side(x, x + 3 + 3 * i)) / own[0] - T(1),
                              own[1]);
  }
};

/// All places of a shape, by kind.
struct Places {
  std::vector<InnerStrain::Stencil> pairs;
  std::vector<HeldStrain::Stencil> held;
  std::vector<CorotationalStrain::Stencil> corotational;
};

class RodStrain final : public Objective {
 public:
  RodStrain(std::vector<int> pairs, std::vector<int> connections)
      : pairs_(std::move(pairs)), connections_(std::move(connections)) {}

  std::string_view name() const override { return "rod strain"; }
  std::string_view unit() const override { return ""; }
  int size() const override { return static_cast<int>(pairs_.size() + connections_.size()); }
  double scale(const PoseShape&) const override { return kFelt; }

  void values(const PoseShape& shape, VecX& c) const override {
    const Places places = places_of(shape);
    c.setZero(size());
    add_values<InnerStrain>(places.pairs, shape.state, c);
    add_values<HeldStrain>(places.held, shape.state, c);
    add_values<CorotationalStrain>(places.corotational, shape.state, c);
  }

  void jacobian(const PoseShape& shape, SparseRows& by_q, SparseRows& by_numbers) const override {
    const Places places = places_of(shape);
    JacobianEntries entries;
    add_jacobian<InnerStrain>(places.pairs, shape.state, entries);
    add_jacobian<HeldStrain>(places.held, shape.state, entries);
    add_jacobian<CorotationalStrain>(places.corotational, shape.state, entries);
    entries.write(shape, size(), by_q, by_numbers);
  }

  void curvature(const PoseShape& shape, const VecX& y, const VecX& dq, const VecX& dn, VecX& by_q,
                 VecX& by_numbers) const override {
    const Places places = places_of(shape);
    add_curvature<InnerStrain>(places.pairs, shape.state, y, dq, dn, by_q, by_numbers);
    add_curvature<HeldStrain>(places.held, shape.state, y, dq, dn, by_q, by_numbers);
    add_curvature<CorotationalStrain>(places.corotational, shape.state, y, dq, dn, by_q, by_numbers);
  }

 private:
  static void set_section(const PoseShape& shape, int edge, PlaceStencil& s) {
    const StructureEdge& own = shape.design.system.structure.edges[edge];
    s.shape = own.section.shape;
    s.wall = own.section.wall;
    s.poisson_ratio = shape.design.model.material(shape.design.system.structure.rods[own.rod].material)->poisson_ratio;
  }

  static void add_edge_numbers(const PoseShape& shape, int edge, PlaceStencil& s) {
    const RestNumbers numbers(shape.design.system.structure);
    s.add_number(numbers.edge(edge, kEdgeLength), shape.design.system.rest.edges[edge].length);
    s.add_number(numbers.edge(edge, kEdgeStretch), shape.design.system.rest.edges[edge].stretch);
  }

  static void add_connection_numbers(const PoseShape& shape, int connection, PlaceStencil& s) {
    const RestNumbers numbers(shape.design.system.structure);
    const auto rest = connection_rest_values(shape.design.system.rest.connections[connection]);
    for (int i = 0; i < kConnectionRestCount; ++i) s.add_number(numbers.connection(connection, i), rest[i]);
  }

  static InnerStrain::Stencil pair_stencil(const PoseShape& shape, int p) {
    const System& system = shape.design.system;
    const StructurePair& pair = system.structure.pairs[p];
    const StructureEdge &e0 = system.structure.edges[pair.edge0], &e1 = system.structure.edges[pair.edge1];
    InnerStrain::Stencil s;
    set_section(shape, pair.edge0, s);
    for (const int node : {e0.node0, e0.node1, e1.node1}) s.add_node(node);
    s.dofs.push_back(system.layout.roll(pair.edge0));
    s.dofs.push_back(system.layout.roll(pair.edge1));
    const auto rest = rest_values(system.rest.pairs[p]);
    for (int i = 0; i < kPairRestCount; ++i) {
      s.add_number(RestNumbers(system.structure).pair(p, i), rest[i]);
    }
    add_edge_numbers(shape, pair.edge0, s);
    add_edge_numbers(shape, pair.edge1, s);
    const EdgeState &now0 = shape.state.edges[pair.edge0], &now1 = shape.state.edges[pair.edge1];
    s.t = {now0.t, now1.t};
    s.b = {now0.reference_b, now1.reference_b};
    s.twist = shape.state.pair_twist[p];
    return s;
  }

  static HeldStrain::Stencil held_stencil(const PoseShape& shape, int k) {
    const System& system = shape.design.system;
    const Connection& connection = system.connections[k];
    const StructureEdge& edge = system.structure.edges[connection.edge];
    HeldStrain::Stencil s;
    set_section(shape, connection.edge, s);
    s.add_node(edge.node0);
    s.add_node(edge.node1);
    s.dofs.push_back(system.layout.roll(connection.edge));
    for (int i = 0; i < 3; ++i) s.dofs.push_back(system.layout.rotation(connection.joint) + i);
    add_connection_numbers(shape, k, s);
    add_edge_numbers(shape, connection.edge, s);
    const EdgeState& now = shape.state.edges[connection.edge];
    s.t = now.t;
    s.b = now.reference_b;
    s.rotation = shape.state.joint_rotation[connection.joint];
    s.rest_frame = connection.rest;
    s.twist = shape.state.connection_twist[k];
    s.direction = connection.direction;
    return s;
  }

  static CorotationalStrain::Stencil corotational_stencil(const PoseShape& shape, int k) {
    const System& system = shape.design.system;
    const int joint = system.connections[k].joint, first = system.first_connection[joint];
    CorotationalStrain::Stencil s;
    set_section(shape, system.connections[k].edge, s);
    s.place = k - first;
    s.anchors.count = system.first_connection[joint + 1] - first;
    s.anchors.rotation = shape.state.joint_rotation[joint];
    s.anchors.weights = shape.design.model.joint_weights;
    s.add_node(system.structure.joints[joint].node);
    for (int i = 0; i < s.anchors.count; ++i) {
      const Connection& connection = system.connections[first + i];
      const StructureEdge& edge = system.structure.edges[connection.edge];
      s.add_node(connection.direction > 0 ? edge.node1 : edge.node0);
      add_connection_numbers(shape, first + i, s);
      const EdgeState& now = shape.state.edges[connection.edge];
      s.anchors.edge[i] = {now.t, now.reference_b, shape.state.connection_twist[first + i], connection.direction,
                           connection.rest};
    }
    for (int i = 0; i < s.anchors.count; ++i) s.dofs.push_back(system.layout.roll(system.connections[first + i].edge));
    add_edge_numbers(shape, system.connections[k].edge, s);
    return s;
  }

  Places places_of(const PoseShape& shape) const {
    Places places;
    int component = 0;
    for (const int p : pairs_) {
      places.pairs.push_back(pair_stencil(shape, p));
      places.pairs.back().component = component++;
    }
    const System& system = shape.design.system;
    for (const int k : connections_) {
      if (system.layout.rotation(system.connections[k].joint) >= 0) {
        places.held.push_back(held_stencil(shape, k));
        places.held.back().component = component++;
      } else {
        places.corotational.push_back(corotational_stencil(shape, k));
        places.corotational.back().component = component++;
      }
    }
    return places;
  }

  std::vector<int> pairs_, connections_;
};

}  // namespace

std::shared_ptr<const Objective> make_rod_strain(const System& system, const std::vector<int>& rods) {
  std::vector<bool> wanted(system.structure.rods.size(), rods.empty());
  for (const int r : rods) wanted[r] = true;
  const auto in = [&](int edge) { return wanted[system.structure.edges[edge].rod]; };
  std::vector<int> pairs, connections;
  for (int p = 0; p < static_cast<int>(system.structure.pairs.size()); ++p) {
    if (in(system.structure.pairs[p].edge0)) pairs.push_back(p);
  }
  for (int k = 0; k < static_cast<int>(system.connections.size()); ++k) {
    if (in(system.connections[k].edge)) connections.push_back(k);
  }
  return std::make_shared<RodStrain>(std::move(pairs), std::move(connections));
}

}  // namespace lissom
