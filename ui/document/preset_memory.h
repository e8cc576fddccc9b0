// What preset files hold by now and where they have gone. Slots and undo entries keep a copy of what they read once;
// whether that still is its preset shows only beside the newest content.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "ui/document/sections.h"

namespace dermis {

class PresetMemory {
 public:
  /// The file at `path` holds this now, as it was read or written. True where it was known to hold something else.
  bool holds(const std::string& path, const Material& content);
  /// A preset's file was renamed or given tags: it looks as it did, under another name or with other metadata.
  void rewritten(const std::string& from, const std::string& to, const Material& before, const Material& after);
  void clear();

  /// Path, name, metadata and `edited` as they are now. True where anything changed.
  bool refresh(MaterialBinding& binding) const;
  bool refresh(SlotLook& look) const;

 private:
  struct Move {
    std::string to, oldName, newName;
    nlohmann::ordered_json metadata;
  };
  std::map<std::string, std::shared_ptr<const Material>> m_contents;
  std::map<std::string, Move> m_moves;
};

}  // namespace dermis
