#include "ui/docks/row_help.h"

#include <QCoreApplication>

#include "ui/rows/colour_editor.h"
#include "ui/rows/number_field.h"
#include "ui/rows/property_row.h"
#include "ui/rows/value_slider.h"

namespace dermis {
namespace {

constexpr double kOpenEnd = 1e5;  // a limit that large only keeps numbers sane: nobody works there

/// Whose words these are, for translators.
struct RowHelp {
  Q_DECLARE_TR_FUNCTIONS(dermis::RowHelp)
};

QString rangeText(double least, double most, const QString& unit) {
  const auto number = [&](double v) {
    const QString digits = QString::number(v, 'g', 6);
    return unit.isEmpty() ? digits : digits + QLatin1Char(' ') + unit;
  };
  if (most < kOpenEnd) return RowHelp::tr("Range %1 to %2").arg(QString::number(least, 'g', 6), number(most));
  if (least > -kOpenEnd) return RowHelp::tr("From %1 upwards").arg(number(least));
  return unit.isEmpty() ? QString() : RowHelp::tr("In %1").arg(unit);
}

QString rangeOf(const ValueEditor& editor) {
  if (qobject_cast<const ColourEditor*>(&editor) != nullptr)
    return RowHelp::tr("Linear Rec.709, each channel from 0 upwards");
  if (const auto* slider = editor.findChild<const ValueSlider*>())
    return rangeText(slider->range().hardMin, slider->range().hardMax, slider->range().unit);
  if (const auto* field = editor.findChild<const NumberField*>())
    return rangeText(field->minimum(), field->maximum(), {});
  return {};
}

}  // namespace

void setRowHelp(PropertyRow& row, const QString& meaning) {
  QString help = meaning.toHtmlEscaped();
  if (const QString range = rangeOf(*row.editor()); !range.isEmpty())
    help += QStringLiteral("<br><br>") + range.toHtmlEscaped();
  row.setHelp(QStringLiteral("<qt>%1<br><span style='color:#909090'>%2</span></qt>").arg(help, row.objectName()));
}

}  // namespace dermis
