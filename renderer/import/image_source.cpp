#include "import/image_source.h"

#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>

#include "core/base/file_io.h"
#include "core/base/lower_case.h"
#include "import/jpeg_markers.h"
#include "import/png_chunks.h"
#include "import/text.h"

namespace dermis::import {
namespace {

using namespace std::string_view_literals;

struct Magic {
  std::size_t offset;
  std::string_view bytes;
  const char* format;
};
constexpr std::array kMagics = {
    Magic{0, "\x89PNG\r\n\x1a\n"sv, "png"},
    Magic{0, "\xFF\xD8\xFF"sv, "jpeg"},
    Magic{0, "II*\0"sv, "tiff"},
    Magic{0, "MM\0*"sv, "tiff"},
    Magic{0, "II+\0"sv, "tiff"},
    Magic{0, "MM\0+"sv, "tiff"},
    Magic{0, "\x76\x2f\x31\x01"sv, "openexr"},
    Magic{0, "#?RADIANCE"sv, "hdr"},
    Magic{0, "#?RGBE"sv, "hdr"},
    Magic{0, "BM"sv, "bmp"},
    Magic{0, "GIF8"sv, "gif"},
    Magic{0, "DDS "sv, "dds"},
    Magic{0, "8BPS"sv, "psd"},
    Magic{8, "WEBP"sv, "webp"},
    Magic{4, "jP  "sv, "jpeg2000"},
    Magic{0, "SDPX"sv, "dpx"},
    Magic{0, "XPDS"sv, "dpx"},
    Magic{4, "ftyphei"sv, "heif"},
    Magic{4, "ftypavif"sv, "heif"},
    Magic{4, "ftypmif1"sv, "heif"},
};

struct Extension {
  std::string_view extension;
  const char* format;
};
constexpr std::array kExtensions = {
    Extension{".png", "png"},      Extension{".jpg", "jpeg"},    Extension{".jpeg", "jpeg"},
    Extension{".jpe", "jpeg"},     Extension{".tif", "tiff"},    Extension{".tiff", "tiff"},
    Extension{".tx", "tiff"},      Extension{".exr", "openexr"}, Extension{".hdr", "hdr"},
    Extension{".rgbe", "hdr"},     Extension{".pic", "hdr"},     Extension{".bmp", "bmp"},
    Extension{".tga", "targa"},    Extension{".gif", "gif"},     Extension{".dds", "dds"},
    Extension{".psd", "psd"},      Extension{".webp", "webp"},   Extension{".jp2", "jpeg2000"},
    Extension{".j2k", "jpeg2000"}, Extension{".dpx", "dpx"},     Extension{".cin", "cineon"},
    Extension{".pnm", "pnm"},      Extension{".pbm", "pnm"},     Extension{".pgm", "pnm"},
    Extension{".ppm", "pnm"},      Extension{".pfm", "pnm"},     Extension{".sgi", "sgi"},
    Extension{".rgb", "sgi"},      Extension{".rgba", "sgi"},    Extension{".iff", "iff"},
    Extension{".rla", "rla"},      Extension{".heic", "heif"},   Extension{".heif", "heif"},
    Extension{".avif", "heif"},    Extension{".fits", "fits"},   Extension{".ico", "ico"},
    Extension{".zfile", "zfile"},
};

/// Pixels that one byte of a file may stand for at most, so that a header cannot promise what the file can't hold.
/// Deflate reaches 1032:1, and 1-bit pixels eight times that; an EXR block of 256 rows can shrink to a few bytes.
double mostPixelsAByte(const std::string& format) { return format == "openexr" ? 1e6 : 2e4; }

constexpr double kAlwaysPlausible = 1 << 22;
constexpr std::size_t kLargestPng = std::size_t{2} << 30U;

}  // namespace

std::string imageFormat(std::span<const std::byte> head, const std::string& name) {
  for (const Magic& magic : kMagics)
    if (head.size() >= magic.offset + magic.bytes.size() &&
        std::memcmp(head.data() + magic.offset, magic.bytes.data(), magic.bytes.size()) == 0)
      return magic.format;
  const std::string extension = lowerCase(std::filesystem::path(name).extension().string());
  for (const Extension& row : kExtensions)
    if (row.extension == extension) return row.format;
  return {};
}

Result<ImageSource> ImageSource::open(const std::filesystem::path& path, bool withTexts) {
  ImageSource source;
  source.m_name = path.filename().string();
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status))
    return inputError(fmt::format("{}: there is no such image file", path.string()));
  if (std::filesystem::is_directory(status))
    return inputError(fmt::format("{}: this is a folder, not an image file", path.string()));
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
    return inputError(fmt::format("{}: the image file cannot be read; check its permissions", path.string()));
  std::array<std::byte, 64> head{};
  stream.read(reinterpret_cast<char*>(head.data()), head.size());
  const auto headBytes = static_cast<std::size_t>(stream.gcount());
  source.m_bytes = std::filesystem::file_size(path, error);
  if (error || headBytes == 0)
    return inputError(fmt::format("{}: the image file is empty; export or download it again", source.m_name));

  source.m_format = imageFormat(std::span(head).first(headBytes), source.m_name);
  if (source.m_format == "jpeg" && !jpegIsWhole(path))
    return inputError(
        fmt::format("{}: the JPEG file is cut off before its end mark; export or download it again", source.m_name));
  if (source.m_format == "png") {
    const auto bytes = readFile(path, kLargestPng);
    if (!bytes) return tl::unexpected(bytes.error());
    if (auto started = source.startPng(*bytes, withTexts); !started) return tl::unexpected(started.error());
    return source;
  }
  if (auto started = source.start(path.string(), nullptr); !started) return tl::unexpected(started.error());
  return source;
}

Result<ImageSource> ImageSource::open(std::span<const std::byte> bytes, const std::string& name) {
  ImageSource source;
  source.m_name = name;
  source.m_bytes = bytes.size();
  if (bytes.empty()) return inputError(fmt::format("{}: the image is empty", name));
  source.m_format = imageFormat(bytes, name);
  if (source.m_format == "jpeg" && !jpegIsWhole(bytes))
    return inputError(fmt::format("{}: the JPEG data is cut off before its end mark; export it again", name));

  if (source.m_format == "png") {
    const std::string_view view(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (auto started = source.startPng(view, false); !started) return tl::unexpected(started.error());
    return source;
  }

  source.m_memory = std::make_unique<OIIO::Filesystem::IOMemReader>(const_cast<std::byte*>(bytes.data()), bytes.size());
  const auto probe = source.m_format.empty() ? nullptr : OIIO::ImageInput::create(source.m_format);
  if (probe == nullptr || probe->supports("ioproxy") != 0) {
    if (auto started = source.start(name, source.m_memory.get()); !started) return tl::unexpected(started.error());
    return source;
  }
  // This format's library opens files by name only: an anonymous file has one.
  source.m_anonymousFile = memfd_create("dermis-image", MFD_CLOEXEC);
  std::size_t done = 0;
  while (source.m_anonymousFile >= 0 && done < bytes.size()) {
    const ssize_t count = ::write(source.m_anonymousFile, bytes.data() + done, bytes.size() - done);
    if (count <= 0) break;
    done += static_cast<std::size_t>(count);
  }
  if (done < bytes.size()) return runtimeError(fmt::format("{}: there is no memory left to decode the image", name));
  const std::string path = fmt::format("/proc/self/fd/{}", source.m_anonymousFile);
  if (auto started = source.start(path, nullptr); !started) return tl::unexpected(started.error());
  return source;
}

ImageSource::~ImageSource() {
  if (m_input) m_input->close();
  m_input.reset();  // before the memory it reads
  if (m_anonymousFile >= 0) ::close(m_anonymousFile);
}

std::string ImageSource::lastMessage() const {
  const std::string message = phrase(m_input ? m_input->geterror() : OIIO::geterror());
  return message.empty() ? "the decoder gives no reason" : message;
}

Result<void> ImageSource::startPng(std::string_view bytes, bool withTexts) {
  auto checked = checkedPng(bytes, m_name, withTexts);
  if (!checked) return tl::unexpected(checked.error());
  m_owned = std::make_unique<std::string>(std::move(*checked));
  m_memory = std::make_unique<OIIO::Filesystem::IOMemReader>(m_owned->data(), m_owned->size());
  return start(m_name, m_memory.get());
}

Result<void> ImageSource::start(const std::string& openName, OIIO::Filesystem::IOProxy* proxy) {
  if (!m_format.empty()) m_input = OIIO::ImageInput::create(m_format);
  if (!m_input) {
    static_cast<void>(OIIO::geterror());
    return inputError(
        fmt::format("{}: not a kind of image that can be read; use PNG, JPEG, TIFF, OpenEXR or Radiance HDR", m_name));
  }
  OIIO::ImageSpec hints;
  hints["oiio:UnassociatedAlpha"] = 1;
  if (proxy != nullptr) m_input->set_ioproxy(proxy);
  try {
    if (!m_input->open(openName, m_spec, hints))
      return inputError(
          fmt::format("{}: not readable as {} ({}); export or download it again", m_name, m_format, lastMessage()));
  } catch (const std::exception& error) {
    return inputError(fmt::format("{}: not readable as {} ({}); export or download it again", m_name, m_format,
                                  phrase(error.what())));
  }
  return checkHeader();
}

Result<void> ImageSource::checkHeader() const {
  const int width = std::max(m_spec.width, m_spec.full_width);
  const int height = std::max(m_spec.height, m_spec.full_height);
  if (m_spec.width < 1 || m_spec.height < 1 || m_spec.nchannels < 1)
    return inputError(fmt::format("{}: the image has {} x {} pixels and {} channels, so there is nothing to show",
                                  m_name, m_spec.width, m_spec.height, m_spec.nchannels));
  if (width > kLargestSide || height > kLargestSide)
    return inputError(
        fmt::format("{}: the header says {} x {} pixels, past the limit of {} a side; scale the image down", m_name,
                    width, height, kLargestSide));
  if (m_spec.deep) return inputError(fmt::format("{}: a deep image cannot be shown; flatten it first", m_name));
  if (m_spec.depth > 1) return inputError(fmt::format("{}: a volume is not an image; save one slice of it", m_name));
  if (m_spec.nchannels > 1024)
    return inputError(fmt::format("{}: the header says {} channels, past the limit of 1024", m_name, m_spec.nchannels));
  const double pixels = static_cast<double>(m_spec.width) * m_spec.height;
  if (pixels > kAlwaysPlausible && pixels / static_cast<double>(m_bytes) > mostPixelsAByte(m_format))
    return inputError(
        fmt::format("{}: the header says {} x {} pixels, but the file holds only {} bytes; export or download it again",
                    m_name, m_spec.width, m_spec.height, m_bytes));
  const double tile =
      static_cast<double>(m_spec.tile_width) * m_spec.tile_height * static_cast<double>(m_spec.pixel_bytes(true));
  if (tile > 512e6)
    return inputError(fmt::format("{}: the header says tiles of {} x {} pixels, past the limit", m_name,
                                  m_spec.tile_width, m_spec.tile_height));
  return {};
}

}  // namespace dermis::import
