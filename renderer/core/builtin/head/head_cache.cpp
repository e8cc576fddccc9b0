#include "core/builtin/head/head_cache.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <array>
#include <cstring>
#include <system_error>
#include <type_traits>

#include "core/base/file_io.h"
#include "core/io/disk_cache.h"
#include "generated/head_source_hash.h"

namespace dermis {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSuffix = ".dermishead";
constexpr std::uintmax_t kMostBytes = std::uintmax_t{256} << 20U;
constexpr std::array<char, 8> kMagic = {'D', 'R', 'M', 'S', 'H', 'D', '0', '1'};

/// In front of the arrays. Plain values of one machine's byte order: a cache doesn't travel.
struct Header {
  std::array<char, 8> magic;
  std::uint64_t source, hash;
};

/// Copies between a head and bytes, in one order for both directions.
class Writer {
 public:
  explicit Writer(std::string& bytes) : m_bytes(bytes) {}
  template <class T>
  void array(const std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T>);
    const std::uint64_t count = values.size();
    m_bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
    m_bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
  }

 private:
  std::string& m_bytes;
};
class Reader {
 public:
  explicit Reader(std::string_view bytes) : m_bytes(bytes) {}
  template <class T>
  void array(std::vector<T>& values) {
    std::uint64_t count = 0;
    if (!take(&count, sizeof count) || count > m_bytes.size() / sizeof(T)) {
      m_whole = false;
      return;
    }
    values.resize(count);
    take(values.data(), count * sizeof(T));
  }
  [[nodiscard]] bool whole() const { return m_whole && m_bytes.empty(); }

 private:
  bool take(void* to, std::size_t size) {
    if (m_bytes.size() < size) return m_whole = false;
    std::memcpy(to, m_bytes.data(), size);
    m_bytes.remove_prefix(size);
    return true;
  }
  std::string_view m_bytes;
  bool m_whole = true;
};

template <class Stream, class AnyHead>
void eachArray(Stream& stream, AnyHead& head) {
  stream.array(head.model.positions);
  stream.array(head.model.normals);
  stream.array(head.model.tangents);
  stream.array(head.model.uvs);
  stream.array(head.model.indices);
  stream.array(head.model.parts);
  stream.array(head.rest);
  stream.array(head.restNormals);
}

}  // namespace

fs::path headCacheFile(HeadLevel level) {
  const fs::path folder = userCacheFolder("heads");
  if (folder.empty()) return {};
  return folder / fmt::format("{:016x}-{}{}", kHeadSourceHash, static_cast<int>(level), kSuffix);
}

std::optional<Head> readHead(const fs::path& kept) {
  if (kept.empty()) return std::nullopt;
  const fs::path file = cachedFile(kept);
  const Result<std::string> bytes = readFile(file, kMostBytes);
  if (!bytes || bytes->size() < sizeof(Header)) return std::nullopt;
  Header header{};
  std::memcpy(&header, bytes->data(), sizeof header);
  const std::string_view arrays = std::string_view(*bytes).substr(sizeof header);
  if (header.magic != kMagic || header.source != kHeadSourceHash ||
      header.hash != XXH3_64bits(arrays.data(), arrays.size()))
    return std::nullopt;
  Head head;
  std::vector<float> scale;
  Reader reader(arrays);
  eachArray(reader, head);
  reader.array(scale);
  if (!reader.whole() || scale.size() != 1) return std::nullopt;
  head.millimetresPerUv = scale.front();
  describeHead(head.model);
  for (const glm::vec3& p : head.model.positions) head.model.bounds.grow(p);
  // The time of last use, for trimDiskCache().
  std::error_code ignored;
  fs::last_write_time(file, fs::file_time_type::clock::now(), ignored);
  return head;
}

bool writeHead(const fs::path& file, const Head& head) {
  if (file.empty()) return false;
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  if (error) return false;
  std::string bytes(sizeof(Header), '\0');
  Writer writer(bytes);
  eachArray(writer, head);
  writer.array(std::vector<float>{head.millimetresPerUv});
  const Header header = {kMagic, kHeadSourceHash,
                         XXH3_64bits(bytes.data() + sizeof(Header), bytes.size() - sizeof(Header))};
  std::memcpy(bytes.data(), &header, sizeof header);
  const bool written = writeFileAtomically(file, bytes).has_value();
  trimDiskCache(file.parent_path(), kSuffix, kMostBytes);
  return written;
}

}  // namespace dermis
