#include "ui/main_window/dropped_files.h"

#include <QFileInfo>
#include <algorithm>
#include <set>

#include "core/material/texture_match.h"
#include "ui/document/loading.h"
#include "ui/text.h"

namespace dermis {
namespace {

bool isPicture(const QString& path) {
  return fileKind(toPath(path)) == FileKind::Image || path.endsWith(QLatin1String(".exr"), Qt::CaseInsensitive);
}

/// Those of `pictures` whose names say which maps they are.
std::vector<std::filesystem::path> mapsAmong(const QStringList& pictures, const std::string& slot,
                                             const std::vector<std::string>& allSlots) {
  std::vector<std::filesystem::path> files;
  for (const QString& path : pictures) files.push_back(toPath(path));
  std::vector<std::filesystem::path> named;
  const TextureMatches matches = matchTextures(files, slot, allSlots);
  for (const TextureMatch& match : matches.maps) named.push_back(match.path);
  // Maps as well, though not of this slot, or not the best: binding says so.
  for (const TextureLeftOver& left : matches.leftOver)
    if (left.why != TextureLeftOver::Why::NoMapsName) named.push_back(left.path);
  std::ranges::sort(named);
  named.erase(std::unique(named.begin(), named.end()), named.end());
  return named;
}

}  // namespace

DropPlan planDrop(const QStringList& paths, const std::string& slot, const std::vector<std::string>& allSlots) {
  DropPlan plan;
  QStringList pictures;
  std::copy_if(paths.begin(), paths.end(), std::back_inserter(pictures), isPicture);
  plan.maps = mapsAmong(pictures, slot, allSlots);
  bool scene = false;
  for (const QString& path : paths) scene = scene || fileKind(toPath(path)) == FileKind::Scene;
  std::set<FileKind> taken;
  for (const QString& path : paths) {
    if (std::ranges::find(plan.maps, toPath(path)) != plan.maps.end()) continue;
    const bool picture = isPicture(path);
    const FileKind kind = QFileInfo(path).isDir() ? FileKind::Image
                          : picture               ? FileKind::Environment
                                                  : fileKind(toPath(path));
    // A scene brings its own model and light.
    const bool wanted = kind == FileKind::Scene || kind == FileKind::Unknown || !scene;
    if (!wanted || !taken.insert(kind).second)
      plan.leftOut << path;
    else if (picture)
      plan.pictures << path;
    else
      plan.open << path;
  }
  if (scene) {
    for (const std::filesystem::path& map : plan.maps) plan.leftOut << pathText(map);
    plan.maps.clear();
  }
  return plan;
}

}  // namespace dermis
