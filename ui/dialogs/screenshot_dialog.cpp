#include "ui/dialogs/screenshot_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>
#include <QStandardPaths>
#include <QVBoxLayout>
#include <array>

#include "ui/text.h"
#include "ui/theme/metrics.h"

namespace dermis {
namespace {

constexpr std::array<glm::ivec2, 4> kSizes = {{{1280, 720}, {1920, 1080}, {3840, 2160}, {2048, 2048}}};

QSpinBox* spin(int lowest, int highest, int value, const QString& name, QWidget* parent) {
  auto* box = new QSpinBox(parent);
  box->setRange(lowest, highest);
  box->setValue(value);
  box->setAccessibleName(name);
  box->setLocale(QLocale::c());
  box->setGroupSeparatorShown(false);
  box->setButtonSymbols(QAbstractSpinBox::NoButtons);
  box->setFixedWidth(80);
  return box;
}

}  // namespace

ScreenshotDialog::ScreenshotDialog(const glm::ivec2& viewport, const QString& view, QWidget* parent)
    : QDialog(parent), m_viewport(viewport) {
  setObjectName(QStringLiteral("screenshotDialog"));
  setWindowTitle(tr("Save a picture"));
  setMinimumWidth(480);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(18, 18, 18, 14);
  column->setSpacing(metrics::kMargin);
  auto* form = new QFormLayout();
  form->setHorizontalSpacing(18);
  form->setVerticalSpacing(10);
  form->setLabelAlignment(Qt::AlignLeft);
  m_preset = new QComboBox(this);
  m_preset->setAccessibleName(tr("Size"));
  m_preset->addItem(tr("Viewport (%1 × %2)").arg(viewport.x).arg(viewport.y));
  for (const glm::ivec2& size : kSizes) m_preset->addItem(QStringLiteral("%1 × %2").arg(size.x).arg(size.y));
  m_preset->addItem(tr("Custom"));
  form->addRow(tr("Size"), m_preset);
  m_width = spin(1, 16384, viewport.x, tr("Width in pixels"), this);
  m_height = spin(1, 16384, viewport.y, tr("Height in pixels"), this);
  auto* pixels = new QHBoxLayout();
  pixels->addWidget(m_width);
  pixels->addWidget(new QLabel(QStringLiteral("×"), this));
  pixels->addWidget(m_height);
  pixels->addWidget(new QLabel(tr("pixels"), this));
  pixels->addStretch(1);
  form->addRow(QString(), pixels);
  QSettings settings;
  m_samples =
      spin(1, 4096, settings.value(QStringLiteral("picture/samples"), 64).toInt(), tr("Samples per pixel"), this);
  form->addRow(tr("Samples"), m_samples);
  m_transparent = new QCheckBox(tr("Transparent background"), this);
  form->addRow(QString(), m_transparent);
  m_layers = new QCheckBox(tr("All layers (EXR)"), this);
  m_layers->setToolTip(tr("Diffuse, specular, normal, occlusion, depth and profile beside the picture"));
  form->addRow(QString(), m_layers);
  auto* viewLabel = new QLabel(
      view == QStringLiteral("Raw") ? tr("Raw: an EXR is scene-linear") : tr("As displayed: %1").arg(view), this);
  viewLabel->setProperty("quiet", true);
  form->addRow(tr("View"), viewLabel);
  const QString folder =
      settings
          .value(QStringLiteral("folders/pictures"), QStandardPaths::writableLocation(QStandardPaths::PicturesLocation))
          .toString();
  m_path = new QLineEdit(QDir(folder).filePath(QStringLiteral("dermis.png")), this);
  m_path->setObjectName(QStringLiteral("screenshot.path"));
  m_path->setAccessibleName(tr("File"));
  auto* browse = new QPushButton(tr("Choose…"), this);
  browse->setAutoDefault(false);
  auto* file = new QHBoxLayout();
  file->addWidget(m_path, 1);
  file->addWidget(browse);
  form->addRow(tr("File"), file);
  column->addLayout(form);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel, this);
  m_save = buttons->button(QDialogButtonBox::Save);
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(m_preset, &QComboBox::activated, this, &ScreenshotDialog::choosePreset);
  connect(browse, &QPushButton::clicked, this, &ScreenshotDialog::chooseFile);
  connect(m_path, &QLineEdit::textChanged, this, &ScreenshotDialog::refresh);
  for (QSpinBox* box : {m_width, m_height})
    connect(box, &QSpinBox::valueChanged, this, [this] { m_preset->setCurrentIndex(m_preset->count() - 1); });
  refresh();
}

void ScreenshotDialog::choosePreset(int index) {
  if (index == m_preset->count() - 1) return;
  const glm::ivec2 size = index == 0 ? m_viewport : kSizes.at(static_cast<std::size_t>(index) - 1);
  const QSignalBlocker width(m_width);
  const QSignalBlocker height(m_height);
  m_width->setValue(size.x);
  m_height->setValue(size.y);
}

void ScreenshotDialog::chooseFile() {
  const QString path = QFileDialog::getSaveFileName(this, tr("Save a picture"), m_path->text(),
                                                    tr("Pictures (*.png *.exr *.jpg *.tif)"));
  if (!path.isEmpty()) m_path->setText(path);
}

void ScreenshotDialog::refresh() {
  static const QStringList kEndings = {QStringLiteral("png"),  QStringLiteral("exr"), QStringLiteral("jpg"),
                                       QStringLiteral("jpeg"), QStringLiteral("tif"), QStringLiteral("tiff")};
  const QString ending = QFileInfo(m_path->text()).suffix().toLower();
  m_save->setEnabled(kEndings.contains(ending));
  m_save->setToolTip(m_save->isEnabled() ? QString() : tr("The file's name ends in .png, .exr, .jpg or .tif"));
  m_layers->setEnabled(ending == QStringLiteral("exr"));
  m_transparent->setEnabled(!ending.startsWith(QStringLiteral("jp")));
}

PictureRequest ScreenshotDialog::request() const {
  QSettings settings;
  settings.setValue(QStringLiteral("picture/samples"), m_samples->value());
  settings.setValue(QStringLiteral("folders/pictures"), QFileInfo(m_path->text()).path());
  PictureRequest request;
  request.path = toPath(m_path->text());
  request.size = {m_width->value(), m_height->value()};
  request.samples = m_samples->value();
  request.transparent = m_transparent->isChecked() && m_transparent->isEnabled();
  request.allLayers = m_layers->isChecked() && m_layers->isEnabled();
  return request;
}

}  // namespace dermis
