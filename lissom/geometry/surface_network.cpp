#include "lissom/geometry/surface_network.h"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>
#include <numeric>

#include "lissom/geometry/surface_note.h"

namespace lissom {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

std::vector<int> joined(const std::vector<int>& a, const std::vector<int>& b) {
  std::vector<int> both;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  return both;
}

Status find_path(const Surface& surface, const SurfaceNetwork& network, SurfaceLine& line, const std::string& where) {
  const SurfacePlace &from = network.joints[at(line.joint[0])].place, &to = network.joints[at(line.joint[1])].place;
  std::optional<SurfacePath> path = shortest_path(surface, line.patch, from, to);
  if (!path) {
    return Error{ErrorCode::kGeometry, where,
                 fmt::format("no path on the surface leads from {} to {}", in_millimetres(position(surface, from)),
                             in_millimetres(position(surface, to))),
                 "mend the surface there (`lissom surface` names its defects), or ask for another number of cells"};
  }
  line.path = std::move(*path);
  return {};
}

/// Merges lines one by one.
class Merger {
 public:
  Merger(const Surface& surface, SurfaceNetwork& network, const NetworkOptions& options, const std::string& where)
      : surface_(surface), network_(network), options_(options), where_(where) {
    for (const SurfaceLine& line : network.lines) length_.push_back(path_length(surface, line.path));
    shortest_ = options.shortest * std::accumulate(length_.begin(), length_.end(), 0.0) /
                static_cast<double>(std::max<std::size_t>(1, length_.size()));
    kept_.assign(length_.size(), 0);
  }

  Status run() {
    int merged = 0;
    for (int line = next(); line >= 0; line = next()) {
      if (!may_merge(line)) {
        kept_[at(line)] = 1;
        continue;
      }
      if (Status s = merge(line); !s) return s;
      ++merged;
    }
    drop_unused_joints();
    if (merged > 0) {
      network_.notes.push_back(fmt::format("{} {} shorter than {:.3g} mm {} merged into a joint", merged,
                                           merged == 1 ? "line" : "lines", 1e3 * shortest_,
                                           merged == 1 ? "was" : "were"));
    }
    return {};
  }

 private:
  /// The shortest line that is too short and was not looked at; -1: none.
  int next() const {
    int best = -1;
    for (int l = 0; l < static_cast<int>(length_.size()); ++l) {
      if (kept_[at(l)] != 0 || length_[at(l)] >= shortest_) continue;
      if (best < 0 || length_[at(l)] < length_[at(best)]) best = l;
    }
    return best;
  }

  /// The joint that stays where it is; -1: the new one lies in the middle.
  int fixed_joint(const SurfaceLine& line) const {
    const auto rank = [&](int end) { return static_cast<int>(network_.joints[at(line.joint[at(end)])].kind); };
    if (rank(0) == rank(1)) return line.on_boundary ? line.joint[0] : -1;
    return line.joint[rank(0) > rank(1) ? 0 : 1];
  }

  std::vector<int> lines_at(int joint) const {
    std::vector<int> found;
    for (int l = 0; l < static_cast<int>(network_.lines.size()); ++l) {
      const std::array<int, 2>& ends = network_.lines[at(l)].joint;
      if (ends[0] == joint || ends[1] == joint) found.push_back(l);
    }
    return found;
  }

  int other_end(int line, int joint) const {
    const std::array<int, 2>& ends = network_.lines[at(line)].joint;
    return ends[0] == joint ? ends[1] : ends[0];
  }

  bool may_merge(int line) const {
    const SurfaceLine& l = network_.lines[at(line)];
    const SurfaceJoint::Kind a = network_.joints[at(l.joint[0])].kind, b = network_.joints[at(l.joint[1])].kind;
    if (a == SurfaceJoint::Kind::kCorner && b == SurfaceJoint::Kind::kCorner) return false;
    if (!l.on_boundary && a != SurfaceJoint::Kind::kInside && b != SurfaceJoint::Kind::kInside) return false;
    std::vector<int> around;
    for (const int joint : l.joint) {
      for (const int other : lines_at(joint)) {
        if (other != line) around.push_back(other_end(other, joint));
      }
    }
    std::sort(around.begin(), around.end());
    const bool twice = std::adjacent_find(around.begin(), around.end()) != around.end();
    const bool loop = std::binary_search(around.begin(), around.end(), l.joint[0]) ||
                      std::binary_search(around.begin(), around.end(), l.joint[1]);
    return !twice && !loop && static_cast<int>(around.size()) <= options_.valence;
  }

  Status merge(int line) {
    const SurfaceLine gone = network_.lines[at(line)];
    const int fixed = fixed_joint(gone);
    const int stays = fixed >= 0 ? fixed : gone.joint[0];
    const int goes = gone.joint[0] == stays ? gone.joint[1] : gone.joint[0];
    if (fixed < 0) network_.joints[at(stays)].place = sample_path(surface_, gone.path, 2)[1];
    network_.lines.erase(network_.lines.begin() + line);
    length_.erase(length_.begin() + line);
    kept_.erase(kept_.begin() + line);
    for (const int l : lines_at(goes)) {
      SurfaceLine& moved = network_.lines[at(l)];
      const std::size_t end = moved.joint[0] == goes ? 0 : 1;
      moved.joint[end] = stays;
      if (moved.on_boundary) extend(moved, end, gone, stays);
    }
    for (const int l : lines_at(stays)) {
      SurfaceLine& moved = network_.lines[at(l)];
      kept_[at(l)] = 0;
      if (!moved.on_boundary) {
        moved.patch = joined(moved.patch, gone.patch);
        for (const int other : lines_at(stays)) moved.patch = joined(moved.patch, network_.lines[at(other)].patch);
        if (Status s = find_path(surface_, network_, moved, where_); !s) return s;
      }
      length_[at(l)] = path_length(surface_, moved.path);
    }
    return {};
  }

  /// A line along the boundary goes on over the one that was merged.
  static void extend(SurfaceLine& line, std::size_t end, const SurfaceLine& gone, int stays) {
    const SurfacePath piece = gone.joint[1] == stays ? gone.path : reversed(gone.path);  // towards the joint that stays
    if (end == 1) {
      line.path.insert(line.path.end(), piece.begin(), piece.end());
    } else {
      const SurfacePath back = reversed(piece);
      line.path.insert(line.path.begin(), back.begin(), back.end());
    }
  }

  void drop_unused_joints() {
    const std::vector<int> valence = network_.valences();
    std::vector<int> renumbered(valence.size(), -1);
    std::vector<SurfaceJoint> used;
    for (std::size_t j = 0; j < valence.size(); ++j) {
      if (valence[j] == 0) continue;
      renumbered[j] = static_cast<int>(used.size());
      used.push_back(network_.joints[j]);
    }
    network_.joints = std::move(used);
    for (SurfaceLine& line : network_.lines) {
      for (int& joint : line.joint) joint = renumbered[at(joint)];
    }
  }

  const Surface& surface_;
  SurfaceNetwork& network_;
  const NetworkOptions& options_;
  const std::string& where_;
  double shortest_ = 0;         // m
  std::vector<double> length_;  // m, per line
  std::vector<char> kept_;      // lines that are short and have to stay
};

}  // namespace

std::vector<int> SurfaceNetwork::valences() const {
  std::vector<int> valence(joints.size(), 0);
  for (const SurfaceLine& line : lines) {
    for (const int joint : line.joint) ++valence[at(joint)];
  }
  return valence;
}

Status find_paths(const Surface& surface, SurfaceNetwork& network, const std::string& where) {
  for (SurfaceLine& line : network.lines) {
    if (!line.path.empty()) continue;
    if (Status s = find_path(surface, network, line, where); !s) return s;
  }
  return {};
}

Status merge_short_lines(const Surface& surface, SurfaceNetwork& network, const NetworkOptions& options,
                         const std::string& where) {
  if (!(options.shortest >= 0 && options.shortest < 1)) {
    return Error{ErrorCode::kRange, where + "/shortest",
                 "the shortest line has to be 0 or more and below 1 mean length", "0.25 is usual, 0 merges nothing"};
  }
  return Merger(surface, network, options, where).run();
}

Status check_network(const Surface& surface, const SurfaceNetwork& network, const std::string& where) {
  if (network.lines.empty())
    return Error{ErrorCode::kGeometry, where, "the network has no lines", "ask for more cells"};
  std::vector<int> part(network.joints.size());
  std::iota(part.begin(), part.end(), 0);
  const auto root = [&](int j) {
    while (part[at(j)] != j) j = part[at(j)] = part[at(part[at(j)])];
    return j;
  };
  for (const SurfaceLine& line : network.lines) {
    if (line.joint[0] == line.joint[1] || !(path_length(surface, line.path) > 0)) {
      return Error{
          ErrorCode::kGeometry, where,
          "a line begins and ends at " + in_millimetres(position(surface, network.joints[at(line.joint[0])].place)),
          "ask for more cells there"};
    }
    part[at(root(line.joint[0]))] = root(line.joint[1]);
  }
  for (int j = 1; j < static_cast<int>(part.size()); ++j) {
    if (root(j) == root(0)) continue;
    return Error{ErrorCode::kGeometry, where,
                 fmt::format("no lines connect the joints at {} and at {}",
                             in_millimetres(position(surface, network.joints[0].place)),
                             in_millimetres(position(surface, network.joints[at(j)].place))),
                 "ask for more cells, or draw the lines that are missing"};
  }
  return {};
}

}  // namespace lissom
