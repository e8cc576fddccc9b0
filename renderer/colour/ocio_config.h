// The active OpenColorIO config: $OCIO where it is set, else the one that we ship. Private to renderer/colour.
#pragma once

#include <OpenColorIO/OpenColorIO.h>

#include <memory>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace dermis::ocio {

namespace OCIO = OCIO_NAMESPACE;

struct ActiveConfig {
  OCIO::ConstConfigRcPtr config;
  bool own = false;  ///< the embedded one
  std::string name;  ///< for messages: "$OCIO (studio.ocio)" or "the built-in config"
};

/// Read once for each value of $OCIO; thread-safe. Errors: Input, a broken $OCIO.
[[nodiscard]] Result<std::shared_ptr<const ActiveConfig>> activeConfig();

/// Appends what takes linear Rec.709 to a colour space of the config (forward) or back (inverse): by the config's
/// aces_interchange role; else by a colour space of a name that means linear Rec.709; else, as a last resort and with
/// a warning, scene_linear is taken to be linear Rec.709.
void appendRec709Transform(const ActiveConfig& active, const std::string& space, OCIO::TransformDirection direction,
                           const OCIO::GroupTransformRcPtr& group, Warnings& warnings);

/// Equal but for upper and lower case (ASCII).
[[nodiscard]] bool sameName(std::string_view a, std::string_view b);

}  // namespace dermis::ocio
