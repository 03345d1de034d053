// lissom studio [FILE]

#include "apps/cli/command.h"
#include "apps/cli/terminal.h"

#if defined(LISSOM_STUDIO)

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <poll.h>
#include <sys/resource.h>
#include <thread>
#include <unistd.h>
#include <utility>

#include "apps/cli/browser.h"
#include "apps/studio/server/kept_session.h"
#include "apps/studio/server/studio_server.h"
#include "lissom/core/spare_memory.h"
#include "lissom/studio/studio.h"
#include "scenes/design_texts.h"

namespace lissom::cli {

namespace {

namespace fs = std::filesystem;

/// Where the studio is while nothing else is there: settings of the page belong to an address with its port.
constexpr unsigned short kFirstPort = 17766, kLastPort = 17775;
constexpr const char* kFirstDesign = "butterfly";
constexpr int kWaitMilliseconds = 100;
constexpr int kPatience = 5;  // nice value of the engine

struct Arguments {
  std::string file, folder;
  int port = -1;  ///< negative: kFirstPort, or one of the next
  int threads = 0;
  bool no_browser = false;
};

bool is_design(const std::string& name) {
  const std::span<const DesignText> all = design_texts();
  return std::any_of(all.begin(), all.end(), [&](const DesignText& design) { return design.name == name; });
}

/// What is opened, and where: a file, a design by its name, or the first design.
Result<StudioOptions> studio_options(const Arguments& arguments) {
  StudioOptions options;
  options.designs = design_texts();
  options.state_folder = state_folder();
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  options.threads = arguments.threads > 0 ? arguments.threads : cores;
  std::error_code error;
  const fs::path file = arguments.file;
  if (file.empty()) {
    options.design = kFirstDesign;
  } else if (!fs::exists(file, error) && is_design(arguments.file)) {
    options.design = arguments.file;
  }
  const bool opens_file = options.design.empty();
  const fs::path given = !arguments.folder.empty() ? fs::path(arguments.folder)
                         : opens_file              ? fs::absolute(file, error).parent_path()
                                                   : fs::path(".");
  options.folder = fs::canonical(given, error);
  if (error) {
    return Error{ErrorCode::kFile, "--folder", "\"" + given.string() + "\" is no folder", "make it first"};
  }
  if (!opens_file) return options;
  const fs::path below = fs::weakly_canonical(fs::absolute(file, error), error).lexically_relative(options.folder);
  if (below.empty() || *below.begin() == "..") {
    return Error{ErrorCode::kFile, arguments.file, "it is not in the folder \"" + options.folder.string() + "\"",
                 "leave out --folder, or give one that holds the file"};
  }
  options.file = below.generic_string();
  return options;
}

/// A studio that lets the browser go first where there are no cores to spare: what the pointer moves has to follow it, and a
/// picture that nobody gets to see is no use. Threads are as patient as the one that starts them, and this one starts the browser.
Result<std::unique_ptr<Studio>> patient_studio(const StudioOptions& options) {
  std::optional<Result<std::unique_ptr<Studio>>> studio;
  std::thread([&] {
    ::setpriority(PRIO_PROCESS, 0, kPatience);  // of the calling thread
    studio.emplace(Studio::make(options));
  }).join();
  return std::move(*studio);
}

/// A server at the port that was asked for, or at the first of ours that is free, or at any.
Result<std::unique_ptr<StudioServer>> start_server(StudioDoor& door, const Arguments& arguments) {
  StudioServerOptions options;
  options.log = [](const std::string& line) { std::fprintf(stderr, "lissom studio: %s\n", line.c_str()); };
  const auto at = [&](int port) {
    options.port = static_cast<unsigned short>(port);
    // A port that is chosen by chance does not come again, so nothing is kept for it.
    options.session = nullptr;
    if (port > 0) options.session = [](unsigned short taken) { return kept_session(session_folder(), taken); };
    return StudioServer::start(door, built_in_page(), options);
  };
  if (arguments.port >= 0) return at(arguments.port);
  for (int port = kFirstPort; port <= kLastPort; ++port) {
    Result<std::unique_ptr<StudioServer>> server = at(port);
    if (server) return server;
  }
  return at(0);
}

void print_address(StudioServer& server) {
  print("Studio: " + server.new_address() + "\n");
  std::fflush(stdout);
}

/// Until somebody ends it. Enter prints another address: each lets one browser in.
void serve(StudioServer& server) {
  bool listens = isatty(STDIN_FILENO) != 0 && isatty(STDOUT_FILENO) != 0;
  if (listens) print("  Enter: another address, for another browser. Ctrl-C: end.\n");
  std::fflush(stdout);
  while (!interrupted()) {
    // In the background of a shell, reading would stop the program.
    const bool in_front = listens && ::tcgetpgrp(STDIN_FILENO) == ::getpgrp();
    pollfd input{STDIN_FILENO, POLLIN, 0};
    if (::poll(&input, in_front ? 1 : 0, kWaitMilliseconds) <= 0) continue;
    char typed[256];
    listens = ::read(STDIN_FILENO, typed, sizeof typed) > 0;
    if (listens) print_address(server);
  }
}

int run_studio(const Arguments& arguments) {
  keep_large_blocks_apart();
  Result<StudioOptions> options = studio_options(arguments);
  if (!options) return report(options.error());
  catch_interrupts();
  Result<std::unique_ptr<Studio>> studio = patient_studio(options.value());
  if (!studio) return report(studio.error(), arguments.file);
  Result<std::unique_ptr<StudioServer>> server = start_server(*studio.value(), arguments);
  if (!server) return report(server.error());
  const unsigned short port = server.value()->port();
  print_address(*server.value());
  if (!arguments.no_browser && somebody_looks()) open_in_browser(server.value()->new_address());
  serve(*server.value());
  server.value()->stop();
  forget_session(session_folder(), port);
  return kDone;
}

}  // namespace

void add_studio(CLI::App& app, Runner& chosen) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("studio", "Design rods on stretched fabric in the browser");
  command->add_option("file", arguments->file,
                      std::string("A .lissom document, or a design that comes with lissom [") + kFirstDesign + "]");
  command->add_option("--folder", arguments->folder,
                      "Where files are opened and saved [that of the file, or this one]");
  command->add_option("--port", arguments->port, "Port on 127.0.0.1; 0: any that is free [17766, or one of the next]")
      ->check(CLI::Range(0, 65535));
  command->add_option("--threads", arguments->threads, "Threads to compute with [one per core]")
      ->check(CLI::Range(1, 1024));
  command->add_flag("--no-browser", arguments->no_browser, "Print the address, do not open it");
  command->footer(
      "Prints an address that lets one browser of this machine in; Enter prints another. Ctrl-C ends; what was not "
      "saved is "
      "offered next time.\n\nExample:\n  lissom studio butterfly.lissom");
  command->callback([arguments, &chosen] { chosen = [arguments] { return run_studio(*arguments); }; });
}

}  // namespace lissom::cli

#else

namespace lissom::cli {

void add_studio(CLI::App& app, Runner& chosen) {
  CLI::App* command = app.add_subcommand("studio", "Design in the browser (not in this build)");
  command->allow_extras();
  command->callback([&chosen] {
    chosen = [] {
      report({ErrorCode::kUnsupported,
              {},
              "this lissom was built without the studio",
              "configure it with -DLISSOM_STUDIO=ON"});
      return kFailed;
    };
  });
}

}  // namespace lissom::cli

#endif
