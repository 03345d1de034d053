#pragma once
/// The handlers that requests.cpp lists; nobody else includes this.

#include "lissom/studio/requests.h"

namespace lissom {

Answer answer_hello(Desk& desk, int page, Ask& ask);
Answer answer_probe(Desk& desk, int page, Ask& ask);

// requests_edit.cpp
Answer answer_edit(Desk& desk, int page, Ask& ask);
Answer answer_drag(Desk& desk, int page, Ask& ask);
Answer answer_drag_end(Desk& desk, int page, Ask& ask);
Answer answer_drag_cancel(Desk& desk, int page, Ask& ask);
Answer answer_undo(Desk& desk, int page, Ask& ask);
Answer answer_redo(Desk& desk, int page, Ask& ask);
Answer answer_go_to(Desk& desk, int page, Ask& ask);
Answer answer_remedy(Desk& desk, int page, Ask& ask);

// requests_project.cpp
Answer answer_new(Desk& desk, int page, Ask& ask);
Answer answer_open(Desk& desk, int page, Ask& ask);
Answer answer_files(Desk& desk, int page, Ask& ask);
Answer answer_save(Desk& desk, int page, Ask& ask);
Answer answer_recover(Desk& desk, int page, Ask& ask);

// requests_shape.cpp
Answer answer_settle(Desk& desk, int page, Ask& ask);
Answer answer_look(Desk& desk, int page, Ask& ask);
Answer answer_hold(Desk& desk, int page, Ask& ask);
Answer answer_run(Desk& desk, int page, Ask& ask);
Answer answer_fields(Desk& desk, int page, Ask& ask);
Answer answer_branches(Desk& desk, int page, Ask& ask);
Answer answer_branch_take(Desk& desk, int page, Ask& ask);
Answer answer_cancel(Desk& desk, int page, Ask& ask);

// requests_tools.cpp
Answer answer_modes(Desk& desk, int page, Ask& ask);
Answer answer_mode_adopt(Desk& desk, int page, Ask& ask);
Answer answer_handle_begin(Desk& desk, int page, Ask& ask);
Answer answer_handle_move(Desk& desk, int page, Ask& ask);
Answer answer_handle_radius(Desk& desk, int page, Ask& ask);
Answer answer_handle_accept(Desk& desk, int page, Ask& ask);
Answer answer_handle_cancel(Desk& desk, int page, Ask& ask);

// requests_export.cpp
Answer answer_export(Desk& desk, int page, Ask& ask);
Answer answer_picture(Desk& desk, int page, Ask& ask);

}  // namespace lissom
