#include "lissom/editing/plan_json.h"
#include "lissom/studio/desk.h"
#include "lissom/studio/request_handlers.h"

namespace lissom {

using Json = nlohmann::json;

Answer answer_new(Desk& desk, int page, Ask& ask) {
  (void)page;
  const std::string name = ask.text("template");
  if (!ask.status()) return ask.status().error();
  Result<OpenProject> project = desk.store().open_template(name);
  if (!project) return project.error();
  desk.take_over(std::move(project).value());
  return Json::object();
}

Answer answer_open(Desk& desk, int page, Ask& ask) {
  (void)page;
  const std::optional<std::string> file = ask.optional_text("file"), design = ask.optional_text("design");
  if (!ask.status()) return ask.status().error();
  if (file.has_value() == design.has_value()) {
    return Error{ErrorCode::kType, {}, "say either which file or which design", "give \"file\" or \"design\""};
  }
  Result<OpenProject> project = file ? desk.store().open(*file) : desk.store().open_design(*design);
  if (!project) return project.error();
  desk.take_over(std::move(project).value());
  return Json::object();
}

Answer answer_files(Desk& desk, int page, Ask& ask) {
  (void)page, (void)ask;
  Json files = Json::array(), designs = Json::array();
  for (const ListedFile& file : desk.store().files()) {
    files.push_back({{"name", file.name}, {"kind", file.kind}, {"bytes", file.bytes}, {"modified", file.modified}});
  }
  for (const ListedDesign& design : desk.store().designs()) {
    Result<OpenProject> project = desk.store().open_design(design.name);
    designs.push_back({{"name", design.name},
                       {"title", design.title},
                       {"points", design.points},
                       {"lines_mm", project ? plan_lines_json(*project.value().history.model()) : Json::array()}});
  }
  return Json{{"files", files}, {"recent", desk.store().recent()}, {"designs", designs}};
}

Answer answer_save(Desk& desk, int page, Ask& ask) {
  (void)page;
  const std::string file = ask.optional_text("file").value_or("");
  const bool replace = ask.has("replace") && ask.flag("replace");
  if (!ask.status()) return ask.status().error();
  const auto how = replace ? ProjectStore::Replace::kAny : ProjectStore::Replace::kOwn;
  if (Status s = desk.save(file, how); !s) return s.error();
  return Json{{"file", desk.project().file}};
}

Answer answer_recover(Desk& desk, int page, Ask& ask) {
  (void)page;
  const bool take = ask.flag("take");
  if (!ask.status()) return ask.status().error();
  if (Status s = desk.recover(take); !s) return s.error();
  return Json::object();
}

}  // namespace lissom
