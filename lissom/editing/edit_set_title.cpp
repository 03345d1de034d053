#include <fmt/format.h>

#include "lissom/editing/edit_list.h"
#include "lissom/editing/plan_tools.h"

namespace lissom {

namespace {

constexpr EditField kFields[] = {
    {"title", "text", "", false, "What the document is called; may be empty."},
};

Result<EditOutcome> apply(const Model& model, EditReader& edit) {
  EditOutcome out{model};
  out.model.title = edit.text("title");
  if (edit.failed()) return edit.error();
  out.title = out.model.title.empty() ? "Take the title away" : fmt::format("Call it \"{}\"", out.model.title);
  return out;
}

}  // namespace

constinit const EditInfo kEditSetTitle = {"set_title", "Gives the document a title.", kFields, apply};

}  // namespace lissom
