// Words under which a preset is found: "tags" of its metadata.
#pragma once

#include <string>
#include <vector>

#include "core/material/material.h"

namespace dermis {

/// In their order; empty where there are none, or where what stands there is no list of texts.
[[nodiscard]] std::vector<std::string> presetTags(const Material& material);
void setPresetTags(Material& material, const std::vector<std::string>& tags);

}  // namespace dermis
