// How Document makes undo entries; for its own source files.
#pragma once

#include "ui/document/document.h"
#include "ui/document/section_command.h"

namespace dermis {

template <class Section, class Apply>
void Document::commit(const QString& text, const QString& key, Gesture gesture, Section before, Section after,
                      Apply apply) {
  if (before == after) return;
  m_undo.push(new SectionCommand<Section>(text, key, gesture, std::move(before), std::move(after), std::move(apply)));
}

}  // namespace dermis
