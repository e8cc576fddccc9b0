#include "ui/viewport/view_modes.h"

#include <QCoreApplication>
#include <algorithm>
#include <string_view>

namespace dermis {
namespace {

struct Row {
  std::string_view name;  // toString(Aov)
  const char* label;
  const char* help;
};

// In the order of the menu.
constexpr Row kRows[] = {
    {"beauty", QT_TRANSLATE_NOOP("views", "Final picture"),
     QT_TRANSLATE_NOOP("views", "All light together, through the view transform")},
    {"diffuse", QT_TRANSLATE_NOOP("views", "Diffuse before diffusion"),
     QT_TRANSLATE_NOOP("views", "The body's light as if it left where it entered")},
    {"diffuse_scattered", QT_TRANSLATE_NOOP("views", "Diffuse after diffusion"),
     QT_TRANSLATE_NOOP("views", "The body's light after it has spread under the surface")},
    {"specular", QT_TRANSLATE_NOOP("views", "Specular"),
     QT_TRANSLATE_NOOP("views", "Light reflected at the surface, and emission")},
    {"transmission", QT_TRANSLATE_NOOP("views", "Transmission"),
     QT_TRANSLATE_NOOP("views", "Light that comes through from the far side")},
    {"thickness", QT_TRANSLATE_NOOP("views", "Thickness"),
     QT_TRANSLATE_NOOP("views", "Millimetres of material behind the surface, as transmission uses them")},
    {"normal", QT_TRANSLATE_NOOP("views", "Normal"),
     QT_TRANSLATE_NOOP("views", "The shading normal in world space, maps included")},
    {"occlusion", QT_TRANSLATE_NOOP("views", "Ambient occlusion"),
     QT_TRANSLATE_NOOP("views", "The share of the surroundings that reaches the surface")},
    {"profile_id", QT_TRANSLATE_NOOP("views", "Diffusion profile id"),
     QT_TRANSLATE_NOOP("views", "A colour for each profile; light never crosses between two")},
    {"depth", QT_TRANSLATE_NOOP("views", "Depth"),
     QT_TRANSLATE_NOOP("views", "Distance along the view; white is near")},
    {"energy", QT_TRANSLATE_NOOP("views", "Energy"),
     QT_TRANSLATE_NOOP("views", "The share of a uniform white environment that comes back; above 1 is red")},
};

}  // namespace

const std::vector<ViewMode>& viewModes() {
  static const std::vector<ViewMode> kModes = [] {
    std::vector<ViewMode> modes;
    const std::vector<Aov> all = allAovs();
    for (const Row& row : kRows) {
      const auto found = std::find_if(all.begin(), all.end(), [&](Aov aov) { return toString(aov) == row.name; });
      if (found != all.end())
        modes.push_back(
            {*found, QCoreApplication::translate("views", row.label), QCoreApplication::translate("views", row.help)});
    }
    return modes;
  }();
  return kModes;
}

const ViewMode& viewMode(Aov aov) {
  const std::vector<ViewMode>& modes = viewModes();
  const auto found = std::find_if(modes.begin(), modes.end(), [&](const ViewMode& mode) { return mode.aov == aov; });
  return found != modes.end() ? *found : modes.front();
}

Aov nextView(Aov aov, int steps) {
  const std::vector<ViewMode>& modes = viewModes();
  const auto count = static_cast<int>(modes.size());
  const auto here = static_cast<int>(&viewMode(aov) - modes.data());
  return modes[static_cast<std::size_t>(((here + steps) % count + count) % count)].aov;
}

}  // namespace dermis
