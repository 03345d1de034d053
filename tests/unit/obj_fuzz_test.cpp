/// Drawings damaged at random have to end in a network or in an error with a text; networks go on to a system.

#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "lissom/core/file_io.h"
#include "lissom/model/document.h"
#include "lissom/model/import_network.h"
#include "tests/unit/mutator.h"

namespace lissom {
namespace {

const char* const kValues[] = {"nan", "inf",       "1e999",      "-0",   "1e-320",    "1e300",   "1e17",    "-1e150",
                               "0",   "-1",        "2147483648", "l",    "v",         "\\\n",    "1/2/3",   "1//",
                               "#",   "999999999", "1000000000", "\r\n", "v 0 0 0\n", "l 1 2\n", "l 1 1\n", "2"};

const char* const kEveryForm =
    "# plan\no net\nv 0 0 0\nv 1000 0 0\nv 1000 1000 0\nv 0 1000 0\nv 500 500 100 1.0\nvt 0 0\nl 1 2 3 4 1\n"
    "l 1/1 5\nl -1 \\\n 3\nv 2000 0 0\nv 2000 1000 0\nl 2 6 7 3\nl 6 7\nf 1 2 3\n";

TEST(ObjFuzz, DamagedDrawingsAreImportedOrRefusedWithAReason) {
  const std::string drawings[] = {read_file("scenes/data/gridshell.obj").value(), kEveryForm,
                                  read_file("tests/documents/good/drawing.obj").value()};
  const int mutants = mutant_count();
  ASSERT_GT(mutants, 0);
  FuzzTally tally;
  for (int i = 0; i < mutants; ++i) {
    Mutator mutator(static_cast<unsigned>(i), kValues);
    const std::size_t n = std::size(drawings), which = static_cast<std::size_t>(i) % n;
    const std::string text = mutator.mutate(drawings[which], drawings[(which + 1) % n]);
    SCOPED_TRACE(i);
    tally.watch.start();
    NetworkOptions options;
    options.scale = 0.001;
    options.section.r_n = options.section.r_b = {0.005};
    options.edges_per_segment = 1 + i % 3;
    options.rods = i % 2 ? NetworkRods::kSegments : NetworkRods::kChains;
    const Result<ObjLines> lines = read_obj_lines(text, "mutant.obj");
    const Result<ImportedNetwork> network =
        lines ? import_network(lines.value(), options) : Result<ImportedNetwork>(lines.error());
    const Status valid = network ? network.value().model.validate() : Status(network.error());
    if (!valid) {
      EXPECT_FALSE(valid.error().where.empty()) << text;
      tally.refuse(valid.error(), text);
    } else {
      const Result<Model> again = read_document(write_document(network.value().model));
      EXPECT_TRUE(again) << again.error().text() << "\nfrom\n" << text;
      tally.accept(network.value().model);
    }
    tally.watch.stop();
  }
  tally.check("drawings", mutants, 10, 10);
}

}  // namespace
}  // namespace lissom
