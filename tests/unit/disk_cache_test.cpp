#include "core/io/disk_cache.h"

#include <gtest/gtest.h>

#include <chrono>

#include "unit/temporary_folder.h"

namespace dermis {
namespace {

namespace fs = std::filesystem;

TEST(DiskCache, WhatWasUsedLongestAgoGoesFirst) {
  const test::TemporaryFolder folder;
  const auto keep = [&](const char* name, int hoursAgo) {
    fs::last_write_time(folder.write(name, std::string(100, '.')),
                        fs::file_time_type::clock::now() - std::chrono::hours(hoursAgo));
  };
  const auto fill = [&] {
    keep("old.a", 3);
    keep("older.b", 4);
    keep("new.a", 1);
  };
  fill();
  folder.write("below/other.a", std::string(1000, '.'));
  trimDiskCache(folder.path(), ".a", 150);
  EXPECT_FALSE(fs::exists(folder / "old.a"));
  EXPECT_TRUE(fs::exists(folder / "older.b")) << "another kind of file";
  EXPECT_TRUE(fs::exists(folder / "new.a"));

  fill();
  trimDiskCache(folder.path(), "", 250);
  EXPECT_FALSE(fs::exists(folder / "older.b"));
  EXPECT_TRUE(fs::exists(folder / "old.a"));
  trimDiskCache(folder.path(), "", 0);
  EXPECT_FALSE(fs::exists(folder / "old.a"));
  EXPECT_TRUE(fs::exists(folder / "new.a")) << "the one used last stays";
  EXPECT_TRUE(fs::exists(folder / "below/other.a"));
}

TEST(DiskCache, KindsLieBelowTheUsersFolder) {
  const fs::path folder = userCacheFolder();
  ASSERT_FALSE(folder.empty()) << "the tests have a home of their own";
  EXPECT_EQ(userCacheFolder("maps"), folder / "maps");
  // Neither kept nor shipped: where it would be written.
  EXPECT_EQ(cachedFile(folder / "maps/none.dermismap"), folder / "maps/none.dermismap");
  EXPECT_TRUE(cachedFile({}).empty());
}

}  // namespace
}  // namespace dermis
