// A material's maps, decoded.
#pragma once

#include "core/io/asset_loader.h"

namespace dermis {

/// Decodes each map a material names; `embedded:N` from `model` (null: such a map can't be read). Errors: Input (with
/// ResolveOptions::keepMissingMaps a warning), Runtime, Cancelled.
[[nodiscard]] Result<ResolvedMaterial> decodeMaps(const Material& material, const std::shared_ptr<const Model>& model,
                                                  const ResolveOptions& options, Warnings& warnings);

}  // namespace dermis
