// Images in and out: every type and format there and back, metadata, odd files, bad files.
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cmath>
#include <cstring>

#include "fixtures.h"

namespace dermis {
namespace {

using namespace fixtures;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Image load(const std::filesystem::path& path, const ImageReadOptions& options = {}, Warnings* warnings = nullptr) {
  Warnings own;
  auto image = module().loadImage(path, options, warnings != nullptr ? *warnings : own);
  if (!image) throw std::runtime_error(image.error().message);
  EXPECT_EQ(brokenPromise(*image), "");
  return std::move(*image);
}

std::string refusal(const std::filesystem::path& path) {
  Warnings warnings;
  const auto image = module().loadImage(path, {}, warnings);
  if (image) return {};
  EXPECT_EQ(image.error().kind, Error::Kind::Input) << image.error().message;
  EXPECT_TRUE(isOneSentence(image.error().message, path.filename().string())) << image.error().message;
  return image.error().message;
}

void write(const std::filesystem::path& path, const std::vector<ImageLayer>& layers,
           const ImageWriteOptions& options = {}) {
  const auto written = module().writeImage(path, layers, options);
  ASSERT_TRUE(written) << written.error().message;
}

/// A file with an unusual header, through OpenImageIO itself.
void writeOdd(const std::filesystem::path& path, const OIIO::ImageSpec& spec, const std::vector<float>& pixels) {
  const auto output = OIIO::ImageOutput::create(path.string());
  ASSERT_TRUE(output);
  ASSERT_TRUE(output->open(path.string(), spec)) << output->geterror();
  ASSERT_TRUE(output->write_image(OIIO::TypeFloat, pixels.data())) << output->geterror();
  ASSERT_TRUE(output->close()) << output->geterror();
}

TEST(Images, LosslessFormatsGiveBackEveryBit) {
  const Folder folder;
  const auto exact = [&](const std::string& name, int channels, PixelType type) {
    const Image image = makeImage(37, 23, channels, type);
    write(folder / name, {layerOf(image)});
    const Image back = load(folder / name);
    EXPECT_EQ(back.width, 37) << name;
    EXPECT_EQ(back.channels, channels) << name;
    EXPECT_EQ(back.type, type) << name;
    EXPECT_EQ(back.pixels, image.pixels) << name << " with " << channels << " channels";
  };
  for (const int channels : {1, 2, 3, 4})
    for (const PixelType type : {PixelType::U8, PixelType::U16}) {
      exact("a.png", channels, type);
      exact("a.tif", channels, type);
    }
  for (const int channels : {1, 3, 4})
    for (const PixelType type : {PixelType::Half, PixelType::Float}) exact("a.exr", channels, type);
}

TEST(Images, JpegIsCloseAndDropsAlpha) {
  const Folder folder;
  Image image = makeImage(64, 64, 4, PixelType::U8);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = static_cast<std::byte>(i / 256);  // smooth
  write(folder / "a.jpg", {layerOf(image)});
  const Image back = load(folder / "a.jpg");
  EXPECT_EQ(back.channels, 3);
  for (int y = 0; y < 64; ++y) EXPECT_NEAR(valueAt(back, 10, y, 0), valueAt(image, 10, y, 0), 0.02F);
}

TEST(Images, FloatsToDisplayFormatsAreClamped) {
  const Folder folder;
  Image image = makeImage(2, 1, 1, PixelType::Float);
  const float values[2] = {-1.0F, 7.0F};
  std::memcpy(image.pixels.data(), values, sizeof(values));
  write(folder / "a.png", {layerOf(image)});
  const Image back = load(folder / "a.png");
  EXPECT_EQ(back.type, PixelType::U16);
  EXPECT_EQ(valueAt(back, 0, 0, 0), 0.0F);
  EXPECT_EQ(valueAt(back, 1, 0, 0), 1.0F);
}

TEST(Images, ExrHoldsLayers) {
  const Folder folder;
  ImageLayer depth{"depth", {"Z"}, makeImage(8, 6, 1, PixelType::Float, 3)};
  write(folder / "layers.exr", {layerOf(makeImage(8, 6, 4, PixelType::Half)),
                                layerOf(makeImage(8, 6, 3, PixelType::Half, 2), "normal"), depth});
  const auto info = module().inspectImage(folder / "layers.exr");
  ASSERT_TRUE(info) << info.error().message;
  EXPECT_THAT(info->channelNames,
              testing::UnorderedElementsAre("R", "G", "B", "A", "normal.R", "normal.G", "normal.B", "depth.Z"));
  Warnings warnings;
  const Image beauty = load(folder / "layers.exr", {.asFloat = true}, &warnings);
  EXPECT_EQ(beauty.channels, 4);
  EXPECT_EQ(warnings.size(), 1U);
  const Image original = makeImage(8, 6, 4, PixelType::Half);
  for (int c = 0; c < 4; ++c) EXPECT_EQ(valueAt(beauty, 3, 2, c), valueAt(original, 3, 2, c));

  const auto input = OIIO::ImageInput::open((folder / "layers.exr").string());
  ASSERT_TRUE(input);
  float primaries[8] = {};
  EXPECT_TRUE(input->spec().getattribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), primaries));
  EXPECT_FLOAT_EQ(primaries[0], 0.64F);
}

TEST(Images, MetadataComesBackFromAllFourFormats) {
  const Folder folder;
  const std::string scene =
      "{\"format\":\"dermis.scene\",\"name\":\"Zo\xc3\xab \\\"x\\\"\"}" + std::string(150'000, ' ') + ".";
  for (const char* name : {"m.png", "m.jpg", "m.tif", "m.exr"}) {
    write(folder / name, {layerOf(makeImage(8, 8, 3, PixelType::U8))},
          {.metadata = {{"dermis", scene}, {"gl", "renderer"}}});
    const auto info = module().inspectImage(folder / name);
    ASSERT_TRUE(info) << info.error().message;
    EXPECT_TRUE(info->metadata.at("dermis") == scene) << name;
    EXPECT_EQ(info->metadata.at("gl"), "renderer") << name;
    EXPECT_EQ(brokenPromise(load(folder / name)), "");
  }
}

TEST(Images, WithoutMetadataTheSamePictureIsTheSameFile) {
  const Folder folder;
  for (const char* name : {"a.png", "a.jpg", "a.tif", "a.exr"}) {
    write(folder / name, {layerOf(makeImage(8, 8, 3, PixelType::U8))});
    const std::string first = bytesOf(folder / name);
    EXPECT_EQ(first.find("OpenImageIO"), std::string::npos) << name;
    write(folder / name, {layerOf(makeImage(8, 8, 3, PixelType::U8))});
    EXPECT_EQ(bytesOf(folder / name), first) << name;
  }
}

TEST(Images, FromMemoryAsFromAFile) {
  const Folder folder;
  for (const char* name : {"a.png", "a.jpg", "a.tif", "a.exr"}) {
    write(folder / name, {layerOf(makeImage(9, 7, 3, PixelType::U8))});
    const std::string bytes = bytesOf(folder / name);
    Warnings warnings;
    const auto image = module().loadImage(std::as_bytes(std::span(bytes)), name, {}, warnings);
    ASSERT_TRUE(image) << image.error().message;
    EXPECT_EQ(image->pixels, load(folder / name).pixels) << name;
  }
}

TEST(Images, KindIsToldByTheBytesNotTheName) {
  const Folder folder;
  const auto path = folder.put("really_a_png.jpg", pngBytes(5, 3));
  EXPECT_EQ(load(path).width, 5);
}

TEST(Images, RadianceHeadersVary) {
  const Folder folder;
  // 8 pixels of old-style, uncompressed RGBE: (128, 64, 32) with exponent 129 is 1, 0.5, 0.25.
  const std::string pixels = [] {
    std::string out;
    for (int i = 0; i < 32; ++i) out += std::string("\x80\x40\x20\x81", 4);
    return out;
  }();
  for (const std::string header :
       {"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n", "#?RADIANCE\n#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n",
        "#?RADIANCE\n# made by hand\nGAMMA=1\nPRIMARIES=0 0 0 0 0 0 0 0\nFORMAT=32-bit_rle_rgbe\n\n"}) {
    const Image image = load(folder.put("odd.hdr", header + "-Y 4 +X 8\n" + pixels), {.asFloat = true});
    EXPECT_EQ(image.width, 8);
    EXPECT_NEAR(valueAt(image, 3, 2, 0), 1.0F, 0.01F);
    EXPECT_NEAR(valueAt(image, 3, 2, 2), 0.25F, 0.01F);
  }
  EXPECT_NE(refusal(folder.put("cut.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 4 +X 8\n" + pixels.substr(0, 50))),
            "");
}

TEST(Images, ExrDataWindowLiesInItsDisplayWindow) {
  const Folder folder;
  OIIO::ImageSpec spec(2, 2, 1, OIIO::TypeFloat);
  spec.x = 1;
  spec.y = 2;
  spec.full_width = 4;
  spec.full_height = 5;
  writeOdd(folder / "inside.exr", spec, {1, 2, 3, 4});
  const Image inside = load(folder / "inside.exr");
  ASSERT_EQ(inside.width, 4);
  ASSERT_EQ(inside.height, 5);
  EXPECT_EQ(valueAt(inside, 0, 0, 0), 0.0F);
  EXPECT_EQ(valueAt(inside, 1, 2, 0), 1.0F);
  EXPECT_EQ(valueAt(inside, 2, 3, 0), 4.0F);
  EXPECT_EQ(valueAt(inside, 3, 4, 0), 0.0F);

  OIIO::ImageSpec wide(4, 4, 1, OIIO::TypeFloat);
  wide.x = wide.y = -1;
  wide.full_width = wide.full_height = 2;
  std::vector<float> pixels(16);
  for (std::size_t i = 0; i < 16; ++i) pixels[i] = static_cast<float>(i);
  writeOdd(folder / "overscan.exr", wide, pixels);
  const Image overscan = load(folder / "overscan.exr");
  ASSERT_EQ(overscan.width, 2);
  EXPECT_EQ(valueAt(overscan, 0, 0, 0), 5.0F);
  EXPECT_EQ(valueAt(overscan, 1, 1, 0), 10.0F);
}

TEST(Images, TiledCompressedAndWideExr) {
  const Folder folder;
  for (const char* compression : {"none", "rle", "zips", "zip", "piz", "dwaa", "dwab"})
    for (const int tile : {0, 32}) {
      OIIO::ImageSpec spec(70, 50, 3, OIIO::TypeFloat);
      spec.tile_width = spec.tile_height = tile;
      spec.attribute("compression", compression);
      writeOdd(folder / "c.exr", spec, std::vector<float>(70 * 50 * 3, 0.5F));
      EXPECT_NEAR(valueAt(load(folder / "c.exr"), 69, 49, 2), 0.5F, 0.01F) << compression;
    }
}

TEST(Images, MoreThanFourChannelsAreCutWithAWarning) {
  const Folder folder;
  OIIO::ImageSpec spec(2, 2, 6, OIIO::TypeUInt8);
  writeOdd(folder / "six.tif", spec, std::vector<float>(24, 1.0F));
  Warnings warnings;
  EXPECT_EQ(load(folder / "six.tif", {}, &warnings).channels, 4);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_THAT(warnings[0], HasSubstr("six.tif"));

  OIIO::ImageSpec depth(2, 2, 4, OIIO::TypeFloat);
  depth.channelnames = {"R", "G", "B", "Z"};
  depth.alpha_channel = -1;
  depth.z_channel = 3;
  writeOdd(folder / "z.exr", depth, std::vector<float>(16, 1.0F));
  EXPECT_EQ(load(folder / "z.exr").channels, 3);
}

TEST(Images, AlphaStaysAsItIsInThePng) {
  const Folder folder;
  Image image = makeImage(1, 1, 4, PixelType::U8);
  const std::uint8_t values[4] = {200, 100, 50, 10};
  std::memcpy(image.pixels.data(), values, 4);
  for (const char* name : {"a.png", "a.tif"}) {
    write(folder / name, {layerOf(image)});
    EXPECT_EQ(load(folder / name).pixels, image.pixels) << name;
  }
}

TEST(Images, LargerThanTheLimitAreAveraged) {
  const Folder folder;
  OIIO::ImageSpec spec(90, 40, 1, OIIO::TypeFloat);
  std::vector<float> pixels(90 * 40);
  double sum = 0.0;
  for (std::size_t i = 0; i < pixels.size(); ++i)
    sum += static_cast<double>(pixels[i] = static_cast<float>(i % 7) + static_cast<float>(i / 90));
  writeOdd(folder / "large.exr", spec, pixels);
  Warnings warnings;
  const Image image = load(folder / "large.exr", {.maximumSize = 32}, &warnings);
  EXPECT_EQ(image.width, 32);
  EXPECT_EQ(image.height, 14);
  double mean = 0.0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) mean += static_cast<double>(valueAt(image, x, y, 0));
  EXPECT_NEAR(mean / (32 * 14), sum / (90 * 40), 1e-3);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_THAT(warnings[0], HasSubstr("90 x 40"));
}

TEST(Images, FortyThousandPixelsASideStayWithinMemory) {
  const Folder folder;
  const auto output = OIIO::ImageOutput::create("png");
  OIIO::ImageSpec spec(40000, 2000, 1, OIIO::TypeUInt8);
  spec.attribute("png:compressionLevel", 1);
  ASSERT_TRUE(output->open((folder / "wide.png").string(), spec));
  const std::vector<std::uint8_t> row(40000, 77);
  for (int y = 0; y < 2000; ++y) ASSERT_TRUE(output->write_scanline(y, 0, OIIO::TypeUInt8, row.data()));
  output->close();
  const Image image = load(folder / "wide.png", {.maximumSize = 4096});
  EXPECT_EQ(image.width, 4096);
  EXPECT_EQ(image.height, 205);
  EXPECT_NEAR(valueAt(image, 4095, 204, 0), 77.0F / 255.0F, 1e-4F);
}

TEST(BadImage, MissingEmptyFolderAndUnknown) {
  const Folder folder;
  EXPECT_NE(refusal(folder / "nowhere.png"), "");
  EXPECT_THAT(refusal(folder.put("empty.png", "")), HasSubstr("empty"));
  std::filesystem::create_directory(folder / "folder.png");
  EXPECT_NE(refusal(folder / "folder.png"), "");
  EXPECT_NE(refusal(folder.put("words.txt", "words")), "");
  for (const char* name :
       {"g.png", "g.jpg", "g.tif", "g.exr", "g.hdr", "g.tga", "g.bmp", "g.gif", "g.webp", "g.psd", "g.dds"})
    EXPECT_NE(refusal(folder.put(name, "garbage that is no picture at all, whatever its name may say")), "") << name;
}

TEST(BadImage, CutOffAnywhere) {
  const Folder folder;
  for (const char* name : {"a.png", "a.jpg", "a.tif", "a.exr"}) {
    write(folder / name, {layerOf(makeImage(40, 40, 3, PixelType::U8))});
    const std::string whole = bytesOf(folder / name);
    for (std::size_t step = 0; step < 30; ++step)
      EXPECT_NE(refusal(folder.put(std::string("cut ") + name, whole.substr(0, whole.size() * step / 30))), "")
          << name << " at " << step << "/30";
  }
}

TEST(BadImage, HeadersThatLieFailBeforeMemoryIsTaken) {
  const Folder folder;
  struct rusage before {};
  getrusage(RUSAGE_SELF, &before);
  // 0 x 4 pixels, and 100,000 x 100,000 in a few bytes.
  std::string png = pngBytes();
  const auto resized = [&](std::uint32_t width, std::uint32_t height) {
    std::string out = png;
    for (std::size_t i = 0; i < 4; ++i) {
      out[16 + i] = static_cast<char>(width >> (24 - 8 * i));
      out[20 + i] = static_cast<char>(height >> (24 - 8 * i));
    }
    std::uint32_t crc = 0xFFFFFFFFU;
    for (std::size_t i = 12; i < 29; ++i) {
      crc ^= static_cast<std::uint8_t>(out[i]);
      for (int k = 0; k < 8; ++k) crc = (crc & 1U) != 0 ? 0xEDB88320U ^ (crc >> 1U) : crc >> 1U;
    }
    crc ^= 0xFFFFFFFFU;
    for (std::size_t i = 0; i < 4; ++i) out[29 + i] = static_cast<char>(crc >> (24 - 8 * i));
    return out;
  };
  EXPECT_THAT(refusal(folder.put("zero.png", resized(0, 4))), HasSubstr("0 x 4"));
  EXPECT_THAT(refusal(folder.put("huge.png", resized(100'000, 100'000))), HasSubstr("100000 x 100000"));
  EXPECT_THAT(refusal(folder.put("past.png", resized(2'000'000'000, 4))), HasSubstr("past the limit"));
  EXPECT_NE(refusal(folder.put("big.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 100000 +X 100000\nxx")), "");
  struct rusage after {};
  getrusage(RUSAGE_SELF, &after);
  EXPECT_LT(after.ru_maxrss - before.ru_maxrss, 200'000);
}

TEST(BadOutput, SaysWhatIsWrongAndLeavesNothing) {
  const Folder folder;
  const std::vector<ImageLayer> picture = {layerOf(makeImage(4, 4, 3, PixelType::U8))};
  const auto refused = [&](const std::filesystem::path& path, const std::vector<ImageLayer>& layers) {
    const auto written = module().writeImage(path, layers, {});
    if (written) return std::string();
    EXPECT_EQ(written.error().kind, Error::Kind::Runtime);
    EXPECT_TRUE(isOneSentence(written.error().message, path.filename().string())) << written.error().message;
    return written.error().message;
  };
  EXPECT_THAT(refused(folder / "a.webp", picture), HasSubstr(".exr"));
  EXPECT_NE(refused(folder / "missing/a.png", picture), "");
  EXPECT_NE(refused(folder / "missing/a.tif", picture), "");
  EXPECT_NE(refused(folder / "a.png", {}), "");
  EXPECT_THAT(refused(folder / "a.png", {picture[0], picture[0]}), HasSubstr("OpenEXR"));
  ImageLayer other = layerOf(makeImage(5, 4, 3, PixelType::U8), "normal");
  EXPECT_NE(refused(folder / "a.exr", {picture[0], other}), "");
  for (const char* name : {"/dev/full/a.png", "/proc/a.exr"}) EXPECT_NE(refused(name, picture), "");
  EXPECT_FALSE(std::filesystem::exists(folder / "a.png"));
  int left = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder / "")) ++left;
  EXPECT_EQ(left, 0);
}

}  // namespace
}  // namespace dermis
