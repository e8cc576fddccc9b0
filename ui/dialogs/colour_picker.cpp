#include "ui/dialogs/colour_picker.h"

#include <QAccessible>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QScreen>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ui/dialogs/colour_areas.h"
#include "ui/rows/colour_editor.h"
#include "ui/rows/colour_math.h"
#include "ui/rows/scalar_editor.h"
#include "ui/theme/metrics.h"

namespace dermis {

ColourPicker::ColourPicker(const QString& title, QWidget* parent) : QFrame(parent, Qt::Popup) {
  setFrameShape(QFrame::StyledPanel);
  setProperty("popup", true);
  setFixedWidth(320);
  setAccessibleName(tr("Colour of %1").arg(title));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(metrics::kMargin, metrics::kMargin, metrics::kMargin, metrics::kMargin);
  column->setSpacing(metrics::kGap);

  auto* head = new QHBoxLayout();
  auto* name = new QLabel(title, this);
  name->setProperty("heading", true);
  head->addWidget(name, 1);
  m_before = new Swatch(this);
  m_before->setToolTip(tr("As it was: click to go back"));
  m_before->setAccessibleName(tr("Colour as it was"));
  m_now = new Swatch(this);
  m_now->setEnabled(true);
  m_now->setAccessibleName(tr("Colour now"));
  m_now->setFocusPolicy(Qt::NoFocus);
  for (Swatch* swatch : {m_before, m_now}) swatch->setFixedWidth(36);
  head->addWidget(m_before);
  head->addWidget(m_now);
  column->addLayout(head);

  m_square = new SaturationSquare(this);
  m_strip = new HueStrip(this);
  column->addWidget(m_square);
  column->addWidget(m_strip);

  const auto section = [&](const QString& text) {
    auto* label = new QLabel(text, this);
    label->setProperty("quiet", true);
    column->addSpacing(metrics::kGap);
    column->addWidget(label);
  };
  const QStringList letters = {QStringLiteral("R"), QStringLiteral("G"), QStringLiteral("B")};
  section(tr("Linear Rec.709 — what the renderer uses"));
  for (int i = 0; i < 3; ++i) {
    auto* channel = new ScalarEditor(NumberRange{0, 1, 0, 1, {}}, this);
    channel->setPrefix(letters[i]);
    channel->nameControls(tr("%1, linear %2").arg(title, letters[i]),
                          QStringLiteral("picker.linear.") + letters[i].toLower());
    connect(channel, &ScalarEditor::numberEdited, this, [this, i](double number, Gesture gesture) {
      glm::vec3 next = m_linear;
      next[i] = static_cast<float>(number);
      tell(next, gesture);
    });
    column->addWidget(channel);
    m_channels.push_back(channel);
  }
  section(tr("sRGB, 0–255 — what image editors show"));
  for (int i = 0; i < 3; ++i) {
    auto* channel = new ScalarEditor(NumberRange{0, 255, 0, 255, {}}, this);
    channel->setPrefix(letters[i]);
    channel->nameControls(tr("%1, sRGB %2").arg(title, letters[i]),
                          QStringLiteral("picker.srgb.") + letters[i].toLower());
    connect(channel, &ScalarEditor::numberEdited, this, [this, i](double number, Gesture gesture) {
      glm::vec3 next = m_linear;
      next[i] = decodeSrgb(static_cast<float>(number / 255.0));
      tell(next, gesture);
    });
    column->addWidget(channel);
    m_encoded.push_back(channel);
  }
  auto* hexRow = new QHBoxLayout();
  auto* hexLabel = new QLabel(tr("Hex, sRGB"), this);
  hexLabel->setProperty("quiet", true);
  m_hex = new QLineEdit(this);
  m_hex->setAccessibleName(tr("%1, sRGB hexadecimal").arg(title));
  m_hex->setFixedWidth(90);
  hexRow->addWidget(hexLabel, 1);
  hexRow->addWidget(m_hex);
  column->addSpacing(metrics::kGap);
  column->addLayout(hexRow);

  connect(m_square, &SaturationSquare::picked, this,
          [this](float s, float v, Gesture gesture) { tellHsv(m_square->hue(), s, v, gesture); });
  connect(m_strip, &HueStrip::picked, this,
          [this](float hue, Gesture gesture) { tellHsv(hue, m_square->saturation(), m_square->value(), gesture); });
  connect(m_before, &Swatch::clicked, this, [this] { tell(m_start, newGesture()); });
  connect(m_hex, &QLineEdit::editingFinished, this, [this] {
    QString text = m_hex->text().trimmed();
    if (!text.startsWith(QLatin1Char('#'))) text.prepend(QLatin1Char('#'));
    const QColor colour(text);
    if (colour.isValid() && colour.name() != toScreen(m_linear).name())
      tell(fromScreen(colour), newGesture());
    else
      showColour(m_linear);
  });
}

void ColourPicker::showColour(const glm::vec3& linear) {
  m_linear = linear;
  const QColor screen = toScreen(linear);
  // A grey has no hue of its own: keep the one last shown, so that the square doesn't jump to red.
  float hue = 0.0F, saturation = 0.0F, value = 0.0F;
  screen.getHsvF(&hue, &saturation, &value);
  if (hue < 0.0F || value <= 0.0F) hue = m_square->hue();
  if (value <= 0.0F) saturation = m_square->saturation();
  m_square->showHsv(hue, saturation, value);
  m_strip->showHue(hue);
  for (int i = 0; i < 3; ++i) {
    m_channels[static_cast<std::size_t>(i)]->showNumber(static_cast<double>(linear[i]));
    m_encoded[static_cast<std::size_t>(i)]->showNumber(
        std::round(2550.0 * static_cast<double>(encodeSrgb(std::clamp(linear[i], 0.0F, 1.0F)))) / 10.0);
  }
  m_hex->setText(screen.name().toUpper());
  m_now->showColour(linear);
}

void ColourPicker::showEvent(QShowEvent* event) {
  QFrame::showEvent(event);
  QAccessibleEvent came(this, QAccessible::ObjectCreated);
  QAccessible::updateAccessibility(&came);
}

void ColourPicker::hideEvent(QHideEvent* event) {
  QAccessibleEvent gone(this, QAccessible::ObjectDestroyed);
  QAccessible::updateAccessibility(&gone);
  QFrame::hideEvent(event);
}

void ColourPicker::openBeside(QWidget* anchor) {
  m_anchor = anchor;
  m_start = m_linear;
  m_before->showColour(m_start);
  adjustSize();
  const QRect screen = anchor->screen()->availableGeometry();
  QPoint at = anchor->mapToGlobal(QPoint(anchor->width() - width(), anchor->height() + 4));
  at.setX(std::clamp(at.x(), screen.left(), std::max(screen.left(), screen.right() - width())));
  if (at.y() + height() > screen.bottom()) at.setY(std::max(screen.top(), screen.bottom() - height()));
  move(at);
  show();
}

void ColourPicker::tell(const glm::vec3& linear, Gesture gesture) {
  showColour(linear);
  Q_EMIT edited(linear, gesture);
}

void ColourPicker::tellHsv(float hue, float saturation, float value, Gesture gesture) {
  m_square->showHsv(hue, saturation, value);
  m_strip->showHue(hue);
  tell(fromScreen(QColor::fromHsvF(std::min(hue, 0.9999F), saturation, value)), gesture);
}

}  // namespace dermis
