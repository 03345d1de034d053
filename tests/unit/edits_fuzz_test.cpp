/// Edits that a broken or hostile page might send: refused with a place and a sentence, or done right, never worse.

#include <gtest/gtest.h>
#include <limits>

#include "lissom/model/document.h"
#include "lissom/session/document_file.h"
#include "tests/unit/random_edits.h"

namespace lissom {
namespace {

using Json = nlohmann::json;

/// Puts something else into one place of an edit.
class Spoiler {
 public:
  explicit Spoiler(unsigned seed) : random_(seed) {}

  void spoil(Json& value, int depth = 0) {
    const bool inside = value.is_structured() && !value.empty() && depth < 6;
    if (!inside || random_() % 4 == 0) {
      value = junk();
      return;
    }
    if (value.is_object() && random_() % 6 == 0) {
      value.erase(std::next(value.begin(), static_cast<long>(random_() % value.size())).key());
      return;
    }
    auto at = value.begin();
    std::advance(at, static_cast<long>(random_() % value.size()));
    spoil(*at, depth + 1);
  }

 private:
  Json junk() {
    const double infinity = std::numeric_limits<double>::infinity();
    const Json all[] = {Json(),
                        true,
                        -1,
                        0,
                        3,
                        1e300,
                        -1e-300,
                        infinity,
                        std::numeric_limits<double>::quiet_NaN(),
                        std::numeric_limits<std::uint64_t>::max(),
                        std::numeric_limits<std::int64_t>::min(),
                        "",
                        "head",
                        "body-l",
                        "x",
                        std::string(1000, 'a'),
                        "\n\t\x01",
                        Json::array(),
                        Json::object(),
                        Json::array({1, 2}),
                        Json::array({"head", "head"}),
                        Json::array({Json::array({"head", "tail"})}),
                        Json{{"point", "head"}},
                        Json{{"axis", "x"}, {"at_mm", 1e30}}};
    return all[random_() % std::size(all)];
  }

  std::mt19937 random_;
};

TEST(EditsFuzz, SpoiltEditsAreRefusedOrRight) {
  const Model model = read_document_file("scenes/data/fabric/butterfly.lissom").value().model;
  const std::string before = write_document(model);
  RandomEdits random(11);
  Spoiler spoiler(12);
  int done = 0, refused = 0;
  for (int i = 0; i < 4000; ++i) {
    Json edit = random.next(model);
    spoiler.spoil(edit);
    const Result<EditOutcome> outcome = apply_edit(model, edit);
    if (!outcome) {
      ++refused;
      EXPECT_FALSE(outcome.error().message.empty());
      EXPECT_FALSE(outcome.error().where.empty()) << outcome.error().message;
      continue;
    }
    ++done;
    const std::string text = write_document(outcome.value().model);
    const Result<Model> again = read_document(text);
    ASSERT_TRUE(again) << again.error().text() << edit.dump();
    ASSERT_EQ(write_document(again.value()), text);
  }
  EXPECT_EQ(write_document(model), before);
  EXPECT_GT(done, 100);
  EXPECT_GT(refused, 2000);
}

}  // namespace
}  // namespace lissom
