#include "ui/rows/accessible_choice.h"

#include <QComboBox>
#include <QPointer>

namespace dermis {
namespace {

class Entry : public QAccessibleInterface, public QAccessibleActionInterface {
 public:
  Entry(QComboBox* box, int index) : m_box(box), m_index(index) {}

  void* interface_cast(QAccessible::InterfaceType type) override {
    return type == QAccessible::ActionInterface ? static_cast<QAccessibleActionInterface*>(this) : nullptr;
  }
  [[nodiscard]] bool isValid() const override { return m_box != nullptr && m_index < m_box->count(); }
  [[nodiscard]] QObject* object() const override { return nullptr; }
  [[nodiscard]] QAccessibleInterface* parent() const override { return QAccessible::queryAccessibleInterface(m_box); }
  [[nodiscard]] QAccessibleInterface* child(int) const override { return nullptr; }
  [[nodiscard]] QAccessibleInterface* childAt(int, int) const override { return nullptr; }
  [[nodiscard]] int childCount() const override { return 0; }
  [[nodiscard]] int indexOfChild(const QAccessibleInterface*) const override { return -1; }
  [[nodiscard]] QString text(QAccessible::Text kind) const override {
    return isValid() && kind == QAccessible::Name ? m_box->itemText(m_index) : QString();
  }
  void setText(QAccessible::Text, const QString&) override {}
  [[nodiscard]] QRect rect() const override { return {}; }
  [[nodiscard]] QAccessible::Role role() const override { return QAccessible::ListItem; }
  [[nodiscard]] QAccessible::State state() const override {
    QAccessible::State state;
    state.invalid = !isValid();
    state.selectable = true;
    state.selected = isValid() && m_box->currentIndex() == m_index;
    state.offscreen = true;
    return state;
  }
  [[nodiscard]] QStringList actionNames() const override { return {pressAction()}; }
  void doAction(const QString& action) override {
    if (action != pressAction() || !isValid() || !m_box->isEnabled()) return;
    m_box->setCurrentIndex(m_index);
    Q_EMIT m_box->activated(m_index);
  }
  [[nodiscard]] QStringList keyBindingsForAction(const QString&) const override { return {}; }

 private:
  QPointer<QComboBox> m_box;
  int m_index;
};

}  // namespace

AccessibleChoice::AccessibleChoice(QComboBox* box) : QAccessibleWidget(box, QAccessible::ComboBox) {
  // What is chosen is the value, whose changes are told; Qt tells of a changed name.
  QObject::connect(box, &QComboBox::currentIndexChanged, box, [box] {
    QAccessibleValueChangeEvent event(box, box->currentText());
    QAccessible::updateAccessibility(&event);
  });
}

AccessibleChoice::~AccessibleChoice() {
  for (const QAccessible::Id entry : m_entries) QAccessible::deleteAccessibleInterface(entry);
}

QComboBox* AccessibleChoice::box() const { return static_cast<QComboBox*>(widget()); }

QString AccessibleChoice::text(QAccessible::Text kind) const {
  if (kind == QAccessible::Value) return box()->currentText();
  return QAccessibleWidget::text(kind);
}

QAccessible::State AccessibleChoice::state() const {
  QAccessible::State state = QAccessibleWidget::state();
  state.expandable = true;
  state.hasPopup = true;
  state.editable = box()->isEditable();
  return state;
}

int AccessibleChoice::childCount() const { return box()->count(); }

QAccessibleInterface* AccessibleChoice::child(int index) const {
  if (index < 0 || index >= childCount()) return nullptr;
  while (m_entries.size() <= static_cast<std::size_t>(index))
    m_entries.push_back(QAccessible::registerAccessibleInterface(new Entry(box(), static_cast<int>(m_entries.size()))));
  return QAccessible::accessibleInterface(m_entries[static_cast<std::size_t>(index)]);
}

int AccessibleChoice::indexOfChild(const QAccessibleInterface* child) const {
  for (int i = 0; i < childCount(); ++i)
    if (this->child(i) == child) return i;
  return -1;
}

QAccessibleInterface* AccessibleChoice::childAt(int, int) const { return nullptr; }

QStringList AccessibleChoice::actionNames() const { return {showMenuAction(), pressAction()}; }

void AccessibleChoice::doAction(const QString& action) {
  if (action == showMenuAction() || action == pressAction()) box()->showPopup();
}

}  // namespace dermis
