#include "ui/viewport/pick_readout.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/document/document.h"
#include "ui/text.h"
#include "ui/viewport/overlay.h"
#include "ui/viewport/viewport.h"

namespace dermis {
namespace {

constexpr int kReadAfterMs = 60;   // often enough for a hand, and no more work than needed
constexpr int kReadAgainMs = 250;  // under a pointer that rests, as the picture converges: digits that can be read

QString triple(const glm::vec3& v, int digits) {
  return QStringLiteral("%1  %2  %3")
      .arg(static_cast<double>(v.x), 0, 'f', digits)
      .arg(static_cast<double>(v.y), 0, 'f', digits)
      .arg(static_cast<double>(v.z), 0, 'f', digits);
}

}  // namespace

PickReadout::PickReadout(Document& document, Viewport& viewport)
    : QObject(&viewport), m_document(document), m_viewport(viewport) {
  m_label = new OverlayLabel(&viewport);
  m_label->setObjectName(QStringLiteral("viewport.readout"));
  m_label->hide();
  m_soon.setSingleShot(true);
  connect(&m_soon, &QTimer::timeout, this, &PickReadout::read);
  connect(&viewport, &Viewport::pointed, this, [this](const QPointF& at) {
    m_at = at;
    m_isWanted = m_enabled;
    if (m_isWanted && !m_soon.isActive()) m_soon.start(kReadAfterMs);
  });
  connect(&viewport, &GlWidget::frameShown, this, [this] {
    if (m_isWanted && !m_soon.isActive()) m_soon.start(kReadAgainMs);
  });
  connect(&viewport, &Viewport::pointerLeft, this, [this] {
    m_at.reset();
    hide();
  });
  // What is being dragged changes what is read: nothing is shown until the pointer moves freely again.
  connect(&m_document, &Document::changed, this, [this] { hide(); });
}

void PickReadout::setEnabled(bool enabled) {
  m_enabled = enabled;
  if (!enabled) hide();
}

void PickReadout::hide() {
  m_isWanted = false;
  m_soon.stop();
  m_label->hide();
}

QString PickReadout::textAt(const QPointF& at) {
  const auto pixel = m_viewport.readPixel(at);
  if (!pixel || !m_document.isReady()) return {};
  QStringList lines;
  lines << tr("Radiance %1").arg(triple(glm::vec3(pixel->radiance), 4));
  const glm::vec3 codes = glm::round(pixel->display * 255.0F);
  lines << tr("Display %1 (%2)")
               .arg(triple(pixel->display, 3),
                    QColor(static_cast<int>(codes.r), static_cast<int>(codes.g), static_cast<int>(codes.b)).name());
  const auto hit = m_viewport.surfaceAt(at);
  if (!hit) return lines.join(QLatin1Char('\n'));
  const double millimetres = static_cast<double>(m_document.millimetresPerUnit());
  const Camera& camera = m_document.camera();
  const double depth =
      static_cast<double>(glm::dot(hit->position - camera.position, glm::normalize(camera.target - camera.position)));
  lines << tr("Slot %1").arg(QString::fromStdString(m_document.model()->slots[hit->slot].name));
  if (pixel->thicknessMm) lines << tr("Thickness %1 mm").arg(static_cast<double>(*pixel->thicknessMm), 0, 'f', 2);
  lines << tr("Normal %1").arg(triple(hit->normal, 3));
  lines << tr("Depth %1 mm").arg(depth * millimetres, 0, 'f', 1);
  return lines.join(QLatin1Char('\n'));
}

void PickReadout::read() {
  if (!m_at || !m_enabled) return;
  const QString words = textAt(*m_at);
  if (words.isEmpty()) return m_label->hide();
  m_label->setText(words);
  m_label->setAccessibleName(tr("Under the pointer: %1").arg(words));
  m_label->adjustSize();
  m_label->move(10, 40);
  m_label->show();
}

void PickReadout::pin(const QPointF& at) {
  QString words = textAt(at);
  if (words.isEmpty()) {
    static_cast<void>(m_viewport.grabFrame());  // half a picture says nothing yet
    words = textAt(at);
  }
  if (words.isEmpty()) return;
  QGuiApplication::clipboard()->setText(words);
  const auto hit = m_viewport.surfaceAt(at);
  if (!hit) return;
  m_pins << Pin{hit->position, words.section(QLatin1Char('\n'), 0, 0)};
  m_viewport.updateOverlay();
}

void PickReadout::pinHere() { pin(m_at.value_or(QRectF(m_viewport.rect()).center())); }

void PickReadout::clearPins() {
  m_pins.clear();
  m_viewport.updateOverlay();
}

QString PickReadout::slotAt(const QPointF& at) const {
  const auto hit = m_viewport.surfaceAt(at);
  return hit ? QString::fromStdString(m_document.model()->slots[hit->slot].name) : QString();
}

bool PickReadout::selectSlot(const QPointF& at) {
  const QString slot = slotAt(at);
  if (slot.isEmpty()) return false;
  m_document.setCurrentSlot(slot);
  return true;
}

void PickReadout::paint(QPainter& p, const Projection& view) {
  p.setRenderHint(QPainter::Antialiasing);
  for (qsizetype i = 0; i < m_pins.size(); ++i) {
    const auto at = view.toScreen(m_pins[i].place);
    if (!at) continue;
    p.setPen(QPen(QColor(0, 0, 0, 160), 3.0));
    p.setBrush(Qt::NoBrush);
    p.drawEllipse(*at, 5.0, 5.0);
    p.setPen(QPen(QColor(240, 240, 240), 1.2));
    p.drawEllipse(*at, 5.0, 5.0);
    const QString words = QStringLiteral("%1  %2").arg(i + 1).arg(m_pins[i].text);
    paintTag(p, *at + QPointF(9.0, 0.0), Qt::AlignRight, words);
  }
}

}  // namespace dermis
