#include "core/base/file_io.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>

#include "unit/temporary_folder.h"

namespace dermis {
namespace {

using test::contentOf;
using test::isOneSentence;
using test::TemporaryFolder;
using testing::HasSubstr;
namespace fs = std::filesystem;

TEST(ReadFile, ReturnsTheBytes) {
  const TemporaryFolder folder;
  const std::string bytes("a\0b\n\xff", 5);
  EXPECT_EQ(readFile(folder.write("x", bytes), 100).value(), bytes);
  EXPECT_EQ(readFile(folder.write("empty", ""), 100).value(), "");
}

TEST(ReadFile, SaysWhatIsWrong) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("x", "12345");
  const auto refusal = [&](const fs::path& path, std::size_t limit) {
    const auto read = readFile(path, limit);
    EXPECT_FALSE(read.has_value());
    if (read) return std::string();
    EXPECT_EQ(read.error().kind, Error::Kind::Input);
    EXPECT_TRUE(isOneSentence(read.error().message));
    EXPECT_THAT(read.error().message, HasSubstr(path.string()));
    return read.error().message;
  };
  EXPECT_THAT(refusal(folder / "missing", 10), HasSubstr("no such file"));
  EXPECT_THAT(refusal(folder.path(), 10), HasSubstr("a folder"));
  EXPECT_THAT(refusal(file, 4), HasSubstr("larger than the 4 bytes"));
  EXPECT_THAT(refusal("/dev/zero", 1000), HasSubstr("larger"));
  EXPECT_THAT(refusal(file / "below", 10), HasSubstr("not a folder"));
  EXPECT_TRUE(readFile(file, 5).has_value());
}

TEST(ReadFile, DoesNotWaitForAPipeThatNobodyWritesTo) {
  const TemporaryFolder folder;
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_EQ(readFile(folder / "pipe", 10).value(), "");
}

TEST(WriteFile, CreatesAndReplaces) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writeFileAtomically(folder / "x", "one").has_value());
  EXPECT_EQ(contentOf(folder / "x"), "one");
  ASSERT_TRUE(writeFileAtomically(folder / "x", "two").has_value());
  EXPECT_EQ(contentOf(folder / "x"), "two");
  EXPECT_EQ(folder.fileCount(), 1U);
}

TEST(WriteFile, KeepsPermissionsAndObeysTheUmask) {
  const TemporaryFolder folder;
  const auto mode = [&](const char* name) {
    struct stat status {};
    ::stat((folder / name).c_str(), &status);
    return status.st_mode & 07777U;
  };
  folder.write("x", "one");
  ::chmod((folder / "x").c_str(), 0640);
  ASSERT_TRUE(writeFileAtomically(folder / "x", "two").has_value());
  EXPECT_EQ(mode("x"), 0640U);

  const mode_t before = ::umask(027);
  ASSERT_TRUE(writeFileAtomically(folder / "y", "new").has_value());
  ::umask(before);
  EXPECT_EQ(mode("y"), 0640U);
}

TEST(WriteFile, WritesThroughALink) {
  const TemporaryFolder folder;
  folder.write("real/x", "one");
  fs::create_symlink(folder / "real/x", folder / "link");
  ASSERT_TRUE(writeFileAtomically(folder / "link", "two").has_value());
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(contentOf(folder / "real/x"), "two");
}

std::string refusalToWrite(const fs::path& path, std::string_view bytes = "text") {
  const auto written = writeFileAtomically(path, bytes);
  EXPECT_FALSE(written.has_value());
  if (written) return {};
  EXPECT_EQ(written.error().kind, Error::Kind::Runtime);
  EXPECT_TRUE(isOneSentence(written.error().message));
  EXPECT_THAT(written.error().message, HasSubstr(path.string()));
  return written.error().message;
}

TEST(WriteFile, SaysWhatIsWrong) {
  const TemporaryFolder folder;
  EXPECT_THAT(refusalToWrite(folder / "no/such/x"), HasSubstr("does not exist"));
  EXPECT_THAT(refusalToWrite(folder.path()), HasSubstr("it is a folder"));
  EXPECT_THAT(refusalToWrite(folder / std::string(300, 'n')), HasSubstr("too long"));
  EXPECT_THAT(refusalToWrite("/dev/full"), HasSubstr("the disk is full"));
  EXPECT_EQ(folder.fileCount(), 0U);
}

TEST(WriteFile, ReadOnlyFolderAndFile) {
  if (::geteuid() == 0) {
    // Root may write anywhere but to what the kernel itself offers read-only.
    EXPECT_THAT(refusalToWrite("/proc/version"), HasSubstr("/proc/version"));
    return;
  }
  const TemporaryFolder folder;
  const fs::path file = folder.write("x", "one");
  fs::permissions(file, fs::perms::owner_read);
  EXPECT_THAT(refusalToWrite(file), HasSubstr("read-only"));
  fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_THAT(refusalToWrite(folder / "y"), HasSubstr("read-only"));
  fs::permissions(folder.path(), fs::perms::owner_all);
  EXPECT_EQ(contentOf(file), "one");
}

TEST(WriteFile, AFullDiskLosesNothingAndLeavesNothing) {
  const TemporaryFolder folder;
  folder.write("x", "one");
  // The limit on a file's size stands for the full disk: writing fails half-way.
  rlimit before{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  const rlimit small{1000, before.rlim_max};
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  ::setrlimit(RLIMIT_FSIZE, &small);
  const auto written = writeFileAtomically(folder / "x", std::string(5000, 'b'));
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  ASSERT_FALSE(written.has_value());
  EXPECT_EQ(contentOf(folder / "x"), "one");
  EXPECT_EQ(folder.fileCount(), 1U);
}

TEST(ReplaceFile, AProducerThatFailsLeavesTheOldFile) {
  const TemporaryFolder folder;
  folder.write("x.png", "one");
  fs::path temporary;
  const auto written = replaceFileAtomically(folder / "x.png", [&](const fs::path& path) -> Result<void> {
    temporary = path;
    EXPECT_EQ(path.parent_path(), folder.path());
    EXPECT_EQ(path.extension(), ".png");
    return runtimeError("no");
  });
  EXPECT_EQ(written.error().message, "no");
  EXPECT_FALSE(fs::exists(temporary));
  EXPECT_EQ(contentOf(folder / "x.png"), "one");
}

}  // namespace
}  // namespace dermis
