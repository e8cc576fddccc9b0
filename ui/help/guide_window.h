// The guide: docs/ as they were when the program was built, with a table of contents and a search.
#pragma once

#include <QWidget>

#include "ui/preferences/shortcuts.h"

class QLabel;
class QLineEdit;
class QTextBrowser;
class QTreeWidget;
class QTreeWidgetItem;

namespace dermis {

class GuideWindow : public QWidget {
  Q_OBJECT
 public:
  /// The page of keys is made of these.
  explicit GuideWindow(const Shortcuts& shortcuts, QWidget* parent = nullptr);
  /// A page by its file's name ("rigs.md") or "keys", and a heading on it where there is one of that text.
  void open(const QString& page, const QString& heading = {});
  [[nodiscard]] QString page() const { return m_page; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void fillContents();
  void search();
  void findNext();
  void showHeading(const QString& heading);
  /// No picture is wider than the page.
  void fitPictures();
  [[nodiscard]] QString pageText(const QString& page) const;
  [[nodiscard]] QString keysPage() const;

  const Shortcuts& m_shortcuts;
  QString m_page;
  QLineEdit* m_search = nullptr;
  QLabel* m_found = nullptr;
  QTreeWidget* m_contents = nullptr;
  QTextBrowser* m_text = nullptr;
};

}  // namespace dermis
