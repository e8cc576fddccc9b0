// A file's bytes in memory without reading them: the system brings them as they are looked at, and may take them back.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

namespace dermis {

/// A read-only view of a whole file; empty where it could not be opened. The file may be replaced or removed meanwhile
/// (the view keeps what was there), but never shortened in place.
class MappedFile {
 public:
  explicit MappedFile(const std::filesystem::path& path);
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  [[nodiscard]] std::span<const std::byte> bytes() const { return {static_cast<const std::byte*>(m_data), m_size}; }
  /// The memory is free until somebody looks again.
  void giveBack() const;

 private:
  void* m_data = nullptr;
  std::size_t m_size = 0;
};

}  // namespace dermis
