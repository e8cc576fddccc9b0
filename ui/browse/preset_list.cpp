#include "ui/browse/preset_list.h"

#include <QMimeData>
#include <QUrl>

namespace dermis {
namespace {
const QString kMime = QStringLiteral("application/x-dermis-preset");
constexpr int kPicture = 56;
}  // namespace

QString draggedPreset(const QMimeData* data) { return QString::fromUtf8(data->data(kMime)); }

PresetList::PresetList(QWidget* parent) : QListWidget(parent) {
  setObjectName(QStringLiteral("presets.list"));
  setAccessibleName(tr("Presets"));
  setToolTip(
      tr("Double-click or Enter puts a preset on the current slot; drag it onto the picture for the slot there"));
  setIconSize(QSize(kPicture, kPicture));
  setUniformItemSizes(true);
  setDragEnabled(true);
  setDragDropMode(QAbstractItemView::DragOnly);
  setContextMenuPolicy(Qt::CustomContextMenu);
  setEditTriggers(QAbstractItemView::NoEditTriggers);
}

QString PresetList::currentPath() const {
  return currentItem() != nullptr ? currentItem()->data(kPathRole).toString() : QString();
}

QStringList PresetList::mimeTypes() const { return {kMime}; }

QMimeData* PresetList::mimeData(const QList<QListWidgetItem*>& items) const {
  auto* data = new QMimeData();
  if (!items.isEmpty()) data->setData(kMime, items.first()->data(kPathRole).toString().toUtf8());
  return data;
}

}  // namespace dermis
