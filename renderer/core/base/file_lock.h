// A lock that the kernel releases when its process ends, however it ends.
#pragma once

#include <filesystem>
#include <optional>

namespace dermis {

class FileLock {
 public:
  /// Makes the file where it is missing. Nothing where another process (or another lock here) holds it, or where the
  /// file cannot be made.
  [[nodiscard]] static std::optional<FileLock> tryLock(const std::filesystem::path& path);
  ~FileLock();
  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&& other) noexcept;
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

  /// Removes the file and lets go.
  void removeFile();

 private:
  FileLock(std::filesystem::path path, int descriptor);
  std::filesystem::path m_path;
  int m_descriptor = -1;
};

}  // namespace dermis
