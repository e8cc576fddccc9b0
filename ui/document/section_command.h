// An undo entry that puts one section of the document into another state.
#pragma once

#include <QUndoCommand>
#include <functional>
#include <utility>

#include "ui/rows/gesture.h"

namespace dermis {

/// Entries with the same key and gesture merge; one that has come back to where it began takes itself off the stack.
template <class Section>
class SectionCommand : public QUndoCommand {
 public:
  using Apply = std::function<void(const Section&)>;

  /// `gesture` 0 never merges.
  SectionCommand(const QString& text, QString key, Gesture gesture, Section before, Section after, Apply apply)
      : QUndoCommand(text),
        m_key(std::move(key)),
        m_gesture(gesture),
        m_before(std::move(before)),
        m_after(std::move(after)),
        m_apply(std::move(apply)) {}

  void undo() override { m_apply(m_before); }
  void redo() override { m_apply(m_after); }
  [[nodiscard]] int id() const override { return m_gesture == 0 ? -1 : 1; }

  bool mergeWith(const QUndoCommand* other) override {
    const auto* next = dynamic_cast<const SectionCommand*>(other);
    if (next == nullptr || next->m_gesture != m_gesture || next->m_key != m_key) return false;
    m_after = next->m_after;
    setText(next->text());
    if (m_after == m_before) {
      m_apply(m_before);  // equal in meaning; now in every byte
      setObsolete(true);
    }
    return true;
  }

 private:
  QString m_key;
  Gesture m_gesture = 0;
  Section m_before;
  Section m_after;
  Apply m_apply;
};

}  // namespace dermis
