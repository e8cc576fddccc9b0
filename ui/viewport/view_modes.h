// The views of the frame, in the order in which a person goes through them: what they are called and what they show.
#pragma once

#include <QString>
#include <vector>

#include "renderer.h"

namespace dermis {

struct ViewMode {
  Aov aov = Aov::Beauty;
  QString label;
  QString help;  ///< one sentence
};

/// All of allAovs(), the picture first.
[[nodiscard]] const std::vector<ViewMode>& viewModes();
[[nodiscard]] const ViewMode& viewMode(Aov aov);
/// `steps` further in the list, round its ends.
[[nodiscard]] Aov nextView(Aov aov, int steps);

}  // namespace dermis
