// The docks: where they stand at first, remembered between sessions, hidden and brought back together.
#pragma once

#include <QDockWidget>
#include <QList>
#include <QObject>
#include <QPointer>
#include <utility>

class QMainWindow;

namespace dermis {

class DockLayout : public QObject {
  Q_OBJECT
 public:
  explicit DockLayout(QMainWindow& window);
  /// A dock with a `Panel`, which is made inside it: a panel that moves into a dock is given its style, and measured, a
  /// second time. `name` is the remembered state's key.
  template <class Panel, class... Arguments>
  Panel* addPanel(const QString& title, const QString& name, Arguments&&... arguments) {
    QDockWidget* dock = add(title, name);
    auto* panel = new Panel(std::forward<Arguments>(arguments)..., dock);
    dock->setWidget(panel);
    return panel;
  }
  [[nodiscard]] const QList<QDockWidget*>& docks() const { return m_docks; }
  /// To be called once all are added.
  void restore();
  void save() const;
  void reset();
  /// Where each dock stands, to be kept under a name.
  [[nodiscard]] QByteArray state() const;
  void setState(const QByteArray& state);
  /// Hides all, or brings back those that were hidden.
  void toggleAll();
  /// Tears the dock off that has the focus, or had it last, or puts it back.
  void toggleFloating();

 private:
  QDockWidget* add(const QString& title, const QString& name);
  [[nodiscard]] QDockWidget* dock(const char* name) const;
  void arrange();
  void arrangeBothSides();
  void arrangeOneSide();
  void refreshTitleBars();

  QMainWindow& m_window;
  QList<QDockWidget*> m_docks;
  QPointer<QDockWidget> m_used;  ///< has the focus, or had it last
  QByteArray m_shown;            ///< where they stood when all were hidden together
};

}  // namespace dermis
