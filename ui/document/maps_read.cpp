#include "ui/document/maps_read.h"

#include <algorithm>

#include "core/material/parameter_table.h"

namespace dermis {

bool readsMap(ShadingModel model, TextureSlot slot) {
  const auto uses = [model](std::string_view id) {
    const ParameterRow* row = findParameter(id);
    return row != nullptr && row->usedBy(model);
  };
  switch (slot) {
    case TextureSlot::Normal:
      return uses("surface.normal_strength") || model == ShadingModel::Thesis;
    case TextureSlot::DetailNormal:
    case TextureSlot::DetailMask:
      return uses("surface.detail_strength");
    case TextureSlot::Thickness:
      return uses("transmission.weight");
    default:
      break;
  }
  const auto rows = parameterTable();
  return std::any_of(rows.begin(), rows.end(),
                     [&](const ParameterRow& row) { return row.map == slot && row.usedBy(model); });
}

}  // namespace dermis
