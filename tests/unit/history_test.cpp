/// Steps back and forth, and histories as files.

#include "lissom/editing/history.h"

#include <gtest/gtest.h>
#include <map>
#include <memory>

#include "lissom/model/document.h"
#include "lissom/session/document_file.h"
#include "tests/unit/random_edits.h"

namespace lissom {
namespace {

Model butterfly() {
  Result<Document> document = read_document_file("scenes/data/fabric/butterfly.lissom");
  EXPECT_TRUE(document.ok());
  return std::move(document).value().model;
}

Model titled(const std::string& title) {
  Model model = butterfly();
  model.title = title;
  return model;
}

std::vector<std::string> texts_of(History history) {
  EXPECT_TRUE(history.go_to(0));
  std::vector<std::string> texts{history.text()};
  while (history.can_redo()) {
    EXPECT_TRUE(history.redo());
    EXPECT_EQ(write_document(*history.model()), history.text());
    texts.push_back(history.text());
  }
  return texts;
}

/// A walk over all kinds of edits that does `steps` of them.
struct Walk {
  History history{butterfly()};
  std::vector<std::string> texts{history.text()};
  std::map<std::string, int> done;
  int refused = 0;

  Walk(unsigned seed, int steps) {
    RandomEdits random(seed);
    for (int tries = 0; history.size() < steps && tries < 100 * steps; ++tries) {
      const nlohmann::json edit = random.next(*history.model());
      Result<EditOutcome> outcome = apply_edit(*history.model(), edit);
      if (!outcome) {
        ++refused;
        EXPECT_FALSE(outcome.error().message.empty()) << edit.dump();
        EXPECT_EQ(history.text(), texts.back());
        continue;
      }
      EXPECT_FALSE(outcome.value().title.empty()) << edit.dump();
      if (!history.add({outcome.value().title, edit.dump(), 1e9 + tries}, std::move(outcome.value().model))) continue;
      ++done[edit["name"]];
      texts.push_back(history.text());
    }
  }
};

TEST(History, TwoHundredEditsOfAllKindsAreUndoneAndRedoneToTheSameBytes) {
  Walk walk(11, 200);
  History& history = walk.history;
  ASSERT_EQ(history.size(), 200);
  for (const EditInfo* info : edits()) EXPECT_GT(walk.done[std::string(info->name)], 0) << info->name;
  EXPECT_GT(walk.refused, 20);
  for (int step = 199; step >= 0; --step) {
    ASSERT_TRUE(history.undo());
    ASSERT_EQ(write_document(*history.model()), walk.texts[static_cast<std::size_t>(step)]) << step;
  }
  EXPECT_EQ(write_document(*history.model()), write_document(butterfly()));
  EXPECT_FALSE(history.undo());
  for (int step = 1; step <= 200; ++step) {
    ASSERT_TRUE(history.redo());
    ASSERT_EQ(write_document(*history.model()), walk.texts[static_cast<std::size_t>(step)]) << step;
  }
  EXPECT_FALSE(history.redo());
}

TEST(History, DocumentsOfAWalkAreReadBackToTheSameBytes) {
  const Walk walk(8, 60);
  for (const std::string& text : walk.texts) {
    const Result<Model> model = read_document(text);
    ASSERT_TRUE(model) << model.error().text() << text;
    EXPECT_EQ(write_document(model.value()), text);
  }
}

TEST(History, TheFileGivesEveryStepBack) {
  Walk walk(9, 120);
  ASSERT_TRUE(walk.history.go_to(70));
  walk.history.mark_saved();
  ASSERT_TRUE(walk.history.go_to(90));
  const std::string file = walk.history.write();
  const Result<History> read = History::read(file, {});
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(read.value().size(), 120);
  EXPECT_EQ(read.value().at(), 90);
  EXPECT_EQ(read.value().saved_at(), 70);
  EXPECT_EQ(read.value().write(), file);
  EXPECT_EQ(texts_of(read.value()), walk.texts);
  for (int step = 1; step <= 120; ++step) {
    EXPECT_EQ(read.value().step(step).title, walk.history.step(step).title);
    EXPECT_EQ(read.value().step(step).edit, walk.history.step(step).edit);
    EXPECT_EQ(read.value().step(step).seconds, walk.history.step(step).seconds);
  }
  EXPECT_LT(file.size(), 30 * walk.texts[0].size()) << "patches, not 121 documents";
}

TEST(History, ANewStepCutsWhatWasUndone) {
  History history(titled("0"));
  ASSERT_TRUE(history.add({"one", {}, 0}, titled("1")));
  ASSERT_TRUE(history.add({"two", {}, 0}, titled("2")));
  history.mark_saved();
  ASSERT_TRUE(history.undo());
  EXPECT_FALSE(history.saved());
  ASSERT_TRUE(history.add({"three", {}, 0}, titled("3")));
  EXPECT_EQ(history.size(), 2);
  EXPECT_EQ(history.step(2).title, "three");
  EXPECT_EQ(history.saved_at(), -1) << "the saved step is gone";
  EXPECT_FALSE(history.add({"again", {}, 0}, titled("3"))) << "nothing has changed";
  EXPECT_EQ(history.size(), 2);
  EXPECT_FALSE(history.go_to(3));
  EXPECT_EQ(history.at(), 2);
}

TEST(History, ForgetsTheOldestSteps) {
  History history(titled("0"), {5});
  history.mark_saved();
  for (int i = 1; i <= 12; ++i) ASSERT_TRUE(history.add({std::to_string(i), {}, 0}, titled(std::to_string(i))));
  EXPECT_EQ(history.size(), 5);
  EXPECT_EQ(history.at(), 5);
  EXPECT_EQ(history.saved_at(), -1);
  EXPECT_EQ(history.step(1).title, "8");
  ASSERT_TRUE(history.go_to(0));
  EXPECT_EQ(history.model()->title, "7");
  EXPECT_EQ(texts_of(History::read(history.write(), {}).value()), texts_of(history));
  History small(titled("0"), {1000, 3 * history.text().size()});
  for (int i = 1; i <= 12; ++i) ASSERT_TRUE(small.add({std::to_string(i), {}, 0}, titled(std::to_string(i))));
  EXPECT_EQ(small.size(), 1);
  EXPECT_EQ(small.model()->title, "12");
}

TEST(History, KeepsModelsOfStepsNearbyOnly) {
  History history(titled("0"), {1000, std::size_t{64} << 20, 2});
  const std::weak_ptr<const Model> first = history.model();
  for (int i = 1; i <= 3; ++i) ASSERT_TRUE(history.add({std::to_string(i), {}, 0}, titled(std::to_string(i))));
  EXPECT_TRUE(first.expired());
  ASSERT_TRUE(history.go_to(0));
  EXPECT_EQ(write_document(*history.model()), write_document(titled("0")));
  EXPECT_EQ(texts_of(history).back(), write_document(titled("3")));
}

TEST(History, MeetsTheDocumentThatItLiesBeside) {
  History history(titled("0"));
  for (int i = 1; i <= 4; ++i) ASSERT_TRUE(history.add({std::to_string(i), {}, 0}, titled(std::to_string(i))));
  ASSERT_TRUE(history.go_to(2));
  const std::string file = history.write();
  History same = History::read(file, {}).value();
  EXPECT_TRUE(same.meet(titled("2"), 5));
  EXPECT_EQ(same.at(), 2);
  History earlier = History::read(file, {}).value();
  EXPECT_TRUE(earlier.meet(titled("4"), 5));
  EXPECT_EQ(earlier.at(), 4);
  History other = History::read(file, {}).value();
  EXPECT_FALSE(other.meet(titled("elsewhere"), 5));
  EXPECT_EQ(other.size(), 5) << "what was undone stays";
  EXPECT_EQ(other.at(), 5);
  EXPECT_EQ(other.step(5).title, "Changed elsewhere");
  EXPECT_EQ(other.step(5).seconds, 5);
  ASSERT_TRUE(other.undo());
  EXPECT_EQ(other.model()->title, "4");
}

TEST(History, FilesThatAreBrokenAreRefused) {
  History history(titled("0"));
  for (int i = 1; i <= 3; ++i)
    ASSERT_TRUE(history.add({std::to_string(i), R"({"name":"set_title"})", 0}, titled(std::to_string(i))));
  const std::string file = history.write();
  ASSERT_TRUE(History::read(file, {}));
  for (std::size_t length = 0; length + 2 < file.size(); length += 97)
    EXPECT_FALSE(History::read(file.substr(0, length), {}));
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string changed = file;
    const std::size_t at = changed.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return History::read(changed.replace(at, from.size(), to), {});
  };
  EXPECT_FALSE(with("\"at\":3", "\"at\":4"));
  EXPECT_FALSE(with("\"at\":3", "\"at\":-1"));
  EXPECT_FALSE(with("\"lissom_history\":1", "\"lissom_history\":2"));
  EXPECT_FALSE(with("\"op\":\"replace\"", "\"op\":\"remove\""));
  EXPECT_FALSE(with("\"path\":\"/2\"", "\"path\":\"/200000\""));
  EXPECT_FALSE(with("Computational", "Manual"));
  EXPECT_FALSE(with("\"title\":\"2\"", "\"title\":2"));
}

}  // namespace
}  // namespace lissom
