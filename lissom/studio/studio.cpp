#include "lissom/studio/studio.h"

#include <chrono>
#include <utility>
#include <variant>
#include <vector>

#include "lissom/editing/edits_json.h"
#include "lissom/studio/desk.h"
#include "lissom/studio/event_json.h"
#include "lissom/studio/requests.h"

namespace lissom {

namespace {

using Json = nlohmann::json;

constexpr std::chrono::milliseconds kPatience{500};
constexpr auto kBetweenIdle = std::chrono::seconds(1);

Json refusal(const Json& id, const Error& error) { return {{"id", id}, {"ok", false}, {"error", error_json(error)}}; }

Json id_of(const Json& body) {
  return body.contains("id") && body["id"].is_number_integer() ? body["id"] : Json(nullptr);
}

}  // namespace

struct Studio::Parts {
  Parts(ProjectStore store, int count, std::chrono::milliseconds own_time)
      : threads(count), jobs(pages, inbox, count), desk(std::move(store), pages, inbox, jobs, &threads, own_time) {}

  void run();

  Pages pages;
  Inbox inbox;
  ThreadPool threads;
  Jobs jobs;
  Desk desk;
  std::thread engine;
};

void Studio::Parts::run() {
  auto last_idle = std::chrono::steady_clock::now();
  while (!inbox.closed()) {
    const std::optional<Inbox::Item> item = inbox.next(kPatience);
    if (item && std::holds_alternative<Asked>(*item)) {
      const Asked& asked = std::get<Asked>(*item);
      pages.tell(asked.page, answer_request(desk, asked.page, asked.body));
    } else if (item) {
      std::get<Inbox::Task> (*item)();
    }
    const auto now = std::chrono::steady_clock::now();
    if (item && now - last_idle < kBetweenIdle) continue;
    last_idle = now;
    desk.idle();
  }
}

Studio::Studio(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {
  parts_->engine = std::thread([p = parts_.get()] { p->run(); });
}

Result<std::unique_ptr<Studio>> Studio::make(const StudioOptions& options) {
  ProjectStoreOptions store_options;
  store_options.state_folder = options.state_folder;
  Result<ProjectStore> store = ProjectStore::make(options.folder, options.designs, store_options);
  if (!store) return store.error();
  auto parts = std::make_unique<Parts>(std::move(store).value(), options.threads, options.own_time);
  if (!options.file.empty() || !options.design.empty()) {
    ProjectStore& own = parts->desk.store();
    Result<OpenProject> project = options.file.empty() ? own.open_design(options.design) : own.open(options.file);
    if (!project) return project.error();
    // Released on the engine's thread, so that a page that comes at once sees it pop up.
    const auto shared = std::make_shared<OpenProject>(std::move(project).value());
    parts->inbox.hand_over([desk = &parts->desk, shared] { desk->take_over(std::move(*shared)); });
  }
  return std::unique_ptr<Studio>(new Studio(std::move(parts)));
}

Studio::~Studio() {
  parts_->desk.shape().stop();
  parts_->inbox.close();
  parts_->engine.join();
  parts_->jobs.close();  // it works on the desk
  parts_->desk.close();
}

int Studio::connect(Send send) { return parts_->pages.connect(std::move(send)); }

void Studio::disconnect(int page) {
  parts_->pages.disconnect(page);
  parts_->inbox.hand_over([desk = &parts_->desk, page] { desk->page_gone(page); });
}

void Studio::receive(int page, std::string text) {
  Result<Json> body = read_json(text);
  if (!body) return parts_->pages.tell(page, refusal(nullptr, body.error()));
  if (!body.value().is_object()) {
    const Error error{ErrorCode::kType, {}, "a request is an object", "see docs/studio/protocol.md"};
    return parts_->pages.tell(page, refusal(nullptr, error));
  }
  // A solve cannot be asked to stop from where it would have to wait for it.
  if (body.value().value("do", Json()) == "cancel" && body.value().value("job", Json()) == "settle") {
    parts_->desk.shape().stop();
  }
  const Json id = id_of(body.value());
  std::vector<Asked> skipped;
  const Inbox::Taken taken = parts_->inbox.ask({page, std::move(body).value(), text.size()}, skipped);
  for (const Asked& old : skipped) parts_->pages.tell(page, {{"id", id_of(old.body)}, {"ok", true}, {"skipped", true}});
  if (taken == Inbox::Taken::kFull) {
    const Error error{
        ErrorCode::kConflict, {}, "too much is waiting to be done", "wait for answers before asking more"};
    parts_->pages.tell(page, refusal(id, error));
  }
}

}  // namespace lissom
