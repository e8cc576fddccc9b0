#include "core/bake/bake_cache.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <system_error>

#include "core/base/file_io.h"
#include "core/io/content_hash.h"
#include "core/io/disk_cache.h"

namespace dermis {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSuffix = ".dermismesh";

/// In front of the vertices and the parts. Plain values of one machine's byte order: a cache doesn't travel.
struct Header {
  std::array<char, 8> magic;
  std::uint32_t version, bytesPerVertex;
  std::uint64_t vertices, parts, hash;
};
constexpr std::array<char, 8> kMagic = {'D', 'R', 'M', 'S', 'M', 'S', 'H', '2'};
static_assert(sizeof(VertexBake) == 28 * sizeof(float));

template <class T>
std::uint64_t hashed(const std::vector<T>& values, std::uint64_t seed) {
  return XXH3_64bits_withSeed(values.data(), values.size() * sizeof(T), seed);
}

std::uint64_t hashOf(const MeshBake& bake) { return hashed(bake.solids, hashed(bake.vertices, 0)); }

}  // namespace

fs::path meshBakeFile(const Model& model, const MeshBakeOptions& options) {
  std::uint64_t hash = hashed(model.positions, kMeshBakeVersion);
  hash = hashed(model.normals, hash);
  hash = hashed(model.indices, hash);
  std::vector<std::uint64_t> rest = {static_cast<std::uint64_t>(options.skyRays),
                                     static_cast<std::uint64_t>(options.thicknessRays), options.mostPoints};
  for (const ModelPart& part : model.parts) {
    const bool casts = part.slot >= options.castingSlots.size() || options.castingSlots[part.slot];
    rest.insert(rest.end(), {part.firstIndex, part.indexCount, casts ? 1U : 0U});
  }
  hash = hashed(rest, hash);
  hash = XXH3_64bits_withSeed(&options.millimetresPerUnit, sizeof options.millimetresPerUnit, hash);
  return options.cacheFolder / (hexadecimal(hash) + kSuffix);
}

std::optional<MeshBake> readMeshBake(const fs::path& kept, const Model& model) {
  const fs::path file = cachedFile(kept);
  std::ifstream stream(file, std::ios::binary);
  Header header{};
  if (!stream.read(reinterpret_cast<char*>(&header), sizeof header)) return std::nullopt;
  if (header.magic != kMagic || header.version != kMeshBakeVersion || header.bytesPerVertex != sizeof(VertexBake) ||
      header.vertices != model.positions.size() || header.parts != model.parts.size())
    return std::nullopt;
  MeshBake bake;
  bake.vertices.resize(model.positions.size());
  bake.solids.resize(model.parts.size());
  const auto bytes = static_cast<std::streamsize>(bake.vertices.size() * sizeof(VertexBake));
  if (!stream.read(reinterpret_cast<char*>(bake.vertices.data()), bytes) ||
      !stream.read(reinterpret_cast<char*>(bake.solids.data()), static_cast<std::streamsize>(bake.solids.size())) ||
      stream.peek() != EOF)
    return std::nullopt;
  if (hashOf(bake) != header.hash) return std::nullopt;
  // The time of last use, for trimDiskCache().
  std::error_code ignored;
  fs::last_write_time(file, fs::file_time_type::clock::now(), ignored);
  return bake;
}

bool writeMeshBake(const fs::path& file, const MeshBake& bake) {
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  if (error) return false;
  const Header header = {kMagic,      kMeshBakeVersion, sizeof(VertexBake), bake.vertices.size(), bake.solids.size(),
                         hashOf(bake)};
  const Result<void> written = replaceFileAtomically(file, [&](const fs::path& temporary) -> Result<void> {
    std::ofstream stream(temporary, std::ios::binary);
    stream.write(reinterpret_cast<const char*>(&header), sizeof header);
    stream.write(reinterpret_cast<const char*>(bake.vertices.data()),
                 static_cast<std::streamsize>(bake.vertices.size() * sizeof(VertexBake)));
    stream.write(reinterpret_cast<const char*>(bake.solids.data()), static_cast<std::streamsize>(bake.solids.size()));
    stream.close();
    if (!stream) return runtimeError("the cache file can't be written");
    return {};
  });
  trimDiskCache(file.parent_path(), kSuffix, kMeshBakeCacheBytes);
  return written.has_value();
}

}  // namespace dermis
