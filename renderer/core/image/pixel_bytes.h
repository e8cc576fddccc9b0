// The bytes of an image: its own, or those of a mapped file until somebody writes.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "core/base/mapped_file.h"

namespace dermis {

/// A vector of bytes that may stand in a file instead. Reading never copies; what changes them makes them its own
/// first.
class PixelBytes {
 public:
  PixelBytes() = default;
  PixelBytes(std::vector<std::byte> bytes) : m_own(std::move(bytes)) {}  // NOLINT: takes a vector's place
  /// `part` lies in the file.
  PixelBytes(std::shared_ptr<const MappedFile> file, std::span<const std::byte> part)
      : m_file(std::move(file)), m_part(part) {}

  [[nodiscard]] const std::byte* data() const { return m_file ? m_part.data() : m_own.data(); }
  [[nodiscard]] std::size_t size() const { return m_file ? m_part.size() : m_own.size(); }
  [[nodiscard]] bool empty() const { return size() == 0; }
  [[nodiscard]] const std::byte* begin() const { return data(); }
  [[nodiscard]] const std::byte* end() const { return data() + size(); }
  [[nodiscard]] const std::byte& operator[](std::size_t i) const { return data()[i]; }

  [[nodiscard]] std::byte* data() { return own().data(); }
  [[nodiscard]] std::byte* begin() { return own().data(); }
  [[nodiscard]] std::byte* end() { return own().data() + m_own.size(); }
  [[nodiscard]] std::byte& operator[](std::size_t i) { return own()[i]; }
  void reserve(std::size_t size) { own().reserve(size); }
  void resize(std::size_t size) { own().resize(size); }
  void assign(std::size_t count, std::byte value) { *this = std::vector<std::byte>(count, value); }
  void assign(std::span<const std::byte> bytes) { *this = std::vector<std::byte>(bytes.begin(), bytes.end()); }
  void append(std::span<const std::byte> bytes) { own().insert(m_own.end(), bytes.begin(), bytes.end()); }
  void push_back(std::byte value) { own().push_back(value); }
  void clear() { *this = PixelBytes(); }

  /// Where they stand in a file their memory is free until somebody reads again.
  void giveBack() const {
    if (m_file) m_file->giveBack();
  }

  friend bool operator==(const PixelBytes& a, const PixelBytes& b) {
    return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin());
  }

 private:
  std::vector<std::byte>& own() {
    if (m_file) {
      m_own.assign(m_part.begin(), m_part.end());
      m_file.reset();
      m_part = {};
    }
    return m_own;
  }

  std::vector<std::byte> m_own;
  std::shared_ptr<const MappedFile> m_file;
  std::span<const std::byte> m_part;
};

}  // namespace dermis
