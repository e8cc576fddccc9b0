#include "ui/main_window/model_unit_bar.h"

#include <QAbstractButton>
#include <QButtonGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <array>
#include <filesystem>

#include "ui/docks/panel.h"
#include "ui/document/document.h"
#include "ui/rows/elided_label.h"
#include "ui/rows/number_field.h"
#include "ui/text.h"
#include "ui/theme/metrics.h"

namespace dermis {
namespace {

struct UnitRow {
  const char* label;
  const char* id;
  float millimetres;
};
constexpr std::array<UnitRow, 4> kUnits = {{{QT_TRANSLATE_NOOP("dermis::ModelUnitBar", "m"), "m", 1000.0F},
                                            {QT_TRANSLATE_NOOP("dermis::ModelUnitBar", "cm"), "cm", 10.0F},
                                            {QT_TRANSLATE_NOOP("dermis::ModelUnitBar", "mm"), "mm", 1.0F},
                                            {QT_TRANSLATE_NOOP("dermis::ModelUnitBar", "inch"), "inch", 25.4F}}};

}  // namespace

ModelUnitBar::ModelUnitBar(Document& document, QWidget* parent) : QFrame(parent), m_document(document) {
  setObjectName(QStringLiteral("modelUnit"));
  setAccessibleName(tr("Unit of the model"));
  setProperty("messageBar", true);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(metrics::kMargin, metrics::kGap, metrics::kGap, metrics::kGap);
  row->setSpacing(metrics::kGap);
  m_text = new QLabel(this);
  m_text->setObjectName(QStringLiteral("modelUnit.text"));
  m_text->setTextFormat(Qt::PlainText);
  row->addWidget(m_text);
  m_why = new ElidedLabel(this);
  m_why->setObjectName(QStringLiteral("modelUnit.why"));
  m_why->setProperty("quiet", true);
  row->addWidget(m_why, 1);
  auto* question = new QLabel(tr("One unit of the file is"), this);
  question->setProperty("quiet", true);
  row->addWidget(question);
  m_units = new QButtonGroup(this);
  for (std::size_t i = 0; i < kUnits.size(); ++i) {
    const UnitRow& unit = kUnits.at(i);
    auto* button = new QToolButton(this);
    button->setText(tr(unit.label));
    button->setCheckable(true);
    button->setFocusPolicy(Qt::StrongFocus);
    button->setObjectName(QStringLiteral("modelUnit.") + QLatin1String(unit.id));
    button->setAccessibleName(tr("One unit of the model is 1 %1").arg(tr(unit.label)));
    button->setToolTip(tr("%1 mm").arg(static_cast<double>(unit.millimetres)));
    m_units->addButton(button, static_cast<int>(i));
    row->addWidget(button);
  }
  m_number = new NumberField(NumberRange{1e-4, 1e7, 0.1, 1000.0, QStringLiteral("mm")}, this);
  m_number->setFixedWidth(86);
  m_number->setObjectName(QStringLiteral("modelUnit.number"));
  m_number->setAccessibleName(tr("Millimetres in one unit of the model"));
  row->addWidget(m_number);
  auto* unit = new QLabel(QStringLiteral("mm"), this);
  unit->setProperty("quiet", true);
  row->addWidget(unit);
  auto* close = iconButton("close", tr("Close the question about the model's unit"), this);
  row->addWidget(close);

  connect(m_units, &QButtonGroup::idClicked, this, [this](int id) {
    m_document.setMillimetresPerUnit(kUnits.at(static_cast<std::size_t>(id)).millimetres, newGesture());
    refresh();
  });
  connect(m_number, &NumberField::edited, this, [this](double millimetres, Gesture gesture) {
    m_document.setMillimetresPerUnit(static_cast<float>(millimetres), gesture);
  });
  connect(close, &QToolButton::clicked, this, &QWidget::hide);
  connect(&m_document, &Document::changed, this, [this](Change what) {
    // Another model has its own question.
    if (what == Change::Everything) hide();
    if (what == Change::Unit) refresh();
  });
  hide();
}

void ModelUnitBar::ask(const QString& name, const QString& source) {
  m_name = name;
  m_source = source;
  refresh();
  show();
}

void ModelUnitBar::ask() {
  if (!m_document.isReady()) return;
  const ModelSource& source = m_document.scene().model;
  ask(source.path.empty() ? text(source.builtin) : pathText(std::filesystem::path(source.path).filename()), {});
}

void ModelUnitBar::refresh() {
  if (!m_document.isReady()) return;
  const Bounds& bounds = m_document.model()->bounds;
  const float millimetres = m_document.millimetresPerUnit();
  const double height = static_cast<double>(bounds.max.y - bounds.min.y) * static_cast<double>(millimetres);
  const QString tall = tr("%1 is %2 mm tall").arg(m_name).arg(height, 0, 'f', height < 100.0 ? 1 : 0);
  m_text->setText(tall);
  m_text->setAccessibleName(m_source.isEmpty() ? tall : tr("%1 (%2)").arg(tall, m_source));
  m_why->setFullText(m_source);
  m_why->setToolTip(m_source);
  m_units->setExclusive(false);
  for (QAbstractButton* button : m_units->buttons())
    button->setChecked(kUnits.at(static_cast<std::size_t>(m_units->id(button))).millimetres == millimetres);
  m_units->setExclusive(true);
  m_number->showNumber(static_cast<double>(millimetres));
}

}  // namespace dermis
