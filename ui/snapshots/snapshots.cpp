#include "ui/snapshots/snapshots.h"

#include "ui/document/document.h"

namespace dermis {
namespace {
constexpr QSize kThumbnail(192, 128);
}

void Snapshots::take(const QImage& picture) {
  if (!m_document.isReady()) return;
  Snapshot snapshot;
  snapshot.name = tr("Snapshot %1").arg(++m_taken);
  snapshot.look = m_document.wholeLook();
  snapshot.scene = m_document.snapshot();
  if (!picture.isNull()) {
    const QImage larger = picture.scaled(kThumbnail, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation);
    snapshot.thumbnail = larger.copy(QRect(
        QPoint((larger.width() - kThumbnail.width()) / 2, (larger.height() - kThumbnail.height()) / 2), kThumbnail));
  }
  m_all.push_back(std::move(snapshot));
  Q_EMIT changed();
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
