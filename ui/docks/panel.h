// A dock's content: a fixed strip on top, and rows that scroll below it.
#pragma once

#include <QWidget>

class QToolButton;
class QVBoxLayout;

namespace dermis {

class GroupBox;

class Panel : public QWidget {
  Q_OBJECT
 public:
  explicit Panel(QWidget* parent = nullptr);

 protected:
  /// The strip that doesn't scroll; made at the first call.
  QVBoxLayout* strip();
  /// A group at the end of the scrolling rows.
  GroupBox* addGroup(const QString& title, const QString& key);
  /// What scrolls: the parent of all that is added.
  [[nodiscard]] QWidget* body() const;
  void addWidget(QWidget* widget);
  /// To be called once, after the last group.
  void finish();

 private:
  QVBoxLayout* m_outer = nullptr;
  QVBoxLayout* m_strip = nullptr;
  QVBoxLayout* m_rows = nullptr;
};

/// A button that is only an icon, named for people.
[[nodiscard]] QToolButton* iconButton(const char* icon, const QString& name, QWidget* parent);

}  // namespace dermis
