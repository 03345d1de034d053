/// Documents that name an OBJ drawing: what is read, what is written back, and which files are out of reach.

#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>
#include <string>

#include "lissom/core/file_io.h"
#include "lissom/model/document.h"
#include "lissom/model/structure.h"
#include "tests/unit/model_bits.h"

namespace lissom {
namespace {
namespace fs = std::filesystem;

const fs::path kGood = "tests/documents/good";

Model drawing() {
  const Result<Model> model = read_document(read_file(kGood / "drawing.lissom").value(), kGood);
  EXPECT_TRUE(model) << (model ? "" : model.error().text());
  return model ? model.value() : Model();
}

/// A folder that is gone after the test.
class Scratch {
 public:
  Scratch()
      : path_(fs::temp_directory_path() /
              ("lissom-" + std::to_string(::testing::UnitTest::GetInstance()->random_seed()) + "-" +
               ::testing::UnitTest::GetInstance()->current_test_info()->name())) {
    fs::remove_all(path_);
    fs::create_directories(path_ / "documents" / "plans");
  }
  ~Scratch() { fs::remove_all(path_); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  fs::path documents() const { return path_ / "documents"; }
  const fs::path& path() const { return path_; }
  /// Reads a document in documents() whose network is `file`, with more keys of the network.
  Result<Model> read(const std::string& file, const std::string& more = R"(, "edges": 2)") const {
    return read_document(R"({"lissom": 1, "units": {"length": "m"}, "networks": [{"name": "n", "file": ")" + file +
                             R"(", "material": "PLA", "section": {"radius": 0.001})" + more + "}]}",
                         documents());
  }

 private:
  fs::path path_;
};

constexpr const char* kCross = "v 0 0 0\nv 2 0 0\nv 4 0 0\nv 2 2 0\nl 1 2 3\nl 2 4\n";

TEST(NetworkFile, TheDrawingBecomesRods) {
  const Model model = drawing();
  ASSERT_EQ(model.rods.size(), 14u);  // the prop, and 13 lines between crossings
  EXPECT_EQ(model.rods[0].name, "prop");
  EXPECT_EQ(model.rods[1].name, "plan-0");
  EXPECT_EQ(std::get<Polyline>(model.rods[1].curve).points[1], Vec3(0.4, 0, 0));
  ASSERT_EQ(model.network_files.size(), 1u);
  EXPECT_EQ(model.network_files[0].rod_count, 13);
  const Result<Structure> structure = discretize(model);
  ASSERT_TRUE(structure);
  EXPECT_EQ(structure.value().components, 1);
  ASSERT_EQ(structure.value().notes.size(), 1u);
  EXPECT_EQ(structure.value().notes[0],
            "drawing.obj: 1 statements of the file were not read (faces, groups, materials)");
}

TEST(NetworkFile, WritingNamesTheFileAgain) {
  const std::string text = write_document(drawing());
  EXPECT_NE(text.find(R"("file": "drawing.obj")"), std::string::npos) << text;
  EXPECT_EQ(text.find("plan-0"), std::string::npos);
  const Result<Model> again = read_document(text, kGood);
  ASSERT_TRUE(again) << again.error().text();
  EXPECT_EQ(ModelBits::of(again.value()), ModelBits::of(drawing()));
}

TEST(NetworkFile, WritingRodsNeedsNoFile) {
  const std::string text = write_document(drawing(), NetworkText::kRods);
  const Result<Model> again = read_document(text, "tests");
  ASSERT_TRUE(again) << again.error().text();
  EXPECT_EQ(again.value().rods.size(), drawing().rods.size());
  EXPECT_TRUE(again.value().network_files.empty());
  EXPECT_EQ(write_document(again.value(), NetworkText::kRods), text);
}

TEST(NetworkFile, RodsThatWereChangedAreWrittenOut) {
  Model thicker = drawing(), moved = drawing(), more = drawing();
  thicker.rods[5].section.r_n = thicker.rods[5].section.r_b = {0.006};
  std::get<Polyline>(moved.rods.back().curve).points[0].z() += 1e-12;
  more.rods.push_back(more.rods[0]);
  more.rods.back().name = "another";
  for (const Model& model : {thicker, moved, more}) {
    const std::string text = write_document(model);
    EXPECT_EQ(text.find("drawing.obj"), std::string::npos);
    const Result<Model> again = read_document(text);
    ASSERT_TRUE(again) << again.error().text();
    EXPECT_EQ(again.value().rods.size(), model.rods.size());
  }
}

TEST(NetworkFile, UnitsChainsAndEdgesAreAsAsked) {
  const Scratch scratch;
  ASSERT_TRUE(write_file(scratch.documents() / "plans" / "net.obj", "v 0 0 0\nv 2 0 0\nv 4 0 0\nl 1 2 3\n"));
  const Result<Model> metres = scratch.read("plans/net.obj");
  ASSERT_TRUE(metres) << metres.error().text();
  ASSERT_EQ(metres.value().rods.size(), 1u);
  EXPECT_EQ(metres.value().rods[0].edges, 4);
  EXPECT_EQ(std::get<Polyline>(metres.value().rods[0].curve).points[2], Vec3(4, 0, 0));
  const Result<Model> inches =
      scratch.read("plans/net.obj", R"(, "unit": "in", "rods": "segments", "edge_length": 0.01)");
  ASSERT_TRUE(inches) << inches.error().text();
  ASSERT_EQ(inches.value().rods.size(), 2u);
  EXPECT_DOUBLE_EQ(std::get<Polyline>(inches.value().rods[0].curve).points[1].x(), 0.0508);
  EXPECT_EQ(inches.value().rods[0].edges, 0);
  const Result<Model> again = read_document(write_document(inches.value()), scratch.documents());
  ASSERT_TRUE(again) << again.error().text();
  EXPECT_EQ(ModelBits::of(again.value()), ModelBits::of(inches.value()));
}

TEST(NetworkFile, SeveralNetworksKeepTheirOrderOnceWritten) {
  const Scratch scratch;
  ASSERT_TRUE(write_file(scratch.documents() / "net.obj", kCross));
  const Result<Model> model = scratch.read(
      "net.obj", R"(, "edges": 2}, {"name": "inline", "points": [[0, 0, 1], [1, 0, 1]], "lines": [[0, 1]], "edges": 3,
                     "material": "PLA", "section": {"radius": 0.001}}, {"name": "m", "file": "net.obj", "unit": "mm",
                     "material": "PLA", "section": {"radius": 0.001}, "edges": 1)");
  ASSERT_TRUE(model) << model.error().text();
  ASSERT_EQ(model.value().rods.size(), 7u);
  EXPECT_EQ(model.value().rods[0].name, "inline-0");
  EXPECT_EQ(model.value().rods[1].name, "n-0");
  const std::string text = write_document(model.value());
  const Result<Model> again = read_document(text, scratch.documents());
  ASSERT_TRUE(again) << again.error().text();
  EXPECT_EQ(ModelBits::of(again.value()), ModelBits::of(model.value()));
  EXPECT_EQ(write_document(again.value()), text);
}

TEST(NetworkFile, LinksAndOddPathsDoNotLeaveTheFolder) {
  const Scratch scratch;
  ASSERT_TRUE(write_file(scratch.path() / "secret.obj", kCross));
  ASSERT_TRUE(write_file(scratch.documents() / "net.obj", kCross));
  fs::create_symlink(scratch.path() / "secret.obj", scratch.documents() / "out.obj");
  fs::create_directory_symlink(scratch.path(), scratch.documents() / "up");
  fs::create_symlink("net.obj", scratch.documents() / "in.obj");
  EXPECT_TRUE(scratch.read("net.obj"));
  EXPECT_TRUE(scratch.read("in.obj"));
  for (const char* file : {"out.obj", "up/secret.obj", "../secret.obj", "plans/../net.obj", "/dev/zero", "/",
                           "net.obj/x", "net\\u0000.obj", "plans", "C:net.obj", "missing/net.obj"}) {
    const Result<Model> model = scratch.read(file);
    ASSERT_FALSE(model) << file;
    EXPECT_EQ(model.error().code, ErrorCode::kFile) << file;
    EXPECT_EQ(model.error().where, "/networks/0/file");
    EXPECT_EQ(model.error().text().find("secret.obj:"), std::string::npos);
  }
}

}  // namespace
}  // namespace lissom
