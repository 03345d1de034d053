#pragma once
/// The studio without its server: one thread on which a design is edited, one on which long jobs run, any number of pages.

#include <chrono>
#include <memory>
#include <span>
#include <string>
#include <thread>

#include "lissom/core/result.h"
#include "lissom/editing/project_store.h"
#include "lissom/studio/door.h"

namespace lissom {

struct StudioOptions {
  std::filesystem::path folder;         ///< that it works in; has to exist
  std::string file;                     ///< below the folder, opened first; empty: none
  std::string design;                   ///< that comes with lissom, opened where there is no file; empty: none
  std::span<const DesignText> designs;  ///< that come with lissom; have to outlive the studio
  std::filesystem::path
      state_folder;  ///< for what is remembered about the user: the list of recent files; empty: nowhere
  int threads = 2;   ///< of the engine; as many are used by jobs
  /// Of a search for a shape, before it gives way to requests for another one.
  std::chrono::milliseconds own_time{1000};
};

class Studio final : public StudioDoor {
 public:
  /// Errors: no such folder, or a file that cannot be opened.
  static Result<std::unique_ptr<Studio>> make(const StudioOptions& options);
  /// Ends jobs and solves, keeps what is not saved.
  ~Studio() override;

  int connect(Send send) override;
  void receive(int page, std::string text) override;
  void disconnect(int page) override;

 private:
  struct Parts;
  explicit Studio(std::unique_ptr<Parts> parts);

  std::unique_ptr<Parts> parts_;
};

}  // namespace lissom
