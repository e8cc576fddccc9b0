#include "colour/display_transform.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <mutex>
#include <optional>
#include <span>

#include "colour/ocio_config.h"
#include "colour/simple_curves.h"
#include "core/builtin/image_cache.h"
#include "renderer.h"

namespace dermis {
namespace {

namespace OCIO = OCIO_NAMESPACE;
using ocio::ActiveConfig;
using ocio::sameName;

// The baked LUT's shaper, t = log2(x / kToe + 1) / log2(kPeak / kToe + 1) for each channel: nearly linear below the
// toe, where the sRGB curve is, and logarithmic up to where ACES has long reached white. Chosen by measuring
// (tests/gpu/colour_test.cpp).
constexpr int kLutEdge = 64;
constexpr float kToe = 0.01F;
constexpr float kPeak = 32.0F;

float shaped(float t) { return kToe * (std::exp2(t * std::log2(kPeak / kToe + 1.0F)) - 1.0F); }

class CurveTransform final : public DisplayTransform {
 public:
  CurveTransform(std::string display, const SimpleCurve& curve)
      : m_display(std::move(display)), m_view(curve.name), m_curve(curve) {
    m_program.glsl =
        "float displayCurve(float c) { " + std::string(curve.glsl) +
        " }\n"
        "vec4 displayExact(vec4 scene) {\n"
        "  return vec4(displayCurve(scene.r), displayCurve(scene.g), displayCurve(scene.b), scene.a);\n}\n";
  }
  const std::string& display() const override { return m_display; }
  const std::string& view() const override { return m_view; }
  bool isRaw() const override { return m_view == "Raw"; }
  bool isSimple() const override { return true; }
  const DisplayProgram& exactProgram() const override { return m_program; }
  const DisplayLut& lut() const override {
    static const DisplayLut kEmpty;
    return kEmpty;
  }
  void apply(float* rgba, std::size_t count) const override {
    for (std::size_t i = 0; i < 4 * count; ++i)
      if (i % 4 != 3) rgba[i] = m_curve.apply(rgba[i]);
  }

 private:
  std::string m_display, m_view;
  const SimpleCurve& m_curve;
  DisplayProgram m_program;
};

void addTexture1D2D(const OCIO::GpuShaderDescRcPtr& description, unsigned index, DisplayProgram& program) {
  const char* textureName = nullptr;
  const char* samplerName = nullptr;
  unsigned width = 0, height = 0;
  OCIO::GpuShaderDesc::TextureType channels = OCIO::GpuShaderDesc::TEXTURE_RGB_CHANNEL;
  OCIO::Interpolation interpolation = OCIO::INTERP_LINEAR;
  description->getTexture(index, textureName, samplerName, width, height, channels, interpolation);
  const float* values = nullptr;
  description->getTextureValues(index, values);

  DisplayTexture texture;
  texture.samplerName = samplerName;
  texture.dimensions = program.glsl.find("sampler1D " + texture.samplerName) != std::string::npos ? 1 : 2;
  texture.width = static_cast<int>(width);
  texture.height = static_cast<int>(height);
  texture.channels = channels == OCIO::GpuShaderDesc::TEXTURE_RED_CHANNEL ? 1 : 3;
  texture.nearest = interpolation == OCIO::INTERP_NEAREST;
  texture.values.assign(values, values + std::size_t{width} * height * static_cast<std::size_t>(texture.channels));
  program.textures.push_back(std::move(texture));
}

void addTexture3D(const OCIO::GpuShaderDescRcPtr& description, unsigned index, DisplayProgram& program) {
  const char* textureName = nullptr;
  const char* samplerName = nullptr;
  unsigned edge = 0;
  OCIO::Interpolation interpolation = OCIO::INTERP_LINEAR;
  description->get3DTexture(index, textureName, samplerName, edge, interpolation);
  const float* values = nullptr;
  description->get3DTextureValues(index, values);

  DisplayTexture texture;
  texture.samplerName = samplerName;
  texture.dimensions = 3;
  texture.width = texture.height = texture.depth = static_cast<int>(edge);
  // Tetrahedral interpolation fetches the corners itself.
  texture.nearest = interpolation == OCIO::INTERP_NEAREST || interpolation == OCIO::INTERP_TETRAHEDRAL;
  texture.values.assign(values, values + std::size_t{3} * edge * edge * edge);
  program.textures.push_back(std::move(texture));
}

class OcioTransform final : public DisplayTransform {
 public:
  OcioTransform(std::string display, std::string view, OCIO::ConstProcessorRcPtr processor)
      : m_display(std::move(display)),
        m_view(std::move(view)),
        m_processor(std::move(processor)),
        m_cpu(m_processor->getDefaultCPUProcessor()) {}

  const std::string& display() const override { return m_display; }
  const std::string& view() const override { return m_view; }
  bool isRaw() const override { return false; }
  bool isSimple() const override { return false; }

  const DisplayProgram& exactProgram() const override {
    std::call_once(m_programOnce, [this] {
      OCIO::GpuShaderDescRcPtr description = OCIO::GpuShaderDesc::CreateShaderDesc();
      description->setLanguage(OCIO::GPU_LANGUAGE_GLSL_4_0);
      description->setFunctionName("displayExact");
      description->setResourcePrefix("display_");
      m_processor->getDefaultGPUProcessor()->extractGpuShaderInfo(description);
      m_program.glsl = description->getShaderText();
      for (unsigned i = 0; i < description->getNumTextures(); ++i) addTexture1D2D(description, i, m_program);
      for (unsigned i = 0; i < description->getNum3DTextures(); ++i) addTexture3D(description, i, m_program);
    });
    return m_program;
  }

  const DisplayLut& lut() const override {
    std::call_once(m_lutOnce, [this] { prepareLut(); });
    return m_lut;
  }

  void apply(float* rgba, std::size_t count) const override {
    OCIO::PackedImageDesc image(rgba, static_cast<long>(count), 1, 4);
    m_cpu->apply(image);
  }

 private:
  /// Baked, or what an earlier program baked of the same operations.
  void prepareLut() const {
    // Named by all that the numbers come from; raise the version where the way they are made changes.
    constexpr std::uint64_t kVersion = 1;
    const ImageKey key{
        kVersion, fmt::format("view {} {} {} {} {}", OCIO::GetVersion(), m_cpu->getCacheID(), kLutEdge, kToe, kPeak)};
    std::optional<Image> kept = readCachedImage(key, m_view);
    const bool isWhole = kept && kept->width == kLutEdge && kept->height == kLutEdge * kLutEdge &&
                         kept->channels == 3 && kept->type == PixelType::Float;
    if (!isWhole) {
      kept = bakedLut();
      writeCachedImage(key, *kept);
    }
    m_lut.edge = kLutEdge;
    m_lut.rgb.resize(kept->pixels.size() / sizeof(float));
    std::memcpy(m_lut.rgb.data(), kept->pixels.data(), kept->pixels.size());
  }

  [[nodiscard]] Image bakedLut() const {
    constexpr auto kEdge = static_cast<std::size_t>(kLutEdge);
    std::vector<float> axis(kEdge);
    for (std::size_t i = 0; i < kEdge; ++i) axis[i] = shaped(static_cast<float>(i) / static_cast<float>(kEdge - 1));
    std::vector<float> rgb;
    rgb.reserve(3 * kEdge * kEdge * kEdge);
    for (const float blue : axis)
      for (const float green : axis)
        for (const float red : axis) rgb.insert(rgb.end(), {red, green, blue});
    OCIO::PackedImageDesc packed(rgb.data(), static_cast<long>(kEdge * kEdge * kEdge), 1, 3);
    m_cpu->apply(packed);
    Image image;
    image.width = kLutEdge;
    image.height = kLutEdge * kLutEdge;
    image.channels = 3;
    image.type = PixelType::Float;
    const auto bytes = std::as_bytes(std::span(rgb));
    image.pixels.assign(bytes);
    return image;
  }

  std::string m_display, m_view;
  OCIO::ConstProcessorRcPtr m_processor;
  OCIO::ConstCPUProcessorRcPtr m_cpu;
  mutable std::once_flag m_programOnce, m_lutOnce;
  mutable DisplayProgram m_program;
  mutable DisplayLut m_lut;
};

/// The config's display of that name, its default one where it has none (with a warning).
std::string findDisplay(const ActiveConfig& active, std::string_view wanted, Warnings& warnings) {
  for (int i = 0; i < active.config->getNumDisplays(); ++i)
    if (sameName(active.config->getDisplay(i), wanted)) return active.config->getDisplay(i);
  std::string fallback = active.config->getDefaultDisplay();
  if (!wanted.empty())
    warnings.push_back(active.name + " has no display \"" + std::string(wanted) + "\"; \"" + fallback + "\" is used");
  return fallback;
}

std::optional<std::string> findView(const ActiveConfig& active, const std::string& display, std::string_view wanted) {
  for (int i = 0; i < active.config->getNumViews(display.c_str()); ++i) {
    const std::string name = active.config->getView(display.c_str(), i);
    if (sameName(name, wanted)) return name;
  }
  return std::nullopt;
}

}  // namespace

Result<std::shared_ptr<const DisplayTransform>> DisplayTransform::create(std::string_view display,
                                                                         std::string_view view, Warnings& warnings) {
  const auto active = ocio::activeConfig();
  if (!active) return tl::unexpected(active.error());
  const std::string foundDisplay = findDisplay(**active, display, warnings);
  for (const SimpleCurve& curve : kSimpleCurves)
    if (sameName(curve.name, view) && (curve.name != "sRGB" || (*active)->own))
      return std::make_shared<const CurveTransform>(foundDisplay, curve);

  std::optional<std::string> foundView = findView(**active, foundDisplay, view);
  if (!foundView) {
    foundView = (*active)->config->getDefaultView(foundDisplay.c_str());
    warnings.push_back((*active)->name + " has no view \"" + std::string(view) + "\" for the display \"" +
                       foundDisplay + "\"; its default view \"" + *foundView + "\" is used");
  }
  try {
    const OCIO::GroupTransformRcPtr group = OCIO::GroupTransform::Create();
    ocio::appendRec709Transform(**active, "scene_linear", OCIO::TRANSFORM_DIR_FORWARD, group, warnings);
    const OCIO::DisplayViewTransformRcPtr toDisplay = OCIO::DisplayViewTransform::Create();
    toDisplay->setSrc("scene_linear");
    toDisplay->setDisplay(foundDisplay.c_str());
    toDisplay->setView(foundView->c_str());
    group->appendTransform(toDisplay);
    return std::make_shared<const OcioTransform>(foundDisplay, *foundView, (*active)->config->getProcessor(group));
  } catch (const std::exception& exception) {
    return inputError((*active)->name + " can't make the view \"" + *foundView + "\": " + exception.what());
  }
}

std::string displayBakedGlsl(unsigned unit) {
  return fmt::format(R"(layout(binding = {}) uniform sampler3D u_display_lut;
vec3 displayBaked(vec3 scene) {{
  vec3 t = clamp(log2(max(scene, 0.0) * {:.9g} + 1.0) * {:.9g}, 0.0, 1.0);
  float edge = float(textureSize(u_display_lut, 0).x);
  return textureLod(u_display_lut, (t * (edge - 1.0) + 0.5) / edge, 0.0).rgb;
}}
)",
                     unit, 1.0F / kToe, 1.0F / std::log2(kPeak / kToe + 1.0F));
}

Result<DisplayViews> displayViews() {
  const auto active = ocio::activeConfig();
  if (!active) return tl::unexpected(active.error());
  const OCIO::ConstConfigRcPtr& config = (*active)->config;
  DisplayViews result;
  for (int i = 0; i < config->getNumDisplays(); ++i) result.displays.emplace_back(config->getDisplay(i));
  result.defaultDisplay = config->getDefaultDisplay();
  result.defaultView = config->getDefaultView(result.defaultDisplay.c_str());
  const auto add = [&](const std::string& view) {
    const auto same = [&](const std::string& known) { return sameName(known, view); };
    if (std::none_of(result.views.begin(), result.views.end(), same)) result.views.push_back(view);
  };
  for (const std::string& display : result.displays)
    for (int i = 0; i < config->getNumViews(display.c_str()); ++i) add(config->getView(display.c_str(), i));
  for (const char* always : {"Raw", "Thesis", "Gamma 2.2"}) add(always);
  return result;
}

}  // namespace dermis
