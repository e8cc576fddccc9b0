#include "lighting/environment_cache.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <system_error>
#include <vector>

#include "core/base/file_io.h"
#include "core/base/mapped_file.h"
#include "core/io/disk_cache.h"
#include "lighting/sharp_cube.h"

namespace dermis {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSuffix = ".dermisenv";

struct CubeShape {
  std::int32_t faceSize, layers, levels, storage;  ///< storage: TexelStorage
  std::uint64_t bytes;
};

/// In front of the texels. Plain values of one machine's byte order: a cache doesn't travel.
struct Header {
  std::array<char, 8> magic;
  std::uint32_t version;
  float scale;
  std::uint64_t negative, nonFinite;
  std::array<CubeShape, 3> cubes;
  std::uint64_t texelHash;   ///< XXH3 of all texels
  std::uint64_t headerHash;  ///< XXH3 of what stands before
};
static_assert(std::has_unique_object_representations_v<CubeShape>);

constexpr std::array<char, 8> kMagic = {'D', 'R', 'M', 'S', 'E', 'N', 'V', '1'};

std::uint64_t headerHash(const Header& header) { return XXH3_64bits(&header, offsetof(Header, headerHash)); }

/// Bytes that a cube of this shape holds; 0 for an impossible shape.
std::uint64_t expectedBytes(const CubeShape& shape) {
  if (shape.faceSize < 1 || shape.faceSize > 16384 || shape.layers < 1 || shape.layers > 64 || shape.levels < 1 ||
      shape.levels > 15 || shape.storage < 0 || shape.storage > static_cast<int>(TexelStorage::SharedExponent)) {
    return 0;
  }
  std::uint64_t texels = 0;
  for (int l = 0; l < shape.levels; ++l) {
    const auto n = static_cast<std::uint64_t>(std::max(1, shape.faceSize >> l));
    texels += n * n * 6U * static_cast<std::uint64_t>(shape.layers);
  }
  return texels * bytesPerTexel(static_cast<TexelStorage>(shape.storage));
}

}  // namespace

fs::path environmentCacheFile(const EnvironmentBakeOptions& options, const EnvironmentImages& images) {
  // The size of the images guards against a hash of bytes that were decoded differently.
  const Image* image = images.latLong ? images.latLong.get() : images.faces[0].get();
  const int perFace = image == nullptr ? 1 : std::max(1, images.latLong ? image->width / 4 : image->width);
  return options.cacheFolder / fmt::format("{:016x}-{}x{}-{}-v{}{}", images.contentHash, image ? image->width : 0,
                                           image ? image->height : 0, sharpFaceSize(perFace, options.maximumSharpFace),
                                           kEnvironmentBakeVersion, kSuffix);
}

std::shared_ptr<BakedEnvironment> readEnvironmentCache(const EnvironmentBakeOptions& options,
                                                       const EnvironmentImages& images) {
  const fs::path path = cachedFile(environmentCacheFile(options, images));
  auto mapping = std::make_shared<const MappedFile>(path);
  const auto bytes = mapping->bytes();
  Header header{};
  if (bytes.size() < sizeof header) return nullptr;
  std::memcpy(&header, bytes.data(), sizeof header);
  if (header.magic != kMagic || header.version != kEnvironmentBakeVersion || header.headerHash != headerHash(header)) {
    return nullptr;
  }
  std::uint64_t payload = 0;
  for (const CubeShape& shape : header.cubes) {
    if (shape.bytes == 0 || shape.bytes != expectedBytes(shape)) return nullptr;
    payload += shape.bytes;
  }
  if (bytes.size() != sizeof header + payload) return nullptr;
  if (XXH3_64bits(bytes.data() + sizeof header, payload) != header.texelHash) return nullptr;

  auto baked = std::make_shared<BakedEnvironment>();
  std::size_t offset = sizeof header;
  const auto cube = [&](const CubeShape& shape) {
    const CubeTexels texels{shape.faceSize, shape.layers, shape.levels, static_cast<TexelStorage>(shape.storage),
                            bytes.subspan(offset, static_cast<std::size_t>(shape.bytes))};
    offset += static_cast<std::size_t>(shape.bytes);
    return texels;
  };
  baked->sharp = cube(header.cubes[0]);
  baked->prefiltered = cube(header.cubes[1]);
  baked->irradiance = cube(header.cubes[2]);
  baked->scale = header.scale;
  baked->figures.cleaned = {static_cast<std::size_t>(header.negative), static_cast<std::size_t>(header.nonFinite)};
  baked->figures.sharpFaceSize = baked->sharp.faceSize;
  baked->figures.prefilteredFaceSize = baked->prefiltered.faceSize;
  baked->figures.irradianceFaceSize = baked->irradiance.faceSize;
  baked->figures.floatStorage = baked->sharp.storage == TexelStorage::Float;
  baked->figures.fromCache = true;
  baked->storage = std::move(mapping);
  // The time of last use, for trimDiskCache().
  std::error_code ignored;
  fs::last_write_time(path, fs::file_time_type::clock::now(), ignored);
  return baked;
}

bool writeEnvironmentCache(const EnvironmentBakeOptions& options, const EnvironmentImages& images,
                           const BakedEnvironment& baked) {
  std::error_code error;
  fs::create_directories(options.cacheFolder, error);
  if (error) return false;
  Header header{};
  header.magic = kMagic;
  header.version = kEnvironmentBakeVersion;
  header.scale = baked.scale;
  header.negative = baked.figures.cleaned.negative;
  header.nonFinite = baked.figures.cleaned.nonFinite;
  const std::array cubes = {&baked.sharp, &baked.prefiltered, &baked.irradiance};
  std::size_t payload = 0;
  for (std::size_t i = 0; i < cubes.size(); ++i) {
    header.cubes[i] = {cubes[i]->faceSize, cubes[i]->layers, cubes[i]->levels, static_cast<int>(cubes[i]->storage),
                       cubes[i]->bytes.size()};
    payload += cubes[i]->bytes.size();
  }
  // The three follow one another in memory, see pack() in environment_bake.cpp.
  const std::byte* texels = baked.sharp.bytes.data();
  header.texelHash = XXH3_64bits(texels, payload);
  header.headerHash = headerHash(header);

  const auto written =
      replaceFileAtomically(environmentCacheFile(options, images), [&](const fs::path& temporary) -> Result<void> {
        std::FILE* file = std::fopen(temporary.c_str(), "wb");
        if (file == nullptr) return runtimeError("the cache file can't be opened");
        const bool complete =
            std::fwrite(&header, sizeof header, 1, file) == 1 && std::fwrite(texels, 1, payload, file) == payload;
        if (std::fclose(file) != 0 || !complete) return runtimeError("the cache file can't be written");
        return {};
      });
  trimDiskCache(options.cacheFolder, kSuffix, kEnvironmentCacheBytes);
  return written.has_value();
}

}  // namespace dermis
