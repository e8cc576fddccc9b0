// What becomes of files that are dropped on the window, several at once.
#pragma once

#include <QStringList>
#include <filesystem>
#include <string>
#include <vector>

namespace dermis {

struct DropPlan {
  /// One of each kind at most: a scene; else model, environment and preset beside each other; a folder of maps.
  QStringList open;
  std::vector<std::filesystem::path> maps;  ///< named as maps of the slot, to be bound by their names
  QStringList pictures;                     ///< at most one: may remember a scene, else is an environment
  QStringList leftOut;
};

/// `slot` is the one the files were dropped on, `allSlots` those of the model.
[[nodiscard]] DropPlan planDrop(const QStringList& paths, const std::string& slot,
                                const std::vector<std::string>& allSlots);

}  // namespace dermis
