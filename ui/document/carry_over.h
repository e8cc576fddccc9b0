// What is kept when another model takes the place of the one that is open.
#pragma once

#include "ui/document/sections.h"

namespace dermis {

/// Slots of the same name keep their look (also those that an earlier model had); the others wear `imported`, parallel
/// to model->slots. Lights and camera are carried over by the ratio s of the bounds' radii: positions × s about the
/// centres, intensities × s².
[[nodiscard]] WholeLook carryOver(const WholeLook& before, const ModelSource& source,
                                  std::shared_ptr<const Model> model, std::vector<ResolvedMaterial> imported);

}  // namespace dermis
