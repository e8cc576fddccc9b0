// Files of a set of UDIM tiles (core/image/image_tiles.h): how they are named, which there are, and all of them read.
//
// A set is written with a token in the place of the number: "skin.<UDIM>.exr" (also "<udim>" and "%(UDIM)d") for
// skin.1001.exr, "skin_<UVTILE>.exr" for Mudbox's skin_u1_v1.exr. The name of one tile stands for its set wherever
// other tiles lie beside it.
#pragma once

#include <filesystem>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/base/result.h"
#include "core/image/image.h"

namespace dermis {

class Importer;

struct UdimTile {
  int number = 1001;
  std::filesystem::path file;
};

/// Whether a path has one of the tokens in its name.
[[nodiscard]] bool hasUdimToken(const std::filesystem::path& path);

/// "skin.1012.exr" → "skin.<UDIM>.exr", where at least one other tile lies beside it (and, where no dot stands before
/// the number, the first: photographs are numbered as well); nothing for all other files.
[[nodiscard]] std::optional<std::filesystem::path> udimSetOf(const std::filesystem::path& tile);

/// The path of tile 1001 of a set that is written with a token; nothing for other files.
[[nodiscard]] std::optional<std::string> firstUdimTile(const std::string& path);

/// A set's tiles on disk, 1001 to 1100, by number; `path` has a token or is one tile of a set. Empty for other files.
[[nodiscard]] std::vector<UdimTile> udimTiles(const std::filesystem::path& path);

/// Bytes of a set's pixels past which its tiles are read smaller.
inline constexpr std::size_t kMostUdimBytes = std::size_t{2} << 30U;

/// The tiles as one image, decoded on several threads. Smaller tiles are enlarged to the size of the largest, grey and
/// missing alpha are filled in, 8-bit tiles among 16-bit ones are widened. What is past `mostBytes` or 1100 is said in
/// a sentence. Errors: Input (no tile; integers beside floats; a tile that can't be read, named), Cancelled.
[[nodiscard]] Result<Image> readUdimSet(const std::filesystem::path& path, const Importer& importer,
                                        std::size_t mostBytes, Warnings& warnings, const std::stop_token& stop);

}  // namespace dermis
