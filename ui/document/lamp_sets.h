// Sets of lamps that photographers know by name, sized for whatever model stands there.
#pragma once

#include <QString>
#include <vector>

#include "core/scene/model.h"
#include "core/scene/scene.h"

namespace dermis {

class Document;

struct LampSet {
  const char* id;     ///< "three-point"
  const char* label;  ///< to be translated
  const char* help;
};
[[nodiscard]] const std::vector<LampSet>& lampSets();
/// The lamps of a set round the bounds; empty for an unknown id.
[[nodiscard]] std::vector<Light> lampsOf(const QString& id, const Bounds& bounds, float millimetresPerUnit);
/// Puts them in the place of all lamps, as one undo entry.
void useLampSet(Document& document, const QString& id);

}  // namespace dermis
