#include "ui/rows/gaussians_editor.h"

#include <QGridLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/rows/number_field.h"
#include "ui/theme/icons.h"
#include "ui/theme/metrics.h"

namespace dermis {

GaussiansEditor::GaussiansEditor(const NumberRange& range, QWidget* parent) : ValueEditor(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(metrics::kRowSpacing);
  auto* grid = new QGridLayout();
  grid->setHorizontalSpacing(metrics::kRowSpacing);
  grid->setVerticalSpacing(2);
  column->addLayout(grid);
  const QStringList heads = {tr("Variance mm²"), tr("R"), tr("G"), tr("B")};
  for (int i = 0; i < 4; ++i) {
    auto* head = new QLabel(heads[i], this);
    head->setProperty("quiet", true);
    head->setAlignment(Qt::AlignRight);
    grid->addWidget(head, 0, i);
    grid->setColumnStretch(i, i == 0 ? 3 : 2);
  }
  const NumberRange variance{range.hardMin, range.hardMax, 0.0, 10.0, {}};
  const NumberRange weight{0.0, 1.0, 0.0, 1.0, {}};
  for (std::size_t line = 0; line < kMaxGaussians; ++line) {
    for (std::size_t i = 0; i < 4; ++i) {
      auto* field = new NumberField(i == 0 ? variance : weight, this);
      field->setMinimumWidth(44);
      grid->addWidget(field, static_cast<int>(line) + 1, static_cast<int>(i));
      m_lines.at(line).fields.at(i) = field;
      connect(field, &NumberField::edited, this, [this, line, i](double number, Gesture gesture) {
        GaussianTerm& term = m_shown.terms.at(line);
        const auto value = static_cast<float>(number);
        if (i == 0)
          term.variance = value;
        else
          term.weight[static_cast<int>(i) - 1] = value;
        tell(gesture);
      });
    }
    auto* remove = new QToolButton(this);
    remove->setIcon(themeIcon("remove"));
    remove->setAutoRaise(true);
    remove->setToolTip(tr("Remove this row"));
    grid->addWidget(remove, static_cast<int>(line) + 1, 4);
    m_lines.at(line).remove = remove;
    connect(remove, &QToolButton::clicked, this, [this, line] {
      std::move(m_shown.terms.begin() + static_cast<std::ptrdiff_t>(line) + 1, m_shown.terms.end(),
                m_shown.terms.begin() + static_cast<std::ptrdiff_t>(line));
      m_shown.terms.back() = GaussianTerm{};
      --m_shown.count;
      tell(newGesture());
    });
  }
  auto* foot = new QHBoxLayout();
  m_add = new QToolButton(this);
  m_add->setIcon(themeIcon("add"));
  m_add->setText(tr("Add a row"));
  m_add->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  connect(m_add, &QToolButton::clicked, this, [this] {
    if (m_shown.count >= static_cast<int>(kMaxGaussians)) return;
    const float last =
        m_shown.count > 0 ? m_shown.terms.at(static_cast<std::size_t>(m_shown.count) - 1).variance : 0.0F;
    m_shown.terms.at(static_cast<std::size_t>(m_shown.count++)) =
        GaussianTerm{last > 0.0F ? 2.0F * last : 0.01F, glm::vec3(0.0F)};
    tell(newGesture());
  });
  m_sums = new QLabel(this);
  m_sums->setProperty("quiet", true);
  m_sums->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  foot->addWidget(m_add);
  foot->addWidget(m_sums, 1);
  column->addLayout(foot);
}

void GaussiansEditor::tell(Gesture gesture) {
  refresh();
  Q_EMIT edited(ParameterValue(m_shown), gesture);
}

void GaussiansEditor::showValue(const ParameterValue& value) {
  m_shown = std::get<GaussianTable>(value);
  refresh();
}

void GaussiansEditor::refresh() {
  glm::vec3 sum(0.0F);
  for (std::size_t line = 0; line < kMaxGaussians; ++line) {
    const bool used = static_cast<int>(line) < m_shown.count;
    const GaussianTerm& term = m_shown.terms.at(line);
    if (used) sum += term.weight;
    for (std::size_t i = 0; i < 4; ++i) {
      NumberField* field = m_lines.at(line).fields.at(i);
      field->setVisible(used);
      field->showNumber(static_cast<double>(i == 0 ? term.variance : term.weight[static_cast<int>(i) - 1]));
    }
    m_lines.at(line).remove->setVisible(used);
  }
  m_add->setEnabled(m_shown.count < static_cast<int>(kMaxGaussians));
  const auto text = [](float v) { return QString::number(static_cast<double>(v), 'f', 3); };
  m_sums->setText(tr("Sums  %1  %2  %3").arg(text(sum.r), text(sum.g), text(sum.b)));
}

void GaussiansEditor::nameControls(const QString& path, const QString& id) {
  static const QStringList kNames = {tr("variance"), tr("red weight"), tr("green weight"), tr("blue weight")};
  for (std::size_t line = 0; line < kMaxGaussians; ++line) {
    for (std::size_t i = 0; i < 4; ++i) {
      NumberField* field = m_lines.at(line).fields.at(i);
      field->setAccessibleName(tr("%1, row %2, %3").arg(path).arg(line + 1).arg(kNames[static_cast<qsizetype>(i)]));
      field->setObjectName(QStringLiteral("%1.%2.%3").arg(id).arg(line).arg(i));
    }
    m_lines.at(line).remove->setAccessibleName(tr("%1, remove row %2").arg(path).arg(line + 1));
  }
  m_add->setAccessibleName(tr("%1, add a row").arg(path));
}

}  // namespace dermis
