#include "lissom/session/optimizer_json.h"

#include <nlohmann/json.hpp>
#include <optional>

#include "lissom/session/numbers_json.h"

namespace lissom {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const OutcomeCounts& counts) { return counts.counts; }
Json json_of(const DesignEffort& e) {
  return {{"attempts", e.attempts},
          {"solves", e.solves},
          {"factorizations", e.factorizations},
          {"back_solves", e.back_solves}};
}

Json json_of(const DesignRecord& r) {
  return {{"iteration", r.iteration},
          {"accepted", r.accepted},
          {"value", r.value},
          {"gradient", r.gradient},
          {"predicted", r.predicted},
          {"step_length", r.step_length},
          {"active_bounds", r.active_bounds},
          {"attempts", json_of(r.attempts)},
          {"cap", r.cap},
          {"damping", r.damping},
          {"hessian_products", r.hessian_products},
          {"effort", json_of(r.effort)},
          {"iterations_left", r.iterations_left}};
}

Json json_of(const std::optional<DesignVerdict>& verdict) {
  return verdict ? std::string(design_verdict_info(*verdict).name) : std::string();
}

Json json_of(const OptimizerState& s) {
  Json json;
  json["x"] = number_list(s.x);
  json["iteration"] = s.iteration;
  json["first_gradient"] = s.first_gradient;
  json["cap"] = s.cap;
  json["damping"] = s.damping;
  json["damping_growth"] = s.damping_growth;
  const MatX& second = s.secant.second;
  json["secant"] = {{"size", second.rows()},
                    {"second", number_list(Eigen::Map<const VecX>(second.data(), second.size()))},
                    {"has_step", s.secant.has_step},
                    {"resets", s.secant.resets}};
  json["has_lesson"] = s.has_lesson;
  json["step"] = number_list(s.step);
  json["gradient_before"] = number_list(s.gradient_before);
  json["pull"] = number_list(s.pull);
  json["rejected"] = json_of(s.rejected);
  json["promise"] = number_list(s.promise);
  json["effort"] = json_of(s.effort);
  json["records"] = Json::array();
  for (const DesignRecord& record : s.records) json["records"].push_back(json_of(record));
  json["verdict"] = json_of(s.verdict);
  json["message"] = s.message;
  return json;
}

/// Reads the parts of a state; the first mistake wins.
class StateReader {
 public:
  explicit StateReader(std::string where) : where_(std::move(where)) {}

  const Status& status() const { return status_; }

  ConstrainedState constrained(const Json& json) {
    JsonNumbers n(json, where_);
    ConstrainedState s;
    s.multipliers = n.vector("multipliers");
    s.penalty = n.number("penalty");
    s.first_violation = n.number("first_violation");
    s.violation = n.number("violation");
    s.round = n.integer("round");
    s.round_began = n.integer("round_began");
    s.stuck = n.integer("stuck");
    s.verdict = verdict(n);
    s.message = n.text("message");
    const Json* inner = n.object("inner");
    take(n);
    if (inner != nullptr) s.inner = optimizer(*inner);
    return s;
  }

  DesignRecord record(const Json& json, const std::string& where) {
    JsonNumbers n(json, where);
    DesignRecord r;
    r.iteration = n.integer("iteration");
    r.accepted = n.flag("accepted");
    r.value = n.number("value");
    r.gradient = n.number("gradient");
    r.predicted = n.number("predicted");
    r.step_length = n.number("step_length");
    r.active_bounds = n.integer("active_bounds");
    r.attempts = counts(n, "attempts");
    r.cap = n.number("cap");
    r.damping = n.number("damping");
    r.hessian_products = n.integer("hessian_products");
    r.effort = effort(n);
    r.iterations_left = n.integer("iterations_left");
    take(n);
    return r;
  }

 private:
  void take(const JsonNumbers& numbers) {
    if (status_ && !numbers.status()) status_ = numbers.status();
  }

  static std::optional<DesignVerdict> verdict(JsonNumbers& n) {
    const std::string name = n.text("verdict");
    if (name.empty()) return {};
    for (const DesignVerdictInfo& info : design_verdicts()) {
      if (info.name == name) return info.verdict;
    }
    n.fail("verdict", "one of the verdicts");
    return {};
  }

  OutcomeCounts counts(JsonNumbers& n, const char* key) {
    OutcomeCounts counts;
    const VecX values = n.vector(key);
    if (n.status() && values.size() != static_cast<Eigen::Index>(counts.counts.size()))
      n.fail(key, "a count per outcome");
    if (!n.status()) return counts;
    for (std::size_t i = 0; i < counts.counts.size(); ++i) {
      counts.counts[i] = static_cast<int>(values[static_cast<Eigen::Index>(i)]);
    }
    return counts;
  }

  DesignEffort effort(JsonNumbers& n) {
    const Json* json = n.object("effort");
    if (json == nullptr) return {};
    JsonNumbers own(*json, where_ + "/effort");
    DesignEffort e{own.integer("attempts"), own.integer("solves"), own.integer("factorizations"),
                   own.integer("back_solves")};
    take(own);
    return e;
  }

  SecantMemory secant(const Json& json) {
    JsonNumbers n(json, where_ + "/secant");
    SecantMemory memory;
    const int size = n.integer("size");
    const VecX values = n.vector("second");
    memory.has_step = n.flag("has_step");
    memory.resets = n.integer("resets");
    if (n.status() && (size < 0 || values.size() != static_cast<Eigen::Index>(size) * size))
      n.fail("second", "a matrix");
    if (n.status()) memory.second = Eigen::Map<const MatX>(values.data(), size, size);
    take(n);
    return memory;
  }

  OptimizerState optimizer(const Json& json) {
    JsonNumbers n(json, where_);
    OptimizerState s;
    s.x = n.vector("x");
    s.iteration = n.integer("iteration");
    s.first_gradient = n.number("first_gradient");
    s.cap = n.number("cap");
    s.damping = n.number("damping");
    s.damping_growth = n.number("damping_growth");
    if (const Json* own = n.object("secant")) s.secant = secant(*own);
    s.has_lesson = n.flag("has_lesson");
    s.step = n.vector("step");
    s.gradient_before = n.vector("gradient_before");
    s.pull = n.vector("pull");
    s.rejected = counts(n, "rejected");
    s.promise = n.vector("promise");
    s.effort = effort(n);
    if (const Json* records = n.list("records")) {
      for (const Json& entry : *records) s.records.push_back(record(entry, where_ + "/records"));
    }
    s.verdict = verdict(n);
    s.message = n.text("message");
    take(n);
    return s;
  }

  std::string where_;
  Status status_;
};

}  // namespace

Json effort_to_json(const DesignEffort& effort) { return json_of(effort); }

Json record_to_json(const DesignRecord& record) { return json_of(record); }

Result<DesignRecord> record_from_json(const Json& json, const std::string& where) {
  StateReader reader(where);
  DesignRecord record = reader.record(json, where);
  if (!reader.status()) return reader.status().error();
  return record;
}

Json descent_to_json(const ConstrainedState& s) {
  Json json;
  json["multipliers"] = number_list(s.multipliers);
  json["penalty"] = s.penalty;
  json["first_violation"] = s.first_violation;
  json["violation"] = s.violation;
  json["round"] = s.round;
  json["round_began"] = s.round_began;
  json["stuck"] = s.stuck;
  json["verdict"] = json_of(s.verdict);
  json["message"] = s.message;
  json["inner"] = json_of(s.inner);
  return json;
}

Result<ConstrainedState> descent_from_json(const Json& json, const std::string& where) {
  StateReader reader(where);
  ConstrainedState state = reader.constrained(json);
  if (!reader.status()) return reader.status().error();
  return state;
}

}  // namespace lissom
