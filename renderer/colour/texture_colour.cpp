#include "colour/display_transform.h"
#include "colour/ocio_config.h"

namespace dermis {
namespace {

namespace OCIO = OCIO_NAMESPACE;
using ocio::sameName;

/// The name of a colour space or role of the config, whatever its case; empty where there is none.
std::string findColourSpace(const OCIO::ConstConfigRcPtr& config, const std::string& wanted) {
  if (const OCIO::ConstColorSpaceRcPtr space = config->getColorSpace(wanted.c_str())) return space->getName();
  for (int i = 0; i < config->getNumColorSpaces(); ++i)
    if (sameName(config->getColorSpaceNameByIndex(i), wanted)) return config->getColorSpaceNameByIndex(i);
  return {};
}

}  // namespace

void TextureColour::convert(float* rgba, std::size_t count) const {
  if (processor == nullptr) return;
  OCIO::PackedImageDesc image(rgba, static_cast<long>(count), 1, 4);
  static_cast<const OCIO::CPUProcessor*>(processor.get())->apply(image);
}

Result<TextureColour> textureColour(std::string_view colorSpace, bool isColourSlot, bool isFloat, Warnings& warnings) {
  TextureColour colour;
  colour.decode = isColourSlot && !isFloat ? TextureColour::Decode::Srgb : TextureColour::Decode::Linear;
  if (colorSpace.empty()) return colour;
  if (sameName(colorSpace, "srgb")) {
    colour.decode = TextureColour::Decode::Srgb;
    return colour;
  }
  if (sameName(colorSpace, "linear") || sameName(colorSpace, "raw")) {
    colour.decode = TextureColour::Decode::Linear;
    return colour;
  }
  const auto active = ocio::activeConfig();
  if (!active) return tl::unexpected(active.error());
  const OCIO::ConstConfigRcPtr& config = (*active)->config;
  const std::string space = findColourSpace(config, std::string(colorSpace));
  if (space.empty()) {
    warnings.push_back((*active)->name + " has no colour space \"" + std::string(colorSpace) +
                       "\"; the map is read as " + (colour.decode == TextureColour::Decode::Srgb ? "sRGB" : "linear"));
    return colour;
  }
  if (config->getColorSpace(space.c_str())->isData()) {
    colour.decode = TextureColour::Decode::Linear;
    return colour;
  }
  try {
    const OCIO::GroupTransformRcPtr group = OCIO::GroupTransform::Create();
    ocio::appendRec709Transform(**active, space, OCIO::TRANSFORM_DIR_INVERSE, group, warnings);
    const OCIO::ConstCPUProcessorRcPtr cpu = config->getProcessor(group)->getDefaultCPUProcessor();
    colour.decode = TextureColour::Decode::Convert;
    colour.processor = cpu;
  } catch (const std::exception& exception) {
    return inputError((*active)->name + " can't convert the colour space \"" + space + "\": " + exception.what());
  }
  return colour;
}

}  // namespace dermis
