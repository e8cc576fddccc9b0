#include "core/io/udim.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cctype>
#include <cmath>
#include <cstring>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

#include "core/base/lower_case.h"
#include "core/image/image_tiles.h"
#include "core/io/importer.h"

namespace dermis {
namespace {

namespace fs = std::filesystem;

enum class Numbering { Udim, UvTile };

/// Where in a name a tile's number or its token stands.
struct Place {
  std::size_t at = 0, length = 0;
  Numbering numbering = Numbering::Udim;
  int number = 0;  ///< 0 for a token
};

std::string spelled(int number, Numbering numbering) {
  if (numbering == Numbering::Udim) return std::to_string(number);
  const glm::ivec2 square = udimSquare(number);
  return "u" + std::to_string(square.x + 1) + "_v" + std::to_string(square.y + 1);
}

std::optional<Place> tokenIn(const std::string& name) {
  const std::string lower = lowerCase(name);
  for (const std::string_view token : {"<udim>", "%(udim)d", "<uvtile>"})
    if (const std::size_t at = lower.rfind(token); at != std::string::npos)
      return Place{at, token.size(), token == "<uvtile>" ? Numbering::UvTile : Numbering::Udim, 0};
  return std::nullopt;
}

bool isDigit(const std::string& name, std::size_t at) {
  return at < name.size() && std::isdigit(static_cast<unsigned char>(name[at])) != 0;
}

/// The digits from `at`, at most two; 0 where there are none.
int smallNumber(const std::string& name, std::size_t& at) {
  const std::size_t first = at;
  while (at < first + 2 && isDigit(name, at)) ++at;
  return at == first || isDigit(name, at) ? 0 : std::stoi(name.substr(first, at - first));
}

/// Four digits that stand alone after a separator, or u1_v1.
std::optional<Place> numberIn(const std::string& name) {
  for (std::size_t i = name.size(); i-- > 1;) {
    if (std::string_view("._- ").find(name[i - 1]) == std::string_view::npos) continue;
    if (isDigit(name, i) && isDigit(name, i + 1) && isDigit(name, i + 2) && isDigit(name, i + 3) &&
        !isDigit(name, i + 4)) {
      const int number = std::stoi(name.substr(i, 4));
      if (number >= kFirstUdim && number <= kLastUdim) return Place{i, 4, Numbering::Udim, number};
    }
    std::size_t at = i + 1;
    if (name[i] != 'u') continue;
    const int u = smallNumber(name, at);
    if (u < 1 || u > kUdimsPerRow || name.compare(at, 2, "_v") != 0) continue;
    at += 2;
    const int v = smallNumber(name, at);
    if (v < 1) continue;
    if (const auto number = udimNumber({u - 1, v - 1})) return Place{i, at - i, Numbering::UvTile, *number};
  }
  return std::nullopt;
}

fs::path tilePath(const fs::path& path, const Place& place, int number) {
  std::string name = path.filename().string();
  name.replace(place.at, place.length, spelled(number, place.numbering));
  return path.parent_path() / name;
}

bool isFile(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

std::vector<UdimTile> tilesAt(const fs::path& path, const Place& place) {
  std::vector<UdimTile> tiles;
  for (int number = kFirstUdim; number <= kLastUdim; ++number)
    if (fs::path file = tilePath(path, place, number); isFile(file)) tiles.push_back({number, std::move(file)});
  return tiles;
}

/// Grey to colour, alpha filled in with 1, 8 bits to 16; the layout of `like`.
Image converted(const Image& image, const Image& like) {
  Image out = like;
  out.width = image.width;
  out.height = image.height;
  out.tiles.clear();
  out.pixels.resize(out.rowBytes() * static_cast<std::size_t>(image.height));
  const std::size_t size = bytesPerChannel(image.type), outSize = bytesPerChannel(out.type);
  const auto channels = static_cast<std::size_t>(image.channels), outChannels = static_cast<std::size_t>(out.channels);
  const bool alpha = channels % 2 == 0, outAlpha = outChannels % 2 == 0;
  static constexpr std::array<std::uint8_t, 4> kOneHalf = {0x00, 0x3C};
  const float one = 1.0F;
  std::array<std::byte, 4> opaque{};
  opaque.fill(std::byte{255});
  if (out.type == PixelType::Half) std::memcpy(opaque.data(), kOneHalf.data(), 2);
  if (out.type == PixelType::Float) std::memcpy(opaque.data(), &one, sizeof one);
  const std::size_t count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t c = 0; c < outChannels; ++c) {
      std::byte* to = out.pixels.data() + (i * outChannels + c) * outSize;
      const bool isAlpha = outAlpha && c + 1 == outChannels;
      const std::size_t from = isAlpha ? channels - 1 : channels <= 2 ? 0 : c;
      const std::byte* value = isAlpha && !alpha ? opaque.data() : image.pixels.data() + (i * channels + from) * size;
      const bool filled = isAlpha && !alpha;
      for (std::size_t b = 0; b < outSize; ++b) to[b] = value[size == outSize || filled ? b : 0];
    }
  return out;
}

/// What all tiles are read as.
struct Plan {
  int width = 1, height = 1;
  int channels = 1;
  PixelType type = PixelType::U8;
  bool asFloat = false;
};

Result<Plan> planOf(const fs::path& path, const std::vector<UdimTile>& tiles, const Importer& importer,
                    std::size_t mostBytes, Warnings& warnings) {
  Plan plan;
  bool grey = true, alpha = false, halves = false, floats = false, integers = false;
  for (const UdimTile& tile : tiles) {
    const Result<ImageInfo> info = importer.inspectImage(tile.file);
    if (!info) return tl::unexpected(info.error());
    plan.width = std::max(plan.width, info->width);
    plan.height = std::max(plan.height, info->height);
    const int channels = std::min(info->channels, 4);
    grey = grey && channels <= 2;
    alpha = alpha || channels % 2 == 0;
    halves = halves || info->type == PixelType::Half;
    floats = floats || info->type == PixelType::Float;
    integers = integers || info->type == PixelType::U8 || info->type == PixelType::U16;
    if (info->type == PixelType::U16) plan.type = PixelType::U16;
    if (integers && (halves || floats))
      return inputError(tile.file.string() +
                        " has another kind of pixels than the tiles before it; save all tiles of a set as integers or "
                        "all as floats");
  }
  if (halves) plan.type = PixelType::Half;
  if (floats) plan.type = PixelType::Float;
  plan.asFloat = floats && halves;
  plan.channels = (grey ? 1 : 3) + (alpha ? 1 : 0);
  // The limit of a side is the reader's own; the tiles together have one as well.
  const int largest = ImageReadOptions{}.maximumSize;
  int divisor = 1;
  const auto side = [&](int n) { return std::max(1, n / divisor); };
  const auto tooLarge = [&] {
    const double bytes = static_cast<double>(side(plan.width)) * side(plan.height) * plan.channels *
                         static_cast<double>(bytesPerChannel(plan.type)) * static_cast<double>(tiles.size());
    return bytes > static_cast<double>(mostBytes) || side(std::max(plan.width, plan.height)) > largest;
  };
  while (tooLarge() && side(std::max(plan.width, plan.height)) > 1) ++divisor;
  if (divisor > 1) {
    const auto size = [](int w, int h) { return std::to_string(w) + " × " + std::to_string(h); };
    warnings.push_back(path.filename().string() + ": " + std::to_string(tiles.size()) + " tiles of " +
                       size(plan.width, plan.height) + " pixels are more than the limit of " +
                       std::to_string(mostBytes >> 20U) + " MiB; each is read at " +
                       size(side(plan.width), side(plan.height)));
    plan.width = side(plan.width);
    plan.height = side(plan.height);
  }
  return plan;
}

}  // namespace

bool hasUdimToken(const fs::path& path) { return tokenIn(path.filename().string()).has_value(); }

std::optional<fs::path> udimSetOf(const fs::path& tile) {
  std::string name = tile.filename().string();
  const auto place = numberIn(name);
  if (!place) return std::nullopt;
  const bool first = name[place->at - 1] == '.' || isFile(tilePath(tile, *place, kFirstUdim));
  if (!first || tilesAt(tile, *place).size() < 2) return std::nullopt;
  name.replace(place->at, place->length, place->numbering == Numbering::Udim ? "<UDIM>" : "<UVTILE>");
  return tile.parent_path() / name;
}

std::optional<std::string> firstUdimTile(const std::string& path) {
  const auto token = tokenIn(fs::path(path).filename().string());
  if (!token) return std::nullopt;
  return tilePath(path, *token, kFirstUdim).string();
}

std::vector<UdimTile> udimTiles(const fs::path& path) {
  const std::string name = path.filename().string();
  if (const auto token = tokenIn(name)) return tilesAt(path, *token);
  if (!udimSetOf(path)) return {};
  return tilesAt(path, *numberIn(name));
}

Result<Image> readUdimSet(const fs::path& path, const Importer& importer, std::size_t mostBytes, Warnings& warnings,
                          const std::stop_token& stop) {
  const std::vector<UdimTile> tiles = udimTiles(path);
  if (tiles.empty())
    return inputError(path.string() + " is a set of UDIM tiles, and none of them (1001 to 1100) is there");
  const Result<Plan> plan = planOf(path, tiles, importer, mostBytes, warnings);
  if (!plan) return tl::unexpected(plan.error());
  Image set;
  set.name = udimSetOf(path).value_or(path).filename().string();
  set.width = plan->width;
  set.height = plan->height * static_cast<int>(tiles.size());
  set.channels = plan->channels;
  set.type = plan->type;
  const std::size_t tileBytes = set.rowBytes() * static_cast<std::size_t>(plan->height);
  set.pixels.resize(tileBytes * tiles.size());
  for (const UdimTile& tile : tiles) set.tiles.push_back(tile.number);
  Image like = set;
  like.pixels.clear();

  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  std::optional<Error> failed;
  const auto work = [&] {
    for (std::size_t i = next++; i < tiles.size(); i = next++) {
      ImageReadOptions read;
      read.maximumSize = std::max(plan->width, plan->height);
      read.asFloat = plan->asFloat;
      read.tellReduced = false;
      Warnings said;
      Result<Image> image = importer.loadImage(tiles[i].file, read, said, stop);
      const std::lock_guard lock(mutex);
      warnings.insert(warnings.end(), said.begin(), said.end());
      if (!image) {
        if (!failed) failed = image.error();
        return;
      }
      // Only what differs from most tiles is converted, one at a time.
      if (image->channels != like.channels || image->type != like.type) *image = converted(*image, like);
      if (image->width != plan->width || image->height != plan->height)
        *image = resampled(*image, plan->width, plan->height);
      std::memcpy(set.pixels.data() + i * tileBytes, image->pixels.data(), tileBytes);
    }
  };
  {
    const std::size_t most = std::max(1U, std::thread::hardware_concurrency());
    std::vector<std::jthread> workers;
    for (std::size_t i = 1; i < std::min(tiles.size(), most); ++i) workers.emplace_back(work);
    work();
  }
  if (failed) return tl::unexpected(*failed);
  const auto place = tokenIn(path.filename().string());
  if (const Place at = place ? *place : *numberIn(path.filename().string()); at.numbering == Numbering::Udim)
    for (int number = kLastUdim + 1; number < kLastUdim + 100; ++number)
      if (isFile(tilePath(path, at, number))) {
        warnings.push_back(set.name + ": tiles past 1100, such as " + std::to_string(number) +
                           ", are left out; move their squares into the first ten rows");
        break;
      }
  return set;
}

}  // namespace dermis
