// How far a list was scrolled: kept while it is filled anew, and from one session to the next.
#pragma once

#include <QObject>
#include <QString>
#include <optional>

class QListWidget;

namespace dermis {

/// To be destroyed before the list: it writes down where somebody was.
class ListPlace : public QObject {
  Q_OBJECT
 public:
  ListPlace(QListWidget& list, const QString& key);
  ~ListPlace() override;
  /// The list is about to be emptied.
  void hold();
  /// It has been filled again.
  void settle();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  /// A list that isn't seen has nothing to scroll: its place waits until it is laid out.
  void apply();

  QListWidget& m_list;
  QString m_key;
  std::optional<int> m_wanted;
};

}  // namespace dermis
