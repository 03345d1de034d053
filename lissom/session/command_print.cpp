#include "lissom/session/command_print.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <utility>

#include "lissom/core/nearest_name.h"
#include "lissom/fabrication/exporters.h"
#include "lissom/session/output.h"

namespace lissom {

namespace {

using Json = nlohmann::ordered_json;

Result<PrintProcess> process_of(const PrintCommand& command) {
  const PrintProcess* known = find_process(command.process);
  if (known == nullptr) {
    std::vector<std::string> names;
    for (const PrintProcess& process : print_processes()) names.emplace_back(process.name);
    return Error{ErrorCode::kUnknown, "--process", "there is no process \"" + command.process + "\"",
                 suggestion(command.process, names)};
  }
  PrintProcess process = *known;
  process.diameter = command.diameter.value_or(process.diameter);
  process.gap = command.gap.value_or(process.gap);
  process.bed = command.bed.value_or(process.bed);
  process.cost = command.cost.value_or(process.cost);
  if (!(process.cost >= 0) || !std::isfinite(process.cost)) {
    return Error{ErrorCode::kRange, "--cost", fmt::format("{:g} euro per kg is no cost", process.cost),
                 "give zero or a positive number"};
  }
  return process;
}

/// Rods whose natural shape is not the drawn one: what is printed is the drawn one.
std::vector<PrintFinding> sprung_rods(const Structure& structure) {
  constexpr double kFelt = 1e-3;  // rad of a bend, or strain of an edge
  std::vector<bool> sprung(structure.rods.size(), false);
  for (const StructurePair& pair : structure.pairs) {
    const PairStrain drawn = pair_strain(structure.edges[pair.edge0].drawn, structure.edges[pair.edge1].drawn);
    const double off = std::max({std::abs(drawn.kappa_1 - pair.rest_kappa_1),
                                 std::abs(drawn.kappa_2 - pair.rest_kappa_2), std::abs(drawn.twist - pair.rest_twist)});
    if (off > kFelt) sprung[structure.edges[pair.edge0].rod] = true;
  }
  for (const StructureEdge& edge : structure.edges) {
    const double drawn = (structure.nodes[edge.node1] - structure.nodes[edge.node0]).norm();
    if (std::abs(edge.rest_length / drawn - 1) > kFelt) sprung[edge.rod] = true;
  }
  const auto first = std::find(sprung.begin(), sprung.end(), true);
  if (first == sprung.end()) return {};
  const auto count = std::count(sprung.begin(), sprung.end(), true);
  const StructureRod& rod = structure.rods[first - sprung.begin()];
  return {{PrintFinding::Weight::kWarning, "sprung rods", print_place(rod.name, structure.nodes[rod.nodes[0]]),
           static_cast<double>(count),
           fmt::format(
               "{} rods have a natural shape other than the drawn one, which is printed: draw them as they are to be "
               "without forces",
               count)}};
}

PrintObjects objects_of(const Document& document, std::vector<RodSolid> solids) {
  const Vec3 low = solid_box(solids).low;
  PrintObjects objects{document.model.title.empty() ? document.name : document.model.title, {}};
  for (RodSolid& solid : solids) {
    for (Vec3& x : solid.surface.vertices) x -= low;
    objects.objects.push_back({std::move(solid.material), std::move(solid.surface)});
  }
  return objects;
}

PrintedObject printed(const Model& model, const RodSolid& solid, const PrintProcess& process) {
  const Material* material = model.material(solid.material);
  LISSOM_ASSERT(material != nullptr);
  PrintedObject object{
      solid.material, solid.volume,  0, 0, static_cast<int>(solid.surface.triangles.size()), solid.parts, solid.tubes,
      solid.joints,   solid.cavities};
  object.mass = material->density * solid.volume;
  object.cost = process.cost * object.mass;
  return object;
}

Json finding_json(const PrintFinding& f) {
  return {{"weight", f.weight == PrintFinding::Weight::kError ? "error" : "warning"},
          {"what", f.what},
          {"where", f.where},
          {"value", f.value},
          {"remedy", f.remedy}};
}

std::string summary(const PrintOutcome& outcome, const PrintProcess& process) {
  Json json;
  json["file"] = outcome.file.empty() ? Json() : Json(outcome.file.string());
  json["process"] = process.name;
  json["size"] = {outcome.size.x(), outcome.size.y(), outcome.size.z()};
  json["tolerance"] = outcome.tolerance;
  json["objects"] = Json::array();
  for (const PrintedObject& o : outcome.objects) {
    json["objects"].push_back({{"material", o.material},
                               {"volume", o.volume},
                               {"mass", o.mass},
                               {"cost", o.cost},
                               {"triangles", o.triangles},
                               {"parts", o.parts},
                               {"tubes", o.tubes},
                               {"joints", o.joints},
                               {"cavities", o.cavities}});
  }
  json["strains"] = Json::array();
  for (const PoseStrain& s : outcome.strains) {
    json["strains"].push_back({{"pose", s.pose},
                               {"where", s.place},
                               {"strain", s.strain},
                               {"limit", std::isfinite(s.limit) ? Json(s.limit) : Json()}});
  }
  json["errors"] = outcome.errors;
  json["findings"] = Json::array();
  for (const PrintFinding& f : outcome.findings) json["findings"].push_back(finding_json(f));
  return json.dump();
}

void add_findings(std::vector<PrintFinding> findings, PrintOutcome& outcome) {
  for (PrintFinding& finding : findings) {
    if (finding.weight == PrintFinding::Weight::kError) ++outcome.errors;
    outcome.findings.push_back(std::move(finding));
  }
}

}  // namespace

Result<PrintOutcome> print_command(const Document& document, const PrintCommand& command, const Context& context) {
  const Result<const Exporter*> exporter = exporter_for(command.file.string());
  if (!exporter) return exporter.error();
  const Result<PrintProcess> process = process_of(command);
  if (!process) return process.error();
  if (const Status s = command.solve.validate(); !s) return s.error();
  Output output(command.file.parent_path());
  if (const Status s = output.prepare(); !s) return s.error();
  const Result<Structure> structure = discretize(document.model);
  if (!structure) return structure.error();
  Result<std::vector<RodSolid>> solids = rod_solids(structure.value(), command.solid, context);
  if (!solids) return solids.error();

  PrintOutcome outcome;
  for (const RodSolid& solid : solids.value()) {
    outcome.objects.push_back(printed(document.model, solid, process.value()));
    outcome.tolerance = std::max(outcome.tolerance, solid.tolerance);
  }
  const SolidBox box = solid_box(solids.value());
  outcome.size = box.high - box.low;
  add_findings(print_checks(structure.value(), solids.value(), process.value(), command.solid.tolerance), outcome);
  add_findings(sprung_rods(structure.value()), outcome);
  if (command.poses == PrintCommand::Poses::kSolve) {
    StrainChecks strains = check_strains(document.model, command.solve, context);
    outcome.strains = std::move(strains.poses);
    add_findings(std::move(strains.findings), outcome);
  }
  if (outcome.errors == 0 || command.on_errors == PrintCommand::OnErrors::kWrite) {
    Result<std::string> bytes = exporter.value()->bytes(objects_of(document, std::move(solids).value()));
    if (!bytes) {
      Error error = bytes.error();
      error.where = command.file.string();
      return error;
    }
    if (const Status s = output.write(command.file.filename(), bytes.value()); !s) return s.error();
    outcome.file = command.file;
  }
  outcome.summary = summary(outcome, process.value());
  return outcome;
}

}  // namespace lissom
