// The docks: where they stand at first, remembered between sessions, hidden and brought back together.
#pragma once

#include <QList>
#include <QObject>
#include <QPointer>

class QDockWidget;
class QMainWindow;

namespace dermis {

class DockLayout : public QObject {
  Q_OBJECT
 public:
  explicit DockLayout(QMainWindow& window);
  /// `name` is the remembered state's key.
  QDockWidget* add(const QString& title, const QString& name, QWidget* content);
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
