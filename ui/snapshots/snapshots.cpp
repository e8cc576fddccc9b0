#include "ui/snapshots/snapshots.h"

#include <algorithm>

#include "ui/document/document.h"

namespace dermis {
namespace {

QImage thumbnailOf(const QImage& picture) {
  if (picture.isNull()) return {};
  const QImage larger = picture.scaled(Snapshots::kPicture, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation);
  return larger.copy(QRect(
      QPoint((larger.width() - Snapshots::kPicture.width()) / 2, (larger.height() - Snapshots::kPicture.height()) / 2),
      Snapshots::kPicture));
}

}  // namespace

void Snapshots::take(const QImage& picture) {
  if (!m_document.isReady()) return;
  Snapshot snapshot;
  snapshot.name = tr("Snapshot %1").arg(++m_taken);
  snapshot.look = m_document.wholeLook();
  snapshot.scene = m_document.snapshot();
  snapshot.thumbnail = thumbnailOf(picture);
  m_all.push_back(std::move(snapshot));
  Q_EMIT changed();
}

int Snapshots::undrawn() const {
  const auto found = std::ranges::find_if(m_all, [](const Snapshot& each) { return each.thumbnail.isNull(); });
  return found == m_all.end() ? -1 : static_cast<int>(found - m_all.begin());
}

void Snapshots::setPicture(const ResolvedScene* scene, const QImage& picture) {
  bool any = false;
  for (Snapshot& each : m_all) {
    if (each.scene.get() != scene) continue;
    each.thumbnail = thumbnailOf(picture);
    any = true;
  }
  if (any) Q_EMIT changed();
}

void Snapshots::rename(std::size_t index, const QString& name) {
  if (index >= m_all.size() || name.trimmed().isEmpty()) return;
  m_all[index].name = name.trimmed();
  Q_EMIT changed();
}

void Snapshots::remove(std::size_t index) {
  if (index >= m_all.size()) return;
  m_all.erase(m_all.begin() + static_cast<std::ptrdiff_t>(index));
  Q_EMIT changed();
}

void Snapshots::restore(std::size_t index) {
  if (index < m_all.size()) m_document.restoreLook(m_all[index].look, tr("Restore %1").arg(m_all[index].name));
}

}  // namespace dermis
