#include "lissom/session/design_tables.h"

#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <nlohmann/json.hpp>

#include "lissom/session/layout_json.h"

namespace lissom {

namespace {

using Json = nlohmann::ordered_json;
using Table = DesignReport::Table;

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

std::string in_mm(double metres) { return std::isfinite(metres) ? fmt::format("{:.3g} mm", 1e3 * metres) : "none"; }

Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Table pose_table(const DesignedProject& done) {
  Table table{"Poses, by the distance of all nodes from their targets (RMS)",
              {"<Pose", "<Part in the design", "Way to the target", "Farthest way", "Missed before", "By radii alone",
               "Missed after"},
              {}};
  const auto add = [&](const std::string& name, const char* part, const std::string& moved, const std::string& farthest,
                       double before, double radii, double after) {
    table.rows.push_back({name, part, moved, farthest, in_mm(before), in_mm(radii), in_mm(after)});
  };
  for (const PoseOutcome& pose : done.poses) {
    add(pose.name, pose.held_back ? "held back as a test" : "designed for", in_mm(pose.moved), in_mm(pose.farthest),
        pose.before, pose.held_back ? kUnknown : pose.radii_only, pose.after);
  }
  add("all that were designed for", "", "", "", done.rms_before(false), done.rms_radii_only(), done.rms_after(false));
  return table;
}

}  // namespace

std::vector<Table> project_tables(const DesignedProject& done) {
  std::vector<Table> tables;
  tables.push_back({"The mesh of rods",
                    {"Rods", "Joints", "Nodes", "Edges"},
                    {{std::to_string(done.rods), std::to_string(done.joints), std::to_string(done.nodes),
                      std::to_string(done.edges)}}});
  if (!done.poses.empty()) tables.push_back(pose_table(done));
  if (!done.notes.empty()) {
    Table notes{"Remarks", {"<What was done on the way"}, {}};
    for (const std::string& note : done.notes) notes.rows.push_back({note});
    tables.push_back(std::move(notes));
  }
  return tables;
}

std::vector<Table> print_tables(const PrintOutcome& print) {
  Table objects{"What is printed", {"<Material", "Volume", "Mass", "Cost", "Parts", "Triangles"}, {}};
  for (const PrintedObject& o : print.objects) {
    objects.rows.push_back({o.material, fmt::format("{:.2f} cm\u00b3", 1e6 * o.volume),
                            fmt::format("{:.1f} g", 1e3 * o.mass), fmt::format("{:.2f} euro", o.cost),
                            std::to_string(o.parts), std::to_string(o.triangles)});
  }
  std::vector<Table> tables{std::move(objects)};
  if (!print.strains.empty()) {
    Table strains{"Largest strain in each pose", {"<Pose", "Strain", "Allowed", "<Where"}, {}};
    for (const PoseStrain& s : print.strains) {
      strains.rows.push_back({s.pose, fmt::format("{:.2f} %", 100 * s.strain),
                              std::isfinite(s.limit) ? fmt::format("{:.1f} %", 100 * s.limit) : "unknown", s.place});
    }
    tables.push_back(std::move(strains));
  }
  Table findings{"What speaks against printing it", {"<Weight", "<What", "<Where", "<What to do"}, {}};
  for (const PrintFinding& f : print.findings) {
    const bool error = f.weight == PrintFinding::Weight::kError;
    findings.rows.push_back({error ? "error" : "warning", f.what, f.where, f.remedy});
  }
  if (findings.rows.empty()) findings.rows.push_back({"none", "all checks are clean", "", ""});
  tables.push_back(std::move(findings));
  return tables;
}

std::string summary_of(const std::string& name, const DesignedProject& done) {
  Json json;
  json["project"] = name;
  json["verdict"] = design_verdict_info(done.design.verdict).name;
  json["message"] = done.design.message;
  json["iterations"] = done.design.iterations;
  json["rods"] = done.rods;
  json["joints"] = done.joints;
  json["nodes"] = done.nodes;
  json["edges"] = done.edges;
  json["rms_before"] = finite(done.rms_before(false));
  json["rms_radii_only"] = finite(done.rms_radii_only());
  json["rms_after"] = finite(done.rms_after(false));
  json["seconds"] = done.design.stages.empty() ? 0 : done.design.stages.back().seconds;
  json["poses"] = Json::array();
  for (const PoseOutcome& pose : done.poses) {
    json["poses"].push_back({{"name", pose.name},
                             {"held_back", pose.held_back},
                             {"moved", pose.moved},
                             {"farthest", pose.farthest},
                             {"rms_before", finite(pose.before)},
                             {"rms_radii_only", finite(pose.held_back ? kUnknown : pose.radii_only)},
                             {"rms_after", finite(pose.after)}});
  }
  if (done.print) {
    json["print"] = {{"file", done.print->file.string()}, {"errors", done.print->errors}};
    double volume = 0;
    for (const PrintedObject& o : done.print->objects) volume += o.volume;
    json["print"]["volume"] = volume;
  }
  json["notes"] = done.notes;
  json["files"] = file_list(done.files);
  return json_line(json);
}

}  // namespace lissom
