#include "lissom/session/state_json.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <span>
#include <vector>

namespace lissom {

namespace {

using Json = nlohmann::ordered_json;

/// Reads lists of numbers and remembers the first mistake.
class NumberLists {
 public:
  NumberLists(const Json& json, std::string where) : json_(json), where_(std::move(where)) {}

  bool failed() const { return failed_; }
  const Error& error() const { return error_; }

  /// The list `key`, a multiple of `width` long; empty after a mistake.
  std::vector<double> list(const char* key, size_t width) {
    std::vector<double> values;
    const auto found = json_.find(key);
    if (failed_) return values;
    if (found == json_.end() || !found->is_array() || found->size() % width != 0) {
      fail(key, "a list of numbers is missing or has the wrong length");
      return values;
    }
    values.reserve(found->size());
    for (const Json& entry : *found) {
      if (!entry.is_number() || !std::isfinite(entry.get<double>())) {
        fail(key, "something in the list is not a finite number");
        return {};
      }
      values.push_back(entry.get<double>());
    }
    return values;
  }

  void fail(const char* key, std::string message) {
    if (failed_) return;
    failed_ = true;
    error_ = {ErrorCode::kType, where_ + "/" + key, std::move(message), "was the file edited or cut off?"};
  }

 private:
  const Json& json_;
  std::string where_;
  bool failed_ = false;
  Error error_;
};

Vec3 vector_at(const std::vector<double>& values, size_t i) {
  return {values[3 * i], values[3 * i + 1], values[3 * i + 2]};
}

template <class Items, class Of>
Json vectors(const Items& items, const Of& of) {
  std::vector<double> values;
  values.reserve(3 * items.size());
  for (const auto& item : items) {
    const Vec3 v = of(item);
    values.insert(values.end(), v.data(), v.data() + 3);
  }
  return values;
}

}  // namespace

Json state_to_json(const State& state) {
  Json json;
  json["load_factor"] = state.load_factor;
  json["unknowns"] = std::span<const double>(state.q.data(), static_cast<size_t>(state.q.size()));
  json["tangents"] = vectors(state.edges, [](const EdgeState& e) { return e.t; });
  json["reference_binormals"] = vectors(state.edges, [](const EdgeState& e) { return e.reference_b; });
  json["material_binormals"] = vectors(state.edges, [](const EdgeState& e) { return e.b; });
  std::vector<double> lengths, rotations;
  for (const EdgeState& e : state.edges) lengths.push_back(e.length);
  json["lengths"] = lengths;
  json["pair_twists"] = state.pair_twist;
  json["connection_twists"] = state.connection_twist;
  for (const Mat3& r : state.joint_rotation) {
    for (int i = 0; i < 9; ++i) rotations.push_back(r(i / 3, i % 3));
  }
  json["joint_rotations"] = rotations;
  json["joint_turns"] = vectors(state.joint_turn, [](const Vec3& v) { return v; });
  return json;
}

Result<State> state_from_json(const Json& json, const std::string& where) {
  if (!json.is_object()) return Error{ErrorCode::kType, where, "the state is not an object", "was the file edited?"};
  NumberLists lists(json, where);
  State state;
  const auto factor = json.find("load_factor");
  if (factor == json.end() || !factor->is_number()) lists.fail("load_factor", "the load factor is missing");
  const std::vector<double> q = lists.list("unknowns", 1), t = lists.list("tangents", 3);
  const std::vector<double> reference = lists.list("reference_binormals", 3), b = lists.list("material_binormals", 3);
  const std::vector<double> lengths = lists.list("lengths", 1);
  state.pair_twist = lists.list("pair_twists", 1);
  state.connection_twist = lists.list("connection_twists", 1);
  const std::vector<double> rotations = lists.list("joint_rotations", 9), turns = lists.list("joint_turns", 3);
  const size_t edges = lengths.size(), joints = rotations.size() / 9;
  if (t.size() != 3 * edges || reference.size() != 3 * edges || b.size() != 3 * edges) {
    lists.fail("tangents", "the lists of edges differ in length");
  }
  if (turns.size() != 3 * joints) lists.fail("joint_turns", "the lists of joints differ in length");
  if (lists.failed()) return lists.error();
  state.load_factor = factor->get<double>();
  state.q = Eigen::Map<const VecX>(q.data(), static_cast<Eigen::Index>(q.size()));
  for (size_t e = 0; e < edges; ++e) {
    state.edges.push_back({vector_at(t, e), vector_at(reference, e), vector_at(b, e), lengths[e]});
  }
  for (size_t j = 0; j < joints; ++j) {
    Mat3 r;
    for (int i = 0; i < 9; ++i) r(i / 3, i % 3) = rotations[9 * j + static_cast<size_t>(i)];
    state.joint_rotation.push_back(r);
    state.joint_turn.push_back(vector_at(turns, j));
  }
  return state;
}

}  // namespace lissom
