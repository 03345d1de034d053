/// Documents damaged at random have to end in a model or in an error with a text, and models in a system, finite forces or
/// again an error, soon. 2,000 damaged documents by default; LISSOM_MUTANTS=20000 for the long run (under sanitizers).

#include <filesystem>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "lissom/core/file_io.h"
#include "lissom/model/document.h"
#include "tests/unit/mutator.h"

namespace lissom {
namespace {

const char* const kValues[] = {"NaN",
                               "1e999",
                               "-0",
                               "-1e308",
                               "1e-400",
                               "99999999999999999999",
                               "0",
                               "-1",
                               "null",
                               "true",
                               "\"\"",
                               "\"1e308 km\"",
                               "[]",
                               "{}",
                               "\"\\ud800\"",
                               "\"-5 %\"",
                               "2147483648",
                               "1e300",
                               "\"\\u0000\"",
                               "\"all\"",
                               "1e9",
                               "1000000",
                               "\"1e-30 m\"",
                               "\"1e17 m\"",
                               "\"boundary\"",
                               "\"never\"",
                               "3",
                               "true"};

TEST(DocumentFuzz, DamagedDocumentsAreReadOrRefusedWithAReason) {
  std::vector<std::string> documents;
  const std::filesystem::path folder = "tests/documents/good";
  for (const char* name : {"cantilever", "everything", "gridshell", "smallest", "drawing"}) {
    documents.push_back(read_file(folder / (std::string(name) + ".lissom")).value());
  }
  const int mutants = mutant_count();
  ASSERT_GT(mutants, 0);
  FuzzTally tally;
  for (int i = 0; i < mutants; ++i) {
    Mutator mutator(static_cast<unsigned>(i), kValues);
    const std::size_t n = documents.size(), which = static_cast<std::size_t>(i) % n;
    const std::string text = mutator.mutate(documents[which], documents[(which + 1) % n]);
    SCOPED_TRACE(i);
    tally.watch.start();
    const Result<Model> model = read_document(text, folder);
    if (!model) {
      tally.refuse(model.error(), text);
    } else {
      const std::string written = write_document(model.value());
      const Result<Model> again = read_document(written, folder);
      EXPECT_TRUE(again) << again.error().text() << "\nfrom\n" << text << "\nwritten\n" << written;
      tally.accept(model.value());
    }
    tally.watch.stop();
  }
  tally.check("documents", mutants, 20, 2);
}

/// Numbers that would exhaust memory or time are refused at once.
TEST(DocumentFuzz, HugeCountsAreRefusedWithARemedy) {
  const auto rod = [](const std::string& curve, const std::string& cut) {
    return R"({"lissom": 1, "rods": [{"name": "a", "material": "PLA", "section": {"radius": "1 mm"}, )" + curve +
           (cut.empty() ? "" : ", " + cut) + "}]}";
  };
  const std::string line = R"("line": [[0, 0, 0], [100, 0, 0]])";
  const auto helix = [](const std::string& turns) {
    return R"("helix": {"centre": [0, 0, 0], "start": [10, 0, 0], "pitch": "1 mm", "turns": )" + turns + "}";
  };
  const std::string huge[] = {
      rod(line, R"("edges": 1000000000)"),
      rod(line, R"("edges": 1e300)"),
      rod(line, R"("edge_length": "1e-12 mm")"),
      rod(line, R"("edge_length": "1e-300 mm")"),
      rod(helix("1e300"), R"("edges": 10)"),
      rod(helix("1e7"), R"("edges": 10)"),
      rod(helix("900000"), R"("edge_length": 0.1)"),
      rod(R"("line": [[0, 0, 0], [1e300, 0, 0]])", R"("edges": 10)"),
      rod(R"("line": [[0, 0, 0], ["1e17 m", 0, 0]])", R"("edge_length": 1)"),
  };
  for (const std::string& text : huge) {
    Stopwatch watch;
    watch.start();
    const Result<Model> model = read_document(text);
    const Result<System> system = model ? make_system(model.value()) : Result<System>(model.error());
    watch.stop();
    ASSERT_FALSE(system) << text;
    EXPECT_FALSE(system.error().message.empty());
    EXPECT_LT(watch.longest(), kLongest / 5) << text;
    EXPECT_TRUE(system.error().message.find("whole number") != std::string::npos || !system.error().hint.empty())
        << text;
  }
}

}  // namespace
}  // namespace lissom
