#include "lissom/core/file_io.h"

#include <gtest/gtest.h>
#include <string>

namespace lissom {
namespace {
namespace fs = std::filesystem;

/// A folder that is empty at the start of a test and gone after it.
class FileIo : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() /
              ("lissom_file_io_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  int files() const {
    int count = 0;
    for (const auto& entry : fs::directory_iterator(folder_)) count += entry.exists();
    return count;
  }

  fs::path folder_;
};

TEST_F(FileIo, BytesComeBackUnchanged) {
  std::string bytes("a\0b\r\n\xff", 6);
  for (int i = 0; i < 20; ++i) bytes += bytes.substr(0, 20'000);
  ASSERT_TRUE(write_file(folder_ / "a.bin", bytes));
  const Result<std::string> read = read_file(folder_ / "a.bin");
  ASSERT_TRUE(read);
  EXPECT_EQ(read.value(), bytes);
  ASSERT_TRUE(write_file(folder_ / "a.bin", ""));
  EXPECT_EQ(read_file(folder_ / "a.bin").value(), "");
  EXPECT_EQ(files(), 1) << "no temporary file may stay";
}

TEST_F(FileIo, NamesBeyondAsciiWork) {
  const fs::path path = folder_ / fs::path(u8"Stab \u00e4 \u65e5.lissom");
  ASSERT_TRUE(write_file(path, "x"));
  EXPECT_EQ(read_file(path).value(), "x");
}

TEST_F(FileIo, MissingFilesAndFoldersAreNamed) {
  const Result<std::string> missing = read_file(folder_ / "none.lissom");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::kFile);
  EXPECT_EQ(missing.error().where, (folder_ / "none.lissom").string());
  EXPECT_EQ(missing.error().message, "there is no such file");
  EXPECT_EQ(read_file(folder_).error().message, "this is a folder, not a file");
  EXPECT_EQ(write_file(folder_, "x").error().message, "this is a folder, not a file");
  const Status status = write_file(folder_ / "no" / "a", "x");
  ASSERT_FALSE(status);
  EXPECT_NE(status.error().message.find("does not exist"), std::string::npos);
}

TEST_F(FileIo, LargeFilesAreRefused) {
  ASSERT_TRUE(write_file(folder_ / "a", std::string(1001, 'x')));
  EXPECT_TRUE(read_file(folder_ / "a", 1001));
  const Result<std::string> read = read_file(folder_ / "a", 1000);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().message, "the file is larger than 1000 bytes");
}

TEST_F(FileIo, LeftoversOfKilledRunsAreSteppedOver) {
  ASSERT_TRUE(write_file(folder_ / ".a.tmp0", "half a fi"));
  ASSERT_TRUE(write_file(folder_ / "a", "whole"));
  EXPECT_EQ(read_file(folder_ / "a").value(), "whole");
  EXPECT_EQ(read_file(folder_ / ".a.tmp0").value(), "half a fi");
  EXPECT_EQ(files(), 2);
}

TEST_F(FileIo, TheOldFileStaysWhenTheNewOneCannotBePutInPlace) {
  ASSERT_TRUE(write_file(folder_ / "a", "old"));
  for (int i = 0; i < 1000; ++i) fs::create_directory(folder_ / (".a.tmp" + std::to_string(i)));
  const Status status = write_file(folder_ / "a", "new");
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::kFile);
  EXPECT_EQ(read_file(folder_ / "a").value(), "old");
}

TEST_F(FileIo, LinksAreFollowedAndPermissionsKept) {
  ASSERT_TRUE(write_file(folder_ / "target", "old"));
  fs::permissions(folder_ / "target", fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("target", folder_ / "link");
  ASSERT_TRUE(write_file(folder_ / "link", "new"));
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_EQ(read_file(folder_ / "target").value(), "new");
  EXPECT_EQ(fs::status(folder_ / "target").permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(FileIo, WritingBelowAFolderStaysThere) {
  const fs::path inside = folder_ / "inside", outside = folder_ / "outside";
  fs::create_directories(inside);
  fs::create_directories(outside);
  ASSERT_TRUE(write_file_below(inside, "a.txt", "1"));
  ASSERT_TRUE(write_file_below(inside, "new/deep/./b.txt", "2"));
  EXPECT_EQ(read_file_below(inside, "new/deep/b.txt").value(), "2");
  fs::create_symlink(outside, inside / "way-out");
  fs::create_symlink(outside / "not-there", inside / "nowhere");
  fs::create_symlink(inside / "a.txt", inside / "same");
  fs::create_symlink("loop", inside / "loop");
  for (const char* name : {"", ".", "..", "../outside/x", "new/../../outside/x", "/tmp/x", "way-out/x", "way-out",
                           "nowhere", "loop", "loop/x", "a.txt/x", "new", "a\\b", "c:x", "a\nb"}) {
    const Status status = write_file_below(inside, name, "x");
    EXPECT_FALSE(status) << name;
    EXPECT_FALSE(path_below(inside, name)) << name;
  }
  EXPECT_TRUE(fs::is_empty(outside));
  ASSERT_TRUE(write_file_below(inside, "same", "3")) << "a link within the folder is followed";
  EXPECT_EQ(read_file(inside / "a.txt").value(), "3");
  EXPECT_TRUE(fs::is_symlink(inside / "same"));
  EXPECT_EQ(path_below(inside, "not/yet.txt").value(), fs::canonical(inside) / "not/yet.txt");
}

}  // namespace
}  // namespace lissom
