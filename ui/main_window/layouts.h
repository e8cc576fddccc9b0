// Arrangements of the panels under names of their own.
#pragma once

#include <QObject>
#include <QStringList>

class QMenu;
class QWidget;

namespace dermis {

class DockLayout;

class Layouts : public QObject {
  Q_OBJECT
 public:
  Layouts(DockLayout& docks, QWidget* window);
  [[nodiscard]] static QStringList names();
  /// Replaces one of the same name.
  void save(const QString& name);
  void use(const QString& name);
  static void remove(const QString& name);
  /// The Window menu's part: use, save under a name, delete, reset.
  void fillMenu(QMenu* menu);

 private:
  void askName();

  DockLayout& m_docks;
  QWidget* m_window = nullptr;
};

}  // namespace dermis
