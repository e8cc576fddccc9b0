// The keyboard shortcuts of the window's commands: listed, changed, kept. The actions of the menus are the list, with
// those that are in no menu: keys that are held, keys while flying, keys of lists.
#pragma once

#include <QKeySequence>
#include <QList>
#include <QObject>
#include <QPointer>

class QAction;
class QMenu;
class QMenuBar;
class QWidget;

namespace dermis {

class Shortcuts : public QObject {
  Q_OBJECT
 public:
  struct Entry {
    QString id;     ///< its key in the settings
    QString menu;   ///< "File", "View › Ready-made views"
    QString label;  ///< without mnemonics and dots
    QPointer<QAction> action;
    QList<QKeySequence> standard;
    QList<QPointer<QAction>> others;  ///< that have the same keys elsewhere, such as those of other lists
    bool whileFlying = false;         ///< heard only then, when no other key is
  };

  explicit Shortcuts(QObject* parent = nullptr) : QObject(parent) {}
  /// Takes over all commands of the menus (but those of menus with the property "changing"), with the keys that are
  /// stored for them. To be called once, when the menus are complete.
  void collect(QMenuBar* menus);
  /// Lists an action that is in no menu, under a heading; several of one name share their keys. To be said before
  /// collectLoose().
  static void list(QAction* action, const QString& heading, bool whileFlying = false);
  /// Takes over those, of all that belongs to `window`. To be called once, after collect().
  void collectLoose(const QWidget& window);

  [[nodiscard]] const QList<Entry>& entries() const { return m_entries; }
  [[nodiscard]] bool isChanged(const Entry& entry) const;
  /// Empty keys take the shortcut away. Returns a sentence where the keys belong to another; then nothing changes.
  QString set(const Entry& entry, const QKeySequence& keys);
  QString reset(const Entry& entry);
  void resetAll();

 Q_SIGNALS:
  void changed();

 private:
  void collect(const QMenu* menu, const QString& path);
  void take(QAction* action, const QString& heading);
  [[nodiscard]] QString ownerOf(const QKeySequence& keys, const Entry& except) const;
  static void apply(const Entry& entry, const QList<QKeySequence>& keys);
  void store(const Entry& entry);

  QList<Entry> m_entries;
};

}  // namespace dermis
