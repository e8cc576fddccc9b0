// What became of the files that were dropped to be matched by name, in words.
#pragma once

#include <QString>
#include <QStringList>
#include <map>
#include <set>

#include "core/material/shading_model.h"
#include "core/material/texture_match.h"

namespace dermis {

class MatchReport {
 public:
  /// `namesSlots`: several slots are matched, and each line says which.
  explicit MatchReport(bool namesSlots) : m_namesSlots(namesSlots) {}

  void used(const QString& slot, const TextureMatch& match);
  /// The slot's shading model has no use for the map.
  void notRead(const TextureMatch& match, ShadingModel model);
  void leftOver(const std::vector<TextureLeftOver>& files, ShadingModel model);

  /// Other tiles of a UDIM set that was taken are used as well.
  [[nodiscard]] int filesUsed() const { return static_cast<int>(m_used.size()); }
  [[nodiscard]] int filesLeft() const { return static_cast<int>(unused().size()); }
  /// Lines: a map and its file each, then what was not used, each file with the reason.
  [[nodiscard]] QString text() const;
  /// Why files that do have a map's name became none, as a sentence; empty where there are none.
  [[nodiscard]] QString whyNot() const;

 private:
  struct Reason {
    QString words;
    bool isKnown = false;  ///< the name says something
  };
  [[nodiscard]] std::map<std::filesystem::path, Reason> unused() const;

  bool m_namesSlots;
  QStringList m_lines;
  std::set<std::filesystem::path> m_used;  ///< a set by its name
  std::map<std::filesystem::path, Reason> m_left;
};

}  // namespace dermis
