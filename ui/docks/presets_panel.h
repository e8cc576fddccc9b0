// The Presets dock: the looks that the program carries and those of watched folders, searched, tried, kept.
#pragma once

#include <QHash>
#include <QIcon>
#include <QWidget>
#include <functional>
#include <memory>

#include "ui/browse/preset_library.h"
#include "ui/browse/thumbnail_maker.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QMenu;
class QPushButton;
class QToolButton;

namespace dermis {

class Document;
class ListPlace;
class Loading;
class Preferences;
class PresetList;

class PresetsPanel : public QWidget {
  Q_OBJECT
 public:
  PresetsPanel(Document& document, Loading& loading, Preferences& preferences, QWidget* parent = nullptr);
  ~PresetsPanel() override;
  [[nodiscard]] PresetLibrary& library() { return m_library; }
  [[nodiscard]] ThumbnailMaker& thumbnails() { return m_thumbnails; }

  // Each on the selected preset.
  void duplicateSelected();
  void renameSelected(const QString& name);
  void setTagsOfSelected(const QStringList& tags);
  void trashSelected();
  /// Puts a preset on slots, as one undo entry.
  void apply(const QString& path, const QStringList& slots_);

 Q_SIGNALS:
  /// The preset is to be seen beside what is worn now, `left`: instead of it.
  void compareRequested(const QString& path, bool left);
  void saveRequested();
  void saveAsRequested();

 private:
  void buildHead();
  void buildFoot();
  void fill();
  void filter();
  void refreshWorn();
  void refreshButtons();
  void applySelected();
  void revert();
  void showThumbnail(const QString& key);
  [[nodiscard]] QSet<QString> shownKeys() const;
  void showProgress(int done, int waiting);
  void fillMenu(QMenu* menu);
  void askName();
  void askTags();
  void remember();
  void restore();
  /// Chooses what was chosen when the editor closed, once it is there.
  void takeAwaited();
  void select(const QString& path);
  /// Its thumbnail, or a ball until there is one.
  [[nodiscard]] QIcon iconOf(const QString& path);
  void tell(const Error& error);
  [[nodiscard]] const PresetEntry* selected() const;

  Document& m_document;
  Loading& m_loading;
  Preferences& m_preferences;
  PresetLibrary m_library;
  ThumbnailMaker m_thumbnails;
  QLineEdit* m_search = nullptr;
  QComboBox* m_tag = nullptr;
  PresetList* m_list = nullptr;
  std::unique_ptr<ListPlace> m_place;
  QLabel* m_nothing = nullptr;
  QLabel* m_worn = nullptr;
  QLabel* m_progress = nullptr;
  QToolButton* m_cancel = nullptr;
  QPushButton* m_apply = nullptr;
  QToolButton* m_update = nullptr;
  QToolButton* m_revert = nullptr;
  QToolButton* m_more = nullptr;
  QHash<QString, QIcon> m_icons;  ///< by the entries' keys
  QString m_awaitedPath, m_awaitedTag;
  bool m_restored = false;
};

}  // namespace dermis
