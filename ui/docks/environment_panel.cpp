#include "ui/docks/environment_panel.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/browse/environment_list.h"
#include "ui/docks/rig_box.h"
#include "ui/docks/row_help.h"
#include "ui/document/document.h"
#include "ui/document/loading.h"
#include "ui/rows/choice_editors.h"
#include "ui/rows/colour_editor.h"
#include "ui/rows/group_box.h"
#include "ui/rows/property_row.h"
#include "ui/rows/scalar_editor.h"
#include "ui/text.h"
#include "ui/theme/icons.h"
#include "ui/theme/metrics.h"

namespace dermis {
namespace {
constexpr float kBlur = 0.4F;  // so that a blurred background is seen to be one
}

EnvironmentPanel::EnvironmentPanel(Document& document, Loading& loading, Preferences& preferences, QWidget* parent)
    : Panel(parent), m_document(document), m_loading(loading) {
  buildList(preferences);
  buildRows();
  m_rig = new RigBox(body());
  addWidget(m_rig);
  finish();
  connect(&m_document, &Document::changed, this, [this](Change what) {
    if (what == Change::Everything || what == Change::Environment) refresh();
  });
  refresh();
}

void EnvironmentPanel::buildList(Preferences& preferences) {
  m_list = new EnvironmentList(preferences, this);
  strip()->addWidget(m_list);
  auto* choose = new QPushButton(themeIcon("open"), tr("Choose file…"), this);
  choose->setObjectName(QStringLiteral("environment.choose"));
  choose->setToolTip(tr("An .hdr or .exr panorama, or a light rig"));
  strip()->addWidget(choose);
  connect(choose, &QPushButton::clicked, this, &EnvironmentPanel::chooseFileRequested);
  connect(m_list, &EnvironmentList::chosen, this, [this](const QString& builtin, const QString& path) {
    const EnvironmentSource& now = m_document.scene().environment;
    if (now.path == path.toStdString() && (!path.isEmpty() || now.builtin == builtin.toStdString())) return;
    EnvironmentSource source;
    source.path = path.toStdString();
    source.builtin = builtin.toStdString();
    m_loading.setEnvironment(source);
  });
}

void EnvironmentPanel::buildRows() {
  GroupBox* group = addGroup(tr("Environment light"), QStringLiteral("environment/light"));
  const QString name = tr("Environment");
  m_rotation = new PropertyRow(name, tr("Rotation"), QStringLiteral("environment.rotation_degrees"),
                               new ScalarEditor(NumberRange{-36000, 36000, -180, 180, QStringLiteral("°")}), group);
  m_rotation->setDefault(ParameterValue(0.0F));
  setRowHelp(
      *m_rotation,
      tr("About the vertical axis, counter-clockwise seen from above. Shift + right-drag turns it in the viewport."));
  m_exposure = new PropertyRow(name, tr("Exposure"), QStringLiteral("environment.exposure_stops"),
                               new ScalarEditor(NumberRange{-20, 20, -6, 6, tr("EV")}), group);
  m_exposure->setDefault(ParameterValue(0.0F));
  setRowHelp(*m_exposure, tr("Stops by which the environment's light is brighter, and what of it is seen behind"));
  group->addRow(m_rotation);
  group->addRow(m_exposure);
  GroupBox* behind = addGroup(tr("Background"), QStringLiteral("environment/background"));
  m_background = new PropertyRow(tr("Background"), tr("Shows"), QStringLiteral("environment.background"),
                                 new ChoiceEditor({tr("Environment"), tr("Irradiance"), tr("Blurred environment"),
                                                   tr("Colour"), tr("Nothing (alpha 0)")}),
                                 behind);
  m_blur = new PropertyRow(tr("Background"), tr("Blur"), QStringLiteral("environment.background.roughness"),
                           new ScalarEditor(NumberRange{0, 1, 0, 1, {}}), behind);
  setRowHelp(*m_blur, tr("Perceptual roughness of the prefiltered environment that is shown"));
  m_color = new PropertyRow(tr("Background"), tr("Colour"), QStringLiteral("environment.background.color"),
                            new ColourEditor(false, NumberRange{}), behind);
  setRowHelp(
      *m_background,
      tr("What is seen behind the model: the environment, its irradiance, the environment blurred, one colour, or "
         "nothing, which a saved picture keeps as alpha 0. The light is the same"));
  setRowHelp(*m_color, tr("The one colour behind the model"));
  m_background->setDefault(ParameterValue(EnumValue{static_cast<int>(Background{}.kind)}));
  m_blur->setDefault(ParameterValue(kBlur));
  m_color->setDefault(ParameterValue(Colour{Background{}.color}));
  for (PropertyRow* row : {m_background, m_blur, m_color}) behind->addRow(row);

  connect(m_rotation, &PropertyRow::edited, this, [this](const ParameterValue& v, Gesture g) {
    edit(tr("Rotate environment"), g, [&](EnvironmentSource& e) { e.rotationDegrees = std::get<float>(v); });
  });
  connect(m_exposure, &PropertyRow::edited, this, [this](const ParameterValue& v, Gesture g) {
    edit(tr("Environment exposure"), g, [&](EnvironmentSource& e) { e.exposureStops = std::get<float>(v); });
  });
  connect(m_background, &PropertyRow::edited, this, [this](const ParameterValue& v, Gesture g) {
    edit(tr("Background"), g, [&](EnvironmentSource& e) {
      e.background.kind = static_cast<BackgroundKind>(std::get<EnumValue>(v).index);
      if (e.background.kind == BackgroundKind::Prefiltered && e.background.perceptualRoughness <= 0.0F)
        e.background.perceptualRoughness = kBlur;
    });
  });
  connect(m_blur, &PropertyRow::edited, this, [this](const ParameterValue& v, Gesture g) {
    edit(tr("Background blur"), g,
         [&](EnvironmentSource& e) { e.background.perceptualRoughness = std::get<float>(v); });
  });
  connect(m_color, &PropertyRow::edited, this, [this](const ParameterValue& v, Gesture g) {
    edit(tr("Background colour"), g, [&](EnvironmentSource& e) { e.background.color = std::get<Colour>(v).rgb; });
  });
}

void EnvironmentPanel::edit(const QString& what, quint64 gesture,
                            const std::function<void(EnvironmentSource&)>& change) {
  EnvironmentSource next = m_document.scene().environment;
  change(next);
  m_document.setEnvironmentSettings(next, what, gesture);
}

void EnvironmentPanel::refresh() {
  const EnvironmentSource& source = m_document.scene().environment;
  m_list->showUsed(source);
  m_rotation->showValue(ParameterValue(source.rotationDegrees));
  m_exposure->showValue(ParameterValue(source.exposureStops));
  m_background->showValue(ParameterValue(EnumValue{static_cast<int>(source.background.kind)}));
  m_blur->setVisible(source.background.kind == BackgroundKind::Prefiltered);
  m_blur->showValue(ParameterValue(source.background.perceptualRoughness));
  m_color->setVisible(source.background.kind == BackgroundKind::Color);
  m_color->showValue(ParameterValue(Colour{source.background.color}));
}

}  // namespace dermis
