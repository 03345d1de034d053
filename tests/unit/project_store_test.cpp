/// The folder of a studio: documents, histories, what a killed session left.

#include "lissom/editing/project_store.h"

#include <csignal>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "lissom/core/file_io.h"
#include "lissom/model/document.h"
#include "scenes/design_texts.h"

namespace lissom {
namespace {

namespace fs = std::filesystem;

class ProjectStoreTest : public ::testing::Test {
 protected:
  void SetUp() override {
    const std::string test = ::testing::UnitTest::GetInstance()->current_test_info()->name();
    top_ = fs::temp_directory_path() / ("lissom_project_store_" + test + std::to_string(getpid()));
    fs::remove_all(top_);
    folder_ = top_ / "folder";
    fs::create_directories(folder_ / "sub");
    fs::create_directories(top_ / "outside");
  }
  void TearDown() override { fs::remove_all(top_); }

  ProjectStore store(double autosave_every = 0) {
    Result<ProjectStore> made = ProjectStore::make(folder_, design_texts(), {top_ / "state", autosave_every, {}});
    EXPECT_TRUE(made.ok());
    return std::move(made).value();
  }
  static void call(OpenProject& project, const std::string& title) {
    Model model = *project.history.model();
    model.title = title;
    EXPECT_TRUE(project.history.add({"Call it " + title, {}, 0}, std::move(model)));
  }
  std::vector<std::string> names(const fs::path& where) const {
    std::vector<std::string> list;
    for (const auto& entry : fs::directory_iterator(where)) list.push_back(entry.path().filename().string());
    std::sort(list.begin(), list.end());
    return list;
  }
  /// Runs in a process of its own, which is killed when it is done.
  template <class Work>
  static void in_killed_process(const Work& work) {
    const pid_t child = fork();
    if (child == 0) {
      work();
      kill(getpid(), SIGKILL);
    }
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status));
  }

  fs::path top_, folder_;
};

using Names = std::vector<std::string>;

TEST_F(ProjectStoreTest, TheHistorySurvivesSaving) {
  {
    ProjectStore first = store();
    OpenProject project = first.open_template("disc").value();
    EXPECT_EQ(project.name, "disc");
    EXPECT_FALSE(first.save(project)) << "it has no name yet";
    call(project, "one");
    call(project, "two");
    ASSERT_TRUE(first.save(project, "wing"));
    EXPECT_EQ(project.file, "wing.lissom");
    EXPECT_EQ(project.name, "wing");
    EXPECT_TRUE(project.history.saved());
    EXPECT_EQ(names(folder_), (Names{"sub", "wing.history.json", "wing.lissom"}));
  }
  ProjectStore second = store();
  Result<OpenProject> project = second.open("wing.lissom");
  ASSERT_TRUE(project) << project.error().text();
  EXPECT_TRUE(project.value().notes.empty());
  EXPECT_EQ(project.value().history.at(), 2);
  EXPECT_TRUE(project.value().history.saved());
  ASSERT_TRUE(project.value().history.undo());
  EXPECT_EQ(project.value().history.model()->title, "one");
  ASSERT_TRUE(project.value().history.go_to(0));
  EXPECT_EQ(project.value().history.model()->title, "Disc");
  EXPECT_EQ(second.recent(), (Names{"wing.lissom"}));
}

TEST_F(ProjectStoreTest, WhatAnotherProgramHasChangedIsAStepMore) {
  ProjectStore here = store();
  OpenProject project = here.open_design("butterfly").value();
  call(project, "one");
  ASSERT_TRUE(here.save(project, "wing.lissom"));
  Model other = *project.history.model();
  other.title = "another program's";
  ASSERT_TRUE(write_file(folder_ / "wing.lissom", write_document(other)));
  Result<OpenProject> again = here.open("wing.lissom");
  ASSERT_TRUE(again);
  EXPECT_EQ(again.value().notes.size(), 1U);
  EXPECT_EQ(again.value().history.step(2).title, "Changed elsewhere");
  EXPECT_EQ(again.value().history.model()->title, "another program's");
  ASSERT_TRUE(again.value().history.undo());
  EXPECT_EQ(again.value().history.model()->title, "one");

  call(project, "two");
  const Status refused = here.save(project);
  ASSERT_FALSE(refused) << "the file is not what it was when this project was opened";
  EXPECT_EQ(refused.error().code, ErrorCode::kConflict);
  ASSERT_TRUE(here.save(project, {}, ProjectStore::Replace::kAny));
  EXPECT_EQ(read_document(read_file(folder_ / "wing.elsewhere.lissom").value()).value().title, "another program's");
  EXPECT_EQ(here.open("wing.lissom").value().history.model()->title, "two");
}

TEST_F(ProjectStoreTest, OtherFilesAreNotReplacedUnasked) {
  ProjectStore here = store();
  OpenProject a = here.open_template("disc").value(), b = here.open_template("square").value();
  ASSERT_TRUE(here.save(a, "a"));
  const Status refused = here.save(b, "a.lissom");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::kConflict);
  EXPECT_EQ(b.file, "");
  ASSERT_TRUE(here.save(b, "sub/new/b"));
  EXPECT_TRUE(fs::exists(folder_ / "sub/new/b.lissom"));
  EXPECT_FALSE(here.save(b, "b.txt"));
  EXPECT_FALSE(here.save(b, ".hidden.lissom"));
}

TEST_F(ProjectStoreTest, AHistoryThatCannotBeReadIsKept) {
  ProjectStore here = store();
  OpenProject project = here.open_template("disc").value();
  call(project, "one");
  ASSERT_TRUE(here.save(project, "a"));
  ASSERT_TRUE(write_file(folder_ / "a.history.json", "{\"lissom_history\": 1, \"fir"));
  Result<OpenProject> again = here.open("a.lissom");
  ASSERT_TRUE(again);
  EXPECT_EQ(again.value().history.size(), 0);
  EXPECT_EQ(again.value().notes.size(), 1U);
  ASSERT_TRUE(here.save(again.value()));
  EXPECT_EQ(read_file(folder_ / "a.history.before.json").value(), "{\"lissom_history\": 1, \"fir");
}

TEST_F(ProjectStoreTest, KilledBetweenHistoryAndDocumentNothingIsLost) {
  ProjectStore here = store();
  OpenProject project = here.open_template("disc").value();
  call(project, "one");
  ASSERT_TRUE(here.save(project, "a"));
  const std::string old = read_file(folder_ / "a.lissom").value();
  call(project, "two");
  ASSERT_TRUE(here.save(project));
  ASSERT_TRUE(write_file(folder_ / "a.lissom", old));
  const OpenProject again = here.open("a.lissom").value();
  EXPECT_TRUE(again.notes.empty());
  EXPECT_EQ(again.history.at(), 1);
  EXPECT_TRUE(again.history.can_redo());
}

TEST_F(ProjectStoreTest, AKilledSessionIsRecovered) {
  in_killed_process([&] {
    ProjectStore killed = store();
    OpenProject project = killed.open_design("mask").value();
    call(project, "one");
    call(project, "two");
    ASSERT_TRUE(killed.autosave(project, "camera: top"));
  });
  ProjectStore here = store();
  const std::optional<Recovery> found = here.find_recovery();
  ASSERT_TRUE(found);
  EXPECT_EQ(found->name, "mask");
  EXPECT_EQ(found->steps, 2);
  EXPECT_NEAR(found->when, seconds_now(), 60);
  Result<Recovered> recovered = here.recover(*found);
  ASSERT_TRUE(recovered) << recovered.error().text();
  EXPECT_EQ(recovered.value().state, "camera: top");
  EXPECT_EQ(recovered.value().project.history.model()->title, "two");
  EXPECT_EQ(recovered.value().project.history.size(), 2);
  EXPECT_FALSE(here.find_recovery()) << "it is this session's own now";
  ASSERT_TRUE(here.save(recovered.value().project, "mask"));
  EXPECT_EQ(names(folder_), (Names{"mask.history.json", "mask.lissom", "sub"})) << "the side file goes on a clean save";
}

TEST_F(ProjectStoreTest, SideFilesOfLivingSessionsAreTheirs) {
  ProjectStore one = store(), two = store();
  OpenProject a = one.open_template("disc").value(), b = two.open_template("disc").value();
  EXPECT_TRUE(one.autosave(a));
  EXPECT_EQ(names(folder_), (Names{"sub"})) << "nothing is lost of what was not touched";
  call(a, "a");
  call(b, "b");
  ASSERT_TRUE(one.autosave(a));
  ASSERT_TRUE(two.autosave(b));
  EXPECT_EQ(names(folder_), (Names{".disc-2.autosave", ".disc.autosave", "sub"}));
  EXPECT_FALSE(store().find_recovery());
  ASSERT_TRUE(one.leave(a));
  const std::optional<Recovery> left = two.find_recovery();
  ASSERT_TRUE(left) << "what was left behind unsaved is offered";
  EXPECT_EQ(left->aside, ".disc.autosave");
  ASSERT_TRUE(two.dismiss(*left));
  EXPECT_FALSE(two.find_recovery());
  ASSERT_TRUE(b.history.undo());
  EXPECT_FALSE(two.dismiss({"x", "", 0, 0, "../folder/sub"}));
  EXPECT_FALSE(two.recover({"x", "", 0, 0, ".x/../.y.autosave"}));
}

TEST_F(ProjectStoreTest, AutosaveWaitsUntilItIsDue) {
  ProjectStore here = store(1000);
  OpenProject project = here.open_template("disc").value();
  call(project, "one");
  ASSERT_TRUE(here.autosave(project));
  const std::string first = read_file(folder_ / ".disc.autosave").value();
  call(project, "two");
  ASSERT_TRUE(here.autosave(project));
  EXPECT_EQ(read_file(folder_ / ".disc.autosave").value(), first);
  ASSERT_TRUE(here.autosave(project, {}, ProjectStore::When::kNow));
  EXPECT_NE(read_file(folder_ / ".disc.autosave").value(), first);
}

TEST_F(ProjectStoreTest, AKillDuringWritingLeavesOldOrNew) {
  ProjectStore here = store();
  OpenProject project = here.open_template("flower").value();
  ASSERT_TRUE(here.save(project, "a"));
  for (int round = 0; round < 8; ++round) {
    const pid_t child = fork();
    if (child == 0) {
      OpenProject mine = here.open("a.lissom").value();
      for (int i = 0;; ++i) {
        call(mine, std::to_string(round) + "." + std::to_string(i));
        if (!here.save(mine)) _exit(1);
      }
    }
    usleep(static_cast<useconds_t>(20'000 + 7'000 * round));
    kill(child, SIGKILL);
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status)) << "it has to be in the middle of something";
    const Result<OpenProject> again = here.open("a.lissom");
    ASSERT_TRUE(again) << again.error().text();
    EXPECT_TRUE(again.value().notes.empty()) << again.value().notes[0];
  }
}

TEST_F(ProjectStoreTest, NoNameLeadsOutOfTheFolder) {
  ProjectStore here = store();
  OpenProject project = here.open_template("disc").value();
  ASSERT_TRUE(write_file(top_ / "outside/secret.lissom", write_document(*project.history.model())));
  fs::create_symlink(top_ / "outside", folder_ / "way-out");
  fs::create_symlink(top_ / "outside/secret.lissom", folder_ / "secret.lissom");
  fs::create_symlink(top_ / "outside/new.lissom", folder_ / "nowhere.lissom");
  const std::string absolute = (top_ / "outside/secret.lissom").string();
  for (const std::string& name :
       {std::string("../outside/secret.lissom"), absolute, std::string("way-out/secret.lissom"),
        std::string("secret.lissom"), std::string("nowhere.lissom"), std::string("sub/../../outside/secret.lissom"),
        std::string(".."), std::string("."), std::string(""), std::string("sub"), std::string("a\\b.lissom"),
        std::string("a\nb.lissom"), std::string("c:secret.lissom"), std::string(1, '\0') + ".lissom",
        std::string("way-out/deep/new.lissom")}) {
    EXPECT_FALSE(here.open(name)) << name;
    EXPECT_FALSE(here.read(name)) << name;
    EXPECT_FALSE(here.write(name, "x")) << name;
    if (!name.empty() && name != "sub") EXPECT_FALSE(here.save(project, name, ProjectStore::Replace::kAny)) << name;
  }
  for (const char* name :
       {"../a.svg", "way-out/a.svg", ".a.svg", "sub/.b/a.svg", "a.sh", "Makefile", "a.history.json"}) {
    EXPECT_FALSE(here.write(name, "x")) << name;
  }
  EXPECT_EQ(names(top_ / "outside"), (Names{"secret.lissom"}));
  EXPECT_EQ(names(folder_), (Names{"nowhere.lissom", "secret.lissom", "sub", "way-out"}));
  ASSERT_TRUE(here.write("pictures/a.svg", "x"));
  EXPECT_EQ(here.read("pictures/a.svg").value(), "x");
}

TEST_F(ProjectStoreTest, ListsWhatIsThere) {
  ProjectStore here = store();
  OpenProject project = here.open_template("disc").value();
  ASSERT_TRUE(here.save(project, "sub/disc"));
  ASSERT_TRUE(write_file(folder_ / "beam.lissom", R"({"lissom": 1, "rods": []})"));
  ASSERT_TRUE(write_file(folder_ / "hat.lissom", R"({"lissom_project": 1})"));
  ASSERT_TRUE(write_file(folder_ / "disc.result.json", R"({"lissom_result": 1})"));
  ASSERT_TRUE(write_file(folder_ / "notes.txt", "x"));
  ASSERT_TRUE(write_file(folder_ / ".hidden.lissom", "x"));
  fs::create_symlink(top_ / "outside", folder_ / "way-out");
  Names listed;
  for (const ListedFile& file : here.files()) {
    listed.push_back(file.name + " " + file.kind);
    EXPECT_GT(file.bytes, 0U);
    EXPECT_NEAR(file.modified, seconds_now(), 60);
  }
  EXPECT_EQ(listed, (Names{"beam.lissom structure", "disc.result.json result", "hat.lissom project", "notes.txt other",
                           "sub/disc.lissom plan"}));
  ASSERT_GE(here.designs().size(), 10U);
  EXPECT_EQ(here.designs()[0].name, "butterfly");
  EXPECT_EQ(here.designs()[0].title, "Butterfly");
  EXPECT_EQ(here.designs()[0].points, 50);
  for (const ListedDesign& design : here.designs()) EXPECT_TRUE(here.open_design(design.name)) << design.name;
  EXPECT_EQ(here.open_design("buterfly").error().hint, "did you mean \"butterfly\"?");
  EXPECT_FALSE(here.open_template("disk-of-nothing"));
}

}  // namespace
}  // namespace lissom
