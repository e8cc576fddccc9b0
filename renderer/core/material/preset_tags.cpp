#include "core/material/preset_tags.h"

namespace dermis {
namespace {
constexpr const char* kKey = "tags";
}

std::vector<std::string> presetTags(const Material& material) {
  std::vector<std::string> tags;
  const auto list = material.metadata.find(kKey);
  if (list == material.metadata.end() || !list->is_array()) return tags;
  for (const auto& tag : *list)
    if (tag.is_string()) tags.push_back(tag.get<std::string>());
  return tags;
}

void setPresetTags(Material& material, const std::vector<std::string>& tags) {
  if (tags.empty())
    material.metadata.erase(kKey);
  else
    material.metadata[kKey] = tags;
}

}  // namespace dermis
