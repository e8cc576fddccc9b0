#include "ui/rows/colour_editor.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QVBoxLayout>
#include <cmath>

#include "ui/dialogs/colour_picker.h"
#include "ui/rows/colour_math.h"
#include "ui/rows/number_field.h"
#include "ui/rows/scalar_editor.h"
#include "ui/rows/value_slider.h"
#include "ui/theme/metrics.h"

namespace dermis {
namespace {

float meanOf(const glm::vec3& c) { return (c.r + c.g + c.b) / 3.0F; }

}  // namespace

Swatch::Swatch(QWidget* parent) : QAbstractButton(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setCursor(Qt::PointingHandCursor);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void Swatch::showColour(const glm::vec3& linear) {
  m_linear = linear;
  update();
}

void Swatch::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  const QRectF box = QRectF(rect()).adjusted(1, 1, -1, -1);
  p.setPen(
      QPen(hasFocus() ? palette().color(QPalette::Highlight) : palette().color(QPalette::Shadow), hasFocus() ? 2 : 1));
  QColor fill = toScreen(m_linear);
  if (!isEnabled()) fill.setAlphaF(0.4F);
  p.setBrush(fill);
  p.drawRoundedRect(box, 3, 3);
}

ColourEditor::ColourEditor(bool optional, const NumberRange& range, QWidget* parent)
    : ValueEditor(parent), m_range(range), m_optional(optional) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2);
  auto* row = new QHBoxLayout();
  row->setSpacing(metrics::kGap);
  column->addLayout(row);
  m_swatch = new Swatch(this);
  m_text = new QLabel(this);
  m_text->setProperty("quiet", true);
  m_text->setMinimumWidth(metrics::kNumberWidth + metrics::kUnitWidth + metrics::kGap);
  if (optional) {
    m_switch = new QCheckBox(tr("Own"), this);
    m_switch->setToolTip(tr("On: a value of its own. Off: follows the index of refraction."));
    connect(m_switch, &QCheckBox::toggled, this, [this](bool own) {
      const Gesture gesture = newGesture();
      if (own)
        tell(m_automatic, gesture);
      else
        Q_EMIT edited(ParameterValue(OptionalColour{}), gesture);
    });
    row->addWidget(m_switch);
  }
  row->addWidget(m_swatch, 1);
  row->addWidget(m_text);
  if (optional) {
    // The reflectance of dielectrics is grey: one slider sets it, and keeps the hue of a colour that has one.
    m_brightness = new ScalarEditor(range, this);
    column->addWidget(m_brightness);
    connect(m_brightness, &ScalarEditor::numberEdited, this, [this](double number, Gesture gesture) {
      const glm::vec3 from = m_own ? m_linear : m_automatic;
      const float mean = meanOf(from);
      const auto target = static_cast<float>(number);
      const glm::vec3 next = mean > 1e-6F ? from * (target / mean) : glm::vec3(target);
      tell(glm::clamp(next, glm::vec3(0.0F), glm::vec3(1.0F)), gesture);
    });
  }
  setFocusProxy(m_swatch);
  connect(m_swatch, &Swatch::clicked, this, &ColourEditor::openPicker);
}

void ColourEditor::tell(const glm::vec3& linear, Gesture gesture) {
  if (m_optional)
    Q_EMIT edited(ParameterValue(OptionalColour(Colour{linear})), gesture);
  else
    Q_EMIT edited(ParameterValue(Colour{linear}), gesture);
}

void ColourEditor::openPicker() {
  if (m_picker == nullptr) {
    m_picker = new ColourPicker(m_path, window());
    m_picker->setObjectName(m_id + QStringLiteral(".picker"));
    m_swatch->setPicker(m_picker);
    connect(m_picker, &ColourPicker::edited, this, &ColourEditor::tell);
  }
  m_picker->showColour(m_own ? m_linear : m_automatic);
  m_picker->openBeside(m_swatch);
}

void ColourEditor::showValue(const ParameterValue& value) {
  if (m_optional) {
    const auto& colour = std::get<OptionalColour>(value);
    m_own = colour.has_value();
    if (colour) m_linear = colour->rgb;
  } else {
    m_linear = std::get<Colour>(value).rgb;
  }
  refresh();
}

void ColourEditor::showDefault(const ParameterValue& value) {
  if (m_brightness == nullptr) return;
  const auto& colour = std::get<OptionalColour>(value);
  m_brightness->showDefaultNumber(static_cast<double>(meanOf(colour ? colour->rgb : m_automatic)));
}

void ColourEditor::showMixed(bool mixed) {
  m_mixed = mixed;
  if (m_brightness != nullptr) m_brightness->showMixed(mixed);
  refresh();
}

void ColourEditor::setAutomatic(const glm::vec3& linear) {
  m_automatic = linear;
  refresh();
}

void ColourEditor::refresh() {
  const glm::vec3 shown = m_own ? m_linear : m_automatic;
  m_swatch->showColour(shown);
  m_text->setText(m_mixed ? QStringLiteral("—") : m_own ? toScreen(shown).name().toUpper() : tr("from IOR"));
  const auto part = [](float v) { return QString::number(static_cast<double>(v), 'f', 3); };
  m_swatch->setToolTip(tr("Linear Rec.709 %1, %2, %3\nsRGB %4")
                           .arg(part(shown.r), part(shown.g), part(shown.b), toScreen(shown).name()));
  if (m_switch != nullptr) {
    const QSignalBlocker blocker(m_switch);
    m_switch->setChecked(m_own);
  }
  if (m_brightness != nullptr) m_brightness->showNumber(std::round(static_cast<double>(meanOf(shown)) * 1e5) * 1e-5);
  if (m_picker != nullptr && m_picker->isVisible()) m_picker->showColour(shown);
}

void ColourEditor::nameControls(const QString& path, const QString& id) {
  m_path = path;
  m_id = id;
  m_swatch->setAccessibleName(path);
  m_swatch->setObjectName(id + QStringLiteral(".swatch"));
  if (m_switch != nullptr) {
    m_switch->setAccessibleName(tr("%1, own value").arg(path));
    m_switch->setObjectName(id + QStringLiteral(".own"));
  }
  if (m_brightness != nullptr) m_brightness->nameControls(path, id);
}

}  // namespace dermis
