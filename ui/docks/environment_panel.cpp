#include "ui/docks/environment_panel.h"

#include <QBuffer>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QListWidget>
#include <QPushButton>
#include <QSettings>
#include <QVBoxLayout>

#include "core/builtin/environments.h"
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
#include "ui/thumbnails.h"

namespace dermis {
namespace {

constexpr QSize kThumbnail(112, 56);
constexpr int kBuiltinRole = Qt::UserRole;
constexpr int kPathRole = Qt::UserRole + 1;
constexpr int kRecent = 12;
const QString kRecentKey = QStringLiteral("environments/recent");

QString thumbnailKey(const QString& path) {
  return QStringLiteral("environments/thumbnails/") + QString::number(qHash(path));
}

}  // namespace

EnvironmentPanel::EnvironmentPanel(Document& document, Loading& loading, QWidget* parent)
    : Panel(parent), m_document(document), m_loading(loading) {
  buildList();
  buildRows();
  finish();
  connect(&m_document, &Document::changed, this, [this](Change what) {
    if (what == Change::Everything || what == Change::Environment) refresh();
  });
  refreshList();
  refresh();
}

void EnvironmentPanel::buildList() {
  m_list = new QListWidget(this);
  m_list->setObjectName(QStringLiteral("environment.list"));
  m_list->setAccessibleName(tr("Environments"));
  m_list->setViewMode(QListView::IconMode);
  m_list->setIconSize(kThumbnail);
  m_list->setGridSize(QSize(128, 86));
  m_list->setResizeMode(QListView::Adjust);
  m_list->setMovement(QListView::Static);
  m_list->setUniformItemSizes(true);
  m_list->setWordWrap(false);
  m_list->setTextElideMode(Qt::ElideMiddle);
  m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  m_list->setFixedHeight(186);
  strip()->addWidget(m_list);
  auto* choose = new QPushButton(themeIcon("open"), tr("Choose file…"), this);
  choose->setObjectName(QStringLiteral("environment.choose"));
  strip()->addWidget(choose);
  connect(choose, &QPushButton::clicked, this, &EnvironmentPanel::chooseFileRequested);
  connect(m_list, &QListWidget::itemClicked, this, [this](const QListWidgetItem* item) {
    EnvironmentSource source = m_document.scene().environment;
    const QString path = item->data(kPathRole).toString();
    if (source.path == path.toStdString() &&
        (!path.isEmpty() || source.builtin == item->data(kBuiltinRole).toString().toStdString()))
      return;
    source.faces = {};
    source.constant.reset();
    source.path = path.toStdString();
    source.builtin = item->data(kBuiltinRole).toString().toStdString();
    m_loading.setEnvironment(source);
  });
}

void EnvironmentPanel::buildRows() {
  GroupBox* group = addGroup(tr("Environment light"), QStringLiteral("environment/light"));
  const QString name = tr("Environment");
  m_rotation = new PropertyRow(name, tr("Rotation"), QStringLiteral("environment.rotation_degrees"),
                               new ScalarEditor(NumberRange{-36000, 36000, -180, 180, QStringLiteral("°")}), group);
  m_rotation->setDefault(ParameterValue(0.0F));
  m_rotation->setHelp(
      tr("About the vertical axis, counter-clockwise seen from above. Shift + right-drag turns it in the viewport."));
  m_exposure = new PropertyRow(name, tr("Exposure"), QStringLiteral("environment.exposure_stops"),
                               new ScalarEditor(NumberRange{-20, 20, -6, 6, tr("EV")}), group);
  m_exposure->setDefault(ParameterValue(0.0F));
  group->addRow(m_rotation);
  group->addRow(m_exposure);
  GroupBox* behind = addGroup(tr("Background"), QStringLiteral("environment/background"));
  m_background = new PropertyRow(tr("Background"), tr("Shows"), QStringLiteral("environment.background"),
                                 new ChoiceEditor({tr("Environment"), tr("Irradiance"), tr("Blurred environment"),
                                                   tr("Colour"), tr("Nothing (alpha 0)")}),
                                 behind);
  m_blur = new PropertyRow(tr("Background"), tr("Blur"), QStringLiteral("environment.background.roughness"),
                           new ScalarEditor(NumberRange{0, 1, 0, 1, {}}), behind);
  m_blur->setHelp(tr("Perceptual roughness of the prefiltered environment that is shown"));
  m_color = new PropertyRow(tr("Background"), tr("Colour"), QStringLiteral("environment.background.color"),
                            new ColourEditor(false, NumberRange{}), behind);
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
        e.background.perceptualRoughness = 0.4F;
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

void EnvironmentPanel::refreshList() {
  m_list->clear();
  for (const BuiltinEnvironmentRow& row : builtinEnvironments()) {
    auto* item = new QListWidgetItem(text(row.label), m_list);
    item->setData(kBuiltinRole, text(row.id));
    item->setToolTip(text(row.sentence));
    if (const auto images = builtinEnvironment(row.id, 2 * kThumbnail.width()))
      item->setIcon(QIcon(QPixmap::fromImage(panoramaThumbnail(*images, kThumbnail))));
  }
  QSettings settings;
  for (const QString& path : settings.value(kRecentKey).toStringList()) {
    if (!QFileInfo::exists(path)) continue;
    auto* item = new QListWidgetItem(QFileInfo(path).fileName(), m_list);
    item->setData(kPathRole, path);
    item->setToolTip(path);
    QImage picture;
    picture.loadFromData(settings.value(thumbnailKey(path)).toByteArray(), "PNG");
    if (!picture.isNull()) item->setIcon(QIcon(QPixmap::fromImage(picture)));
  }
}

void EnvironmentPanel::rememberFile() {
  const QString path = text(m_document.scene().environment.path);
  if (path.isEmpty() || !m_document.environmentImages()) return;
  QSettings settings;
  QStringList recent = settings.value(kRecentKey).toStringList();
  if (recent.value(0) == path) return;
  recent.removeAll(path);
  recent.prepend(path);
  while (recent.size() > kRecent) settings.remove(thumbnailKey(recent.takeLast()));
  settings.setValue(kRecentKey, recent);
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  panoramaThumbnail(*m_document.environmentImages(), kThumbnail).save(&buffer, "PNG");
  settings.setValue(thumbnailKey(path), bytes);
  refreshList();
}

void EnvironmentPanel::refresh() {
  const EnvironmentSource& source = m_document.scene().environment;
  rememberFile();
  const QSignalBlocker blocker(m_list);
  m_list->clearSelection();
  m_list->setCurrentItem(nullptr);
  for (int i = 0; i < m_list->count(); ++i) {
    QListWidgetItem* item = m_list->item(i);
    const bool same = source.path.empty() ? (!source.constant && !source.hasFaces() &&
                                             text(source.builtin) == item->data(kBuiltinRole).toString())
                                          : text(source.path) == item->data(kPathRole).toString();
    if (same) m_list->setCurrentItem(item);
  }
  m_rotation->showValue(ParameterValue(source.rotationDegrees));
  m_exposure->showValue(ParameterValue(source.exposureStops));
  m_background->showValue(ParameterValue(EnumValue{static_cast<int>(source.background.kind)}));
  m_blur->setVisible(source.background.kind == BackgroundKind::Prefiltered);
  m_blur->showValue(ParameterValue(source.background.perceptualRoughness));
  m_color->setVisible(source.background.kind == BackgroundKind::Color);
  m_color->showValue(ParameterValue(Colour{source.background.color}));
}

}  // namespace dermis
