#include "colour/ocio_config.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <mutex>
#include <sstream>

#include "core/base/lower_case.h"
#include "core/base/resources.h"

namespace dermis::ocio {
namespace {

/// The first sentence of what OpenColorIO says, on one line.
std::string reason(const std::exception& exception) {
  std::string text = exception.what();
  std::replace(text.begin(), text.end(), '\n', ' ');
  while (!text.empty() && (text.back() == ' ' || text.back() == '.')) text.pop_back();
  return text;
}

Result<std::shared_ptr<const ActiveConfig>> readConfig(const std::string& path) {
  OCIO::SetLoggingLevel(OCIO::LOGGING_LEVEL_NONE);  // what it has to say comes as exceptions
  auto active = std::make_shared<ActiveConfig>();
  try {
    if (path.empty()) {
      active->own = true;
      active->name = "the built-in OpenColorIO config";
      std::istringstream text{std::string(resource("ocio/config.ocio"))};
      active->config = OCIO::Config::CreateFromStream(text);
    } else {
      active->name = "the OpenColorIO config of $OCIO (" + path + ")";
      active->config = OCIO::Config::CreateFromFile(path.c_str());
      active->config->validate();
    }
  } catch (const std::exception& exception) {
    return inputError(active->name + " can't be used: " + reason(exception) + "; mend it or unset OCIO");
  }
  return active;
}

/// Linear Rec.709 under the names that published configs give it.
std::string rec709Space(const OCIO::ConstConfigRcPtr& config) {
  static constexpr std::array<const char*, 6> kNames = {
      "Linear Rec.709 (sRGB)", "Linear Rec.709", "lin_rec709", "lin_srgb", "Utility - Linear - sRGB", "Linear BT.709"};
  for (const char* name : kNames)
    if (const OCIO::ConstColorSpaceRcPtr space = config->getColorSpace(name)) return space->getName();
  return {};
}

OCIO::BuiltinTransformRcPtr builtin(const char* style, OCIO::TransformDirection direction) {
  OCIO::BuiltinTransformRcPtr transform = OCIO::BuiltinTransform::Create();
  transform->setStyle(style);
  transform->setDirection(direction);
  return transform;
}

OCIO::ColorSpaceTransformRcPtr between(const std::string& source, const std::string& destination) {
  OCIO::ColorSpaceTransformRcPtr transform = OCIO::ColorSpaceTransform::Create();
  transform->setSrc(source.c_str());
  transform->setDst(destination.c_str());
  return transform;
}

}  // namespace

Result<std::shared_ptr<const ActiveConfig>> activeConfig() {
  static std::mutex s_mutex;
  static std::map<std::string, Result<std::shared_ptr<const ActiveConfig>>> s_configs;
  const char* variable = std::getenv("OCIO");
  const std::string path = variable != nullptr ? variable : "";
  const std::lock_guard lock(s_mutex);
  const auto it = s_configs.find(path);
  if (it != s_configs.end() && it->second) return it->second;
  return s_configs.insert_or_assign(path, readConfig(path)).first->second;
}

void appendRec709Transform(const ActiveConfig& active, const std::string& space, OCIO::TransformDirection direction,
                           const OCIO::GroupTransformRcPtr& group, Warnings& warnings) {
  const bool forward = direction == OCIO::TRANSFORM_DIR_FORWARD;
  const auto append = [&](const std::string& linear) {
    group->appendTransform(forward ? between(linear, space) : between(space, linear));
  };
  if (active.own) return append("Linear Rec.709");
  if (active.config->hasRole("aces_interchange")) {
    // Rec.709 → AP1 → AP0, the space that the role stands for.
    const auto toAp1 = builtin("UTILITY - ACES-AP1_to_LINEAR-REC709_BFD",
                               forward ? OCIO::TRANSFORM_DIR_INVERSE : OCIO::TRANSFORM_DIR_FORWARD);
    const auto toAp0 =
        builtin("ACEScg_to_ACES2065-1", forward ? OCIO::TRANSFORM_DIR_FORWARD : OCIO::TRANSFORM_DIR_INVERSE);
    if (forward) {
      group->appendTransform(toAp1);
      group->appendTransform(toAp0);
      append("aces_interchange");
    } else {
      append("aces_interchange");
      group->appendTransform(toAp0);
      group->appendTransform(toAp1);
    }
    return;
  }
  if (const std::string linear = rec709Space(active.config); !linear.empty()) return append(linear);
  warnings.push_back(
      active.name +
      " has no aces_interchange role and no linear Rec.709; its scene_linear is taken to be linear Rec.709");
  append("scene_linear");
}

bool sameName(std::string_view a, std::string_view b) { return lowerCase(a) == lowerCase(b); }

}  // namespace dermis::ocio
