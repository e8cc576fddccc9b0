// A combo box as assistive technology sees it: named by what it chooses, with a list whose entries can be pressed.
#pragma once

#include <QAccessibleWidget>
#include <vector>

class QComboBox;

namespace dermis {

/// Qt's own is called by its current text where there are relations, and its entries can be marked but not chosen.
class AccessibleChoice : public QAccessibleWidget {
 public:
  explicit AccessibleChoice(QComboBox* box);
  ~AccessibleChoice() override;

  [[nodiscard]] QString text(QAccessible::Text kind) const override;
  [[nodiscard]] QAccessible::State state() const override;
  [[nodiscard]] int childCount() const override;
  [[nodiscard]] QAccessibleInterface* child(int index) const override;
  [[nodiscard]] int indexOfChild(const QAccessibleInterface* child) const override;
  [[nodiscard]] QAccessibleInterface* childAt(int x, int y) const override;
  [[nodiscard]] QStringList actionNames() const override;
  void doAction(const QString& action) override;

 private:
  [[nodiscard]] QComboBox* box() const;
  /// Of the entries that were asked for; the box may have more, or fewer, by now.
  mutable std::vector<QAccessible::Id> m_entries;
};

}  // namespace dermis
