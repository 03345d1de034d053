#pragma once
/// How a document names nodes: ends of rods, places along them, points in space or of the plan, boxes, named sets, and unions of these.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lissom/core/types.h"

namespace lissom {

/// A set of nodes, resolved on the discretised structure.
struct Selector {
  enum class Kind {
    kSet,       ///< `name` of a named set
    kAll,       ///< every node
    kRod,       ///< nodes of rod `name`: all of them, or the one at `fraction` of its length when fraction >= 0
    kPoint,     ///< the node nearest to `point`; must lie within `tolerance`
    kBox,       ///< nodes with low <= x <= high
    kJoints,    ///< every node where rods meet: ends of two or more, or an end on or a crossing with a rod that passes
    kEnds,      ///< every end of a rod at which no other rod ends or passes
    kBoundary,  ///< outer loop of a line network: its nodes where rods meet or end, all of them on a ring, else free ends
    kMembrane,   ///< vertices of membrane `name`
    kRim,        ///< those of them at its edge, or at the part of it that `rim` says
    kPlanPoint,  ///< the node at the point `name` of the plan
    kUnion,      ///< all of `parts`
  };
  enum class Rim {
    kAll,
    kOuter,  ///< the longest closed line of the edge
    kInner,  ///< the others: edges of holes
  };
  Kind kind = Kind::kAll;
  std::string name;
  double fraction = -1;                          ///< of the rod's rest length, 0 = start, 1 = end
  Vec3 point = Vec3::Zero();                     ///< m
  double tolerance = 0;                          ///< m; 0: half the mean edge length
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();  ///< m
  Rim rim = Rim::kAll;
  std::vector<Selector> parts;
};

/// A kind of selector that is one word in documents and on the command line.
struct SelectorWord {
  std::string_view word;
  Selector::Kind kind;
};
std::span<const SelectorWord> selector_words();

struct NamedSet {
  std::string name;
  Selector nodes;
};

}  // namespace lissom
