#include "ui/browse/environment_list.h"

#include <QDir>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QSettings>
#include <QToolButton>
#include <QVBoxLayout>

#include "core/base/file_reference.h"
#include "core/builtin/environments.h"
#include "ui/browse/list_place.h"
#include "ui/docks/panel.h"
#include "ui/document/loading.h"
#include "ui/preferences/preferences.h"
#include "ui/text.h"
#include "ui/theme/icons.h"
#include "ui/theme/metrics.h"
#include "ui/translation.h"

namespace dermis {
namespace {

constexpr QSize kThumbnail(128, 64);
constexpr QSize kPixels = 2 * kThumbnail;  // for screens of up to two pixels a point; an icon is made smaller well
constexpr int kBuiltinRole = Qt::UserRole;
constexpr int kPathRole = Qt::UserRole + 1;
constexpr int kRecent = 12;
const QString kRecentKey = QStringLiteral("environments/recent");
const QString kSearchKey = QStringLiteral("environments/search");
const QString kScrollKey = QStringLiteral("environments/scroll");

/// What the panorama of an item is asked for by.
QString panoramaName(const QListWidgetItem& item) {
  const QString path = item.data(kPathRole).toString();
  return path.isEmpty() ? text(builtinReference(item.data(kBuiltinRole).toString().toStdString())) : path;
}

}  // namespace

EnvironmentList::EnvironmentList(Preferences& preferences, QWidget* parent)
    : QWidget(parent), m_preferences(preferences), m_panoramas(kPixels) {
  buildList();
  m_soon.setSingleShot(true);
  m_soon.setInterval(150);
  connect(&m_soon, &QTimer::timeout, this, &EnvironmentList::fill);
  connect(&m_watcher, &QFileSystemWatcher::directoryChanged, this, [this] { m_soon.start(); });
  connect(&m_watcher, &QFileSystemWatcher::fileChanged, this, [this] { m_soon.start(); });
  connect(&m_preferences, &Preferences::changed, this, &EnvironmentList::fill);
  connect(&m_panoramas, &PanoramaMaker::made, this, &EnvironmentList::showPanorama);
  connect(&m_panoramas, &PanoramaMaker::progressed, this, &EnvironmentList::showProgress);
  m_search->setText(QSettings().value(kSearchKey).toString());
  m_place = std::make_unique<ListPlace>(*m_list, kScrollKey);
  fill();
}

EnvironmentList::~EnvironmentList() { QSettings().setValue(kSearchKey, m_search->text()); }

void EnvironmentList::buildList() {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(metrics::kGap);
  m_search = new QLineEdit(this);
  m_search->setObjectName(QStringLiteral("environment.search"));
  m_search->setAccessibleName(tr("Search environments"));
  m_search->setToolTip(tr("Words of a name or folder"));
  m_search->setPlaceholderText(tr("Search environments"));
  m_search->setClearButtonEnabled(true);
  m_search->addAction(themeIcon("search"), QLineEdit::LeadingPosition);
  column->addWidget(m_search);
  m_list = new QListWidget(this);
  m_list->setObjectName(QStringLiteral("environment.list"));
  m_list->setAccessibleName(tr("Environments"));
  m_list->setToolTip(
      tr("Built-in light, files of the folders in the preferences, and files used before; an .hdr or "
         ".exr can also be dropped on the picture"));
  m_list->setViewMode(QListView::IconMode);
  m_list->setIconSize(kThumbnail);
  m_list->setGridSize(QSize(140, 94));
  m_list->setResizeMode(QListView::Adjust);
  m_list->setMovement(QListView::Static);
  m_list->setUniformItemSizes(true);
  m_list->setWordWrap(false);
  m_list->setTextElideMode(Qt::ElideMiddle);
  m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  m_list->setMinimumHeight(104);  // one row of them
  m_list->setMaximumHeight(198);
  column->addWidget(m_list);
  auto* busy = new QHBoxLayout();
  m_progress = new QLabel(this);
  m_progress->setObjectName(QStringLiteral("environment.progress"));
  m_progress->setProperty("quiet", true);
  m_cancel = iconButton("close", tr("Stop reading environments for their thumbnails"), this);
  m_cancel->setObjectName(QStringLiteral("environment.cancel"));
  busy->addWidget(m_progress, 1);
  busy->addWidget(m_cancel);
  column->addLayout(busy);
  showProgress(0);
  connect(m_cancel, &QToolButton::clicked, &m_panoramas, &PanoramaMaker::cancel);
  connect(m_search, &QLineEdit::textChanged, this, &EnvironmentList::filter);
  const auto choose = [this](const QListWidgetItem* item) {
    Q_EMIT chosen(item->data(kBuiltinRole).toString(), item->data(kPathRole).toString());
  };
  connect(m_list, &QListWidget::itemClicked, this, choose);
  connect(m_list, &QListWidget::itemActivated, this, choose);
}

QStringList EnvironmentList::readFiles() const {
  QStringList files = QSettings().value(kRecentKey).toStringList();
  const QStringList patterns = namePatterns(FileKind::Environment).split(QLatin1Char(' '));
  for (const QString& folder : m_preferences.values().environmentFolders)
    for (const QFileInfo& file : QDir(folder).entryInfoList(patterns, QDir::Files, QDir::Name))
      // A .json may be a preset as well.
      if (fileKind(toPath(file.absoluteFilePath())) != FileKind::Preset) files << file.absoluteFilePath();
  files.removeDuplicates();
  files.removeIf([](const QString& file) { return !QFileInfo::exists(file); });
  return files;
}

void EnvironmentList::fill() {
  const QSignalBlocker blocker(m_list);
  m_place->hold();
  m_list->clear();
  for (const BuiltinEnvironmentRow& row : builtinEnvironments()) {
    auto* item = new QListWidgetItem(tableText(row.label), m_list);
    item->setData(kBuiltinRole, text(row.id));
    item->setToolTip(tableText(row.sentence));
    showPicture(*item);
  }
  QStringList watched;
  for (const QString& folder : m_preferences.values().environmentFolders)
    if (QDir(folder).exists()) watched << folder;
  m_files = readFiles();
  for (const QString& file : m_files) {
    watched << file;
    addFile(file);
  }
  const QStringList before = m_watcher.files() + m_watcher.directories();
  if (!before.isEmpty()) m_watcher.removePaths(before);
  if (!watched.isEmpty()) m_watcher.addPaths(watched);
  filter();
  showUsed(m_used);
  m_place->settle();
  showProgress(m_panoramas.waiting());
}

void EnvironmentList::addFile(const QString& path) {
  auto* item = new QListWidgetItem(QFileInfo(path).completeBaseName(), m_list);
  item->setData(kPathRole, path);
  item->setToolTip(path);
  showPicture(*item);
}

void EnvironmentList::showPicture(QListWidgetItem& item) {
  const QImage picture = m_panoramas.find(panoramaName(item));
  if (!picture.isNull()) {
    item.setIcon(QIcon(QPixmap::fromImage(picture)));
    return;
  }
  QPixmap empty(kThumbnail);
  empty.fill(palette().color(QPalette::Mid));
  item.setIcon(QIcon(empty));
}

void EnvironmentList::showPanorama(const QString& environment) {
  for (int i = 0; i < m_list->count(); ++i)
    if (panoramaName(*m_list->item(i)) == environment) showPicture(*m_list->item(i));
}

void EnvironmentList::showProgress(int waiting) {
  m_progress->setVisible(waiting > 0);
  m_cancel->setVisible(waiting > 0);
  m_progress->setText(tr("Reading %n environment(s) for their thumbnails", nullptr, waiting));
}

void EnvironmentList::filter() {
  const QStringList words = m_search->text().simplified().split(QLatin1Char(' '), Qt::SkipEmptyParts);
  for (int i = 0; i < m_list->count(); ++i) {
    QListWidgetItem* item = m_list->item(i);
    const QString all = item->text() + QLatin1Char(' ') + item->data(kPathRole).toString();
    item->setHidden(
        !std::ranges::all_of(words, [&](const QString& word) { return all.contains(word, Qt::CaseInsensitive); }));
  }
}

void EnvironmentList::showUsed(const EnvironmentSource& source) {
  m_used = source;
  const QString path = text(source.path);
  // A file that is in the list already stays where it is: nothing jumps under a hand that clicks through them.
  if (!path.isEmpty() && !m_files.contains(path) && QFileInfo::exists(path)) {
    QSettings settings;
    QStringList recent = settings.value(kRecentKey).toStringList();
    recent.prepend(path);
    settings.setValue(kRecentKey, recent.mid(0, kRecent));
    fill();
    return;
  }
  const QSignalBlocker blocker(m_list);
  m_list->clearSelection();
  m_list->setCurrentItem(nullptr);
  for (int i = 0; i < m_list->count(); ++i) {
    QListWidgetItem* item = m_list->item(i);
    const bool same = path.isEmpty() ? !source.constant && !source.hasFaces() && !source.rig &&
                                           text(source.builtin) == item->data(kBuiltinRole).toString()
                                     : path == item->data(kPathRole).toString();
    if (same) m_list->setCurrentItem(item);
  }
}

}  // namespace dermis
