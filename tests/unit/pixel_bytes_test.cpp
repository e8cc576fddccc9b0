// PixelBytes: own bytes and a file's.
#include "core/image/pixel_bytes.h"

#include <gtest/gtest.h>

#include "unit/temporary_folder.h"

namespace dermis::test {
namespace {

class MappedPixels : public testing::Test {
 protected:
  /// "abcdefgh" in a file, without the first two.
  PixelBytes mapped() {
    m_file = std::make_shared<const MappedFile>(m_folder.write("pixels", "abcdefgh"));
    return {m_file, m_file->bytes().subspan(2)};
  }
  static std::string text(const PixelBytes& bytes) {
    std::string text;
    for (const std::byte b : bytes) text += static_cast<char>(b);
    return text;
  }
  TemporaryFolder m_folder;
  std::shared_ptr<const MappedFile> m_file;
};

TEST_F(MappedPixels, AreReadWhereTheyStand) {
  const PixelBytes bytes = mapped();
  EXPECT_EQ(text(bytes), "cdefgh");
  EXPECT_EQ(bytes.data(), m_file->bytes().data() + 2);
  const std::vector<PixelBytes> copies(2, bytes);
  EXPECT_EQ(copies[1].data(), bytes.data()) << "a copy shares the file";
  EXPECT_EQ(bytes[3], std::byte{'f'});
  bytes.giveBack();
  EXPECT_EQ(text(bytes), "cdefgh") << "what was given back comes again";
}

TEST_F(MappedPixels, BecomeTheirOwnWhenWrittenTo) {
  const PixelBytes original = mapped();
  PixelBytes changed = original;
  changed[0] = std::byte{'X'};
  EXPECT_EQ(text(changed), "Xdefgh");
  EXPECT_EQ(text(original), "cdefgh");
  PixelBytes longer = original;
  longer.push_back(std::byte{'i'});
  longer.append(original);
  EXPECT_EQ(text(longer), "cdefghicdefgh");
  EXPECT_FALSE(longer == original);
  EXPECT_TRUE(original == mapped());
  longer.clear();
  EXPECT_TRUE(longer.empty());
}

TEST_F(MappedPixels, OutliveTheirFile) {
  const PixelBytes bytes = mapped();
  m_file.reset();
  std::filesystem::remove(m_folder / "pixels");
  EXPECT_EQ(text(bytes), "cdefgh");
}

TEST_F(MappedPixels, AFileThatIsNotThereIsEmpty) {
  const MappedFile none(m_folder / "none");
  EXPECT_TRUE(none.bytes().empty());
  none.giveBack();
  EXPECT_TRUE(MappedFile(m_folder.write("empty", "")).bytes().empty());
}

}  // namespace
}  // namespace dermis::test
