#include "ui/docks/camera_panel.h"

#include <QComboBox>
#include <QGridLayout>
#include <QPushButton>
#include <cmath>

#include "core/scene/cameras.h"
#include "ui/docks/bookmarks_box.h"
#include "ui/docks/labelled.h"
#include "ui/docks/row_help.h"
#include "ui/document/document.h"
#include "ui/rows/choice_editors.h"
#include "ui/rows/group_box.h"
#include "ui/rows/property_row.h"
#include "ui/rows/scalar_editor.h"
#include "ui/text.h"
#include "ui/theme/metrics.h"
#include "ui/translation.h"
#include "ui/viewport/view_modes.h"

namespace dermis {
namespace {

/// What the field of view shows at the target, in scene units.
float heightAtTarget(const Camera& camera) {
  return 2.0F * glm::length(camera.position - camera.target) * std::tan(0.5F * glm::radians(camera.verticalFovDegrees));
}

}  // namespace

CameraPanel::CameraPanel(Document& document, QWidget* parent) : Panel(parent), m_document(document) {
  buildDisplay();
  buildViews();
  buildLens();
  finish();
  connect(&m_document, &Document::changed, this, [this](Change what) {
    if (what == Change::Everything || what == Change::View || what == Change::Lens || what == Change::Camera) refresh();
  });
  refresh();
}

void CameraPanel::buildLens() {
  GroupBox* group = addGroup(tr("Lens"), QStringLiteral("camera/lens"));
  m_orthographic =
      new PropertyRow(tr("Lens"), tr("Orthographic"), QStringLiteral("camera.orthographic"), new SwitchEditor, group);
  m_fov = new PropertyRow(tr("Lens"), tr("Field of view"), QStringLiteral("camera.vertical_fov_degrees"),
                          new ScalarEditor(NumberRange{1, 150, 5, 90, QStringLiteral("°")}), group);
  m_orthographic->setDefault(ParameterValue(false));
  setRowHelp(*m_orthographic, tr("Without perspective: what is farther away is no smaller"));
  m_fov->setDefault(ParameterValue(Camera{}.verticalFovDegrees));
  setRowHelp(*m_fov, tr("Vertical angle of view"));
  m_height = new PropertyRow(tr("Lens"), tr("Height"), QStringLiteral("camera.orthographic_height"),
                             new ScalarEditor(NumberRange{1e-4, 1e5, 0.1, 10, QStringLiteral("u")}), group);
  setRowHelp(*m_height, tr("Height of what the picture shows, in scene units"));
  for (PropertyRow* row : {m_orthographic, m_fov, m_height}) group->addRow(row);

  connect(m_orthographic, &PropertyRow::edited, this, [this](const ParameterValue& value, Gesture gesture) {
    const Camera& camera = m_document.camera();
    Lens lens{camera.verticalFovDegrees, std::nullopt};
    // The target keeps its size when the projection changes.
    if (std::get<bool>(value)) lens.orthographicHeight = heightAtTarget(camera);
    m_document.setLens(lens, gesture);
  });
  connect(m_fov, &PropertyRow::edited, this, [this](const ParameterValue& value, Gesture gesture) {
    m_document.setLens(Lens{std::get<float>(value), std::nullopt}, gesture);
  });
  connect(m_height, &PropertyRow::edited, this, [this](const ParameterValue& value, Gesture gesture) {
    m_document.setLens(Lens{m_document.camera().verticalFovDegrees, std::get<float>(value)}, gesture);
  });
}

void CameraPanel::buildViews() {
  GroupBox* group = addGroup(tr("Ready-made views"), QStringLiteral("camera/views"));
  auto* holder = new QWidget(group);
  auto* grid = new QGridLayout(holder);
  grid->setContentsMargins(metrics::kDotWidth, 0, 0, 0);
  grid->setSpacing(metrics::kRowSpacing);
  int index = 0;
  for (const NamedCameraRow& row : namedCameras()) {
    auto* button = new QPushButton(tableText(row.label), holder);
    button->setObjectName(QStringLiteral("view.") + text(row.id));
    button->setAccessibleName(tr("View %1").arg(tableText(row.label)));
    grid->addWidget(button, index / 2, index % 2);
    ++index;
    connect(button, &QPushButton::clicked, this, [this, id = text(row.id)] { Q_EMIT viewRequested(id); });
  }
  group->addRow(holder);
  GroupBox* kept = addGroup(tr("Bookmarks"), QStringLiteral("camera/bookmarks"));
  m_bookmarks = new BookmarksBox(m_document, kept);
  kept->addRow(m_bookmarks);
}

void CameraPanel::buildDisplay() {
  GroupBox* group = addGroup(tr("Display"), QStringLiteral("camera/display"));
  m_transform = new QuietComboBox(group);
  m_transform->setObjectName(QStringLiteral("view.transform"));
  m_transform->setAccessibleName(tr("View transform"));
  m_display = new QuietComboBox(group);
  m_display->setObjectName(QStringLiteral("view.display"));
  m_display->setAccessibleName(tr("Display"));
  if (const Result<DisplayViews> views = displayViews()) {
    for (const std::string& view : views->views) m_transform->addItem(text(view));
    for (const std::string& display : views->displays) m_display->addItem(text(display));
  } else {
    for (const char* view : {"Raw", "Thesis", "Gamma 2.2"}) m_transform->addItem(QLatin1String(view));
    m_display->addItem(QStringLiteral("sRGB"));
    const QString sentence = text(views.error().message);
    QMetaObject::invokeMethod(
        this, [this, sentence] { Q_EMIT problem(sentence); }, Qt::QueuedConnection);
  }
  group->addRow(labelled(tr("View transform"), m_transform, group));
  QWidget* displayRow = labelled(tr("Display"), m_display, group);
  displayRow->setVisible(m_display->count() > 1);
  group->addRow(displayRow);
  m_exposure = new PropertyRow(tr("Display"), tr("Exposure"), QStringLiteral("view.exposure_stops"),
                               new ScalarEditor(NumberRange{-20, 20, -6, 6, tr("EV")}), group);
  m_exposure->setDefault(ParameterValue(0.0F));
  setRowHelp(*m_exposure, tr("Stops applied to the picture before the view transform; the light stays as it is"));
  group->addRow(m_exposure);
  m_aov = new QuietComboBox(group);
  m_aov->setObjectName(QStringLiteral("view.aov"));
  m_aov->setAccessibleName(tr("Image shown"));
  for (const ViewMode& mode : viewModes()) {
    m_aov->addItem(mode.label, static_cast<int>(mode.aov));
    m_aov->setItemData(m_aov->count() - 1, mode.help, Qt::ToolTipRole);
  }
  group->addRow(labelled(tr("Show"), m_aov, group));

  connect(m_transform, &QComboBox::textActivated, this, [this](const QString& name) {
    ViewSettings view = m_document.scene().view;
    view.transform = name.toStdString();
    m_document.setView(view, newGesture());
  });
  connect(m_display, &QComboBox::textActivated, this, [this](const QString& name) {
    ViewSettings view = m_document.scene().view;
    view.display = name.toStdString();
    m_document.setView(view, newGesture());
  });
  connect(m_exposure, &PropertyRow::edited, this, [this](const ParameterValue& value, Gesture gesture) {
    ViewSettings view = m_document.scene().view;
    view.exposureStops = std::get<float>(value);
    m_document.setView(view, gesture);
  });
  connect(m_aov, &QComboBox::activated, this,
          [this](int) { Q_EMIT aovChosen(static_cast<Aov>(m_aov->currentData().toInt())); });
}

void CameraPanel::showAov(Aov aov) {
  const QSignalBlocker blocker(m_aov);
  m_aov->setCurrentIndex(m_aov->findData(static_cast<int>(aov)));
}

void CameraPanel::refresh() {
  const ViewSettings& view = m_document.scene().view;
  const QSignalBlocker transform(m_transform);
  const QSignalBlocker display(m_display);
  m_transform->setCurrentIndex(m_transform->findText(text(view.transform), Qt::MatchFixedString));
  m_display->setCurrentIndex(m_display->findText(text(view.display), Qt::MatchFixedString));
  m_exposure->showValue(ParameterValue(view.exposureStops));
  const Camera& camera = m_document.camera();
  const bool orthographic = camera.orthographicHeight.has_value();
  m_orthographic->showValue(ParameterValue(orthographic));
  m_fov->showValue(ParameterValue(camera.verticalFovDegrees));
  m_fov->setVisible(!orthographic);
  m_height->setVisible(orthographic);
  if (orthographic) {
    if (m_document.model()) {
      const double size = 2.0 * static_cast<double>(m_document.model()->bounds.radius());
      static_cast<ScalarEditor*>(m_height->editor())
          ->setNumberRange(NumberRange{1e-4, 1e5, 0.05 * size, 3.0 * size, QStringLiteral("u")});
    }
    m_height->setDefault(ParameterValue(heightAtTarget(camera)));
    m_height->showValue(ParameterValue(*camera.orthographicHeight));
  }
}

}  // namespace dermis
