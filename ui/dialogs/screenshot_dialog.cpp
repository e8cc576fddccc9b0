#include "ui/dialogs/screenshot_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
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

#include "renderer.h"
#include "ui/dialogs/save_dialog.h"
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

/// A name that no picture has yet: one after another is kept without a question.
QString freePicture(const QDir& folder) {
  QString path = folder.filePath(QStringLiteral("dermis.png"));
  for (int i = 2; QFileInfo::exists(path); ++i) path = folder.filePath(QStringLiteral("dermis %1.png").arg(i));
  return path;
}

const QStringList& endings() {
  static const QStringList kEndings = {QStringLiteral("png"),  QStringLiteral("exr"), QStringLiteral("jpg"),
                                       QStringLiteral("jpeg"), QStringLiteral("tif"), QStringLiteral("tiff")};
  return kEndings;
}

}  // namespace

ScreenshotDialog::ScreenshotDialog(const glm::ivec2& viewport, const QString& view, const ReferenceObjects& references,
                                   QWidget* parent)
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
  m_kind = new QComboBox(this);
  m_kind->setObjectName(QStringLiteral("screenshot.kind"));
  m_kind->setAccessibleName(tr("What is drawn"));
  m_kind->addItems({tr("The picture"), tr("Turntable: numbered frames"), tr("Sheet of views")});
  form->addRow(tr("What"), m_kind);
  m_preset = new QComboBox(this);
  m_preset->setObjectName(QStringLiteral("screenshot.size"));
  m_preset->setAccessibleName(tr("Size"));
  m_preset->addItem(tr("Viewport (%1 × %2)").arg(viewport.x).arg(viewport.y));
  for (const glm::ivec2& size : kSizes) m_preset->addItem(QStringLiteral("%1 × %2").arg(size.x).arg(size.y));
  m_preset->addItem(tr("Custom"));
  form->addRow(tr("Size"), m_preset);
  m_width = spin(1, 16384, viewport.x, tr("Width in pixels"), this);
  m_height = spin(1, 16384, viewport.y, tr("Height in pixels"), this);
  auto* pixels = new QHBoxLayout();
  pixels->setSpacing(metrics::kGap);
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
  m_frames = spin(2, 9999, settings.value(QStringLiteral("picture/frames"), 36).toInt(), tr("Frames"), this);
  m_frames->setObjectName(QStringLiteral("screenshot.frames"));
  m_frames->setToolTip(tr("Pictures of a turntable, evenly spread round the target"));
  form->addRow(tr("Frames"), m_frames);
  buildChoices(form, view, references);
  const QString folder =
      settings
          .value(QStringLiteral("folders/pictures"), QStandardPaths::writableLocation(QStandardPaths::PicturesLocation))
          .toString();
  m_path = new QLineEdit(freePicture(QDir(folder)), this);
  m_path->setObjectName(QStringLiteral("screenshot.path"));
  m_path->setAccessibleName(tr("File"));
  auto* browse = new QPushButton(tr("Choose…"), this);
  browse->setAutoDefault(false);
  auto* file = new QHBoxLayout();
  file->setSpacing(metrics::kGap);
  file->addWidget(m_path, 1);
  file->addWidget(browse);
  form->addRow(tr("File"), file);
  column->addLayout(form);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel, this);
  m_save = buttons->button(QDialogButtonBox::Save);
  m_copy = buttons->addButton(tr("Copy"), QDialogButtonBox::ActionRole);
  m_copy->setObjectName(QStringLiteral("screenshot.copy"));
  m_copy->setAccessibleName(tr("Copy the picture"));
  m_copy->setToolTip(tr("To the clipboard instead of a file"));
  connect(m_copy, &QPushButton::clicked, this, [this] {
    m_toClipboard = true;
    accept();
  });
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(m_kind, &QComboBox::currentIndexChanged, this, &ScreenshotDialog::refresh);
  connect(m_preset, &QComboBox::activated, this, &ScreenshotDialog::choosePreset);
  connect(browse, &QPushButton::clicked, this, &ScreenshotDialog::chooseFile);
  connect(m_path, &QLineEdit::textChanged, this, &ScreenshotDialog::refresh);
  for (QSpinBox* box : {m_width, m_height})
    connect(box, &QSpinBox::valueChanged, this, [this] { m_preset->setCurrentIndex(m_preset->count() - 1); });
  refresh();
}

void ScreenshotDialog::buildChoices(QFormLayout* form, const QString& view, const ReferenceObjects& references) {
  m_transparent = new QCheckBox(tr("Transparent background"), this);
  m_transparent->setObjectName(QStringLiteral("screenshot.transparent"));
  form->addRow(QString(), m_transparent);
  m_layers = new QCheckBox(tr("All layers (EXR)"), this);
  m_layers->setObjectName(QStringLiteral("screenshot.layers"));
  m_layers->setToolTip(tr("Diffuse, specular, normal, occlusion, depth and profile beside the picture"));
  form->addRow(QString(), m_layers);
  m_shownReferences = references;
  m_references = new QCheckBox(tr("Balls and chart, as in the viewport"), this);
  m_references->setObjectName(QStringLiteral("screenshot.references"));
  m_references->setToolTip(tr("The grey and chrome balls and the colour chart, where the View menu has them on"));
  m_references->setEnabled(references.balls || references.chart);
  form->addRow(QString(), m_references);
  m_view = new QComboBox(this);
  m_view->setObjectName(QStringLiteral("screenshot.view"));
  m_view->setAccessibleName(tr("View transform"));
  m_view->setToolTip(tr("An EXR through Raw is scene-linear"));
  if (const Result<DisplayViews> views = displayViews())
    for (const std::string& name : views->views) m_view->addItem(text(name));
  if (m_view->findText(view, Qt::MatchFixedString) < 0) m_view->addItem(view);
  m_view->setCurrentIndex(m_view->findText(view, Qt::MatchFixedString));
  form->addRow(tr("View"), m_view);
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
  const QString path =
      askWhereToSave(this, tr("Save a picture"), m_path->text(), tr("Pictures (*.png *.exr *.jpg *.tif)"), endings());
  if (path.isEmpty()) return;
  m_agreed = path;
  m_path->setText(path);
}

void ScreenshotDialog::accept() {
  const PictureRequest wanted = request();
  // Of a turntable's frames the first stands for all.
  const std::filesystem::path file = wanted.kind == PictureKind::Turntable ? framePath(wanted.path, 0) : wanted.path;
  const bool agreed = wanted.path.empty() || pathText(file) == m_agreed;
  if (agreed || mayWriteOver(pathText(file), this)) QDialog::accept();
}

void ScreenshotDialog::refresh() {
  const QString ending = QFileInfo(m_path->text()).suffix().toLower();
  const auto kind = static_cast<PictureKind>(m_kind->currentIndex());
  const bool sheet = kind == PictureKind::Sheet;
  m_save->setEnabled(sheet ? ending == QStringLiteral("png") : endings().contains(ending));
  m_save->setToolTip(m_save->isEnabled() ? QString()
                     : sheet             ? tr("A sheet's file name ends in .png")
                                         : tr("The file's name ends in .png, .exr, .jpg or .tif"));
  m_frames->setEnabled(kind == PictureKind::Turntable);
  m_copy->setEnabled(kind != PictureKind::Turntable);
  m_layers->setEnabled(!sheet && ending == QStringLiteral("exr"));
  m_transparent->setEnabled(!ending.startsWith(QStringLiteral("jp")));
}

PictureRequest ScreenshotDialog::request() const {
  QSettings settings;
  settings.setValue(QStringLiteral("picture/samples"), m_samples->value());
  settings.setValue(QStringLiteral("folders/pictures"), QFileInfo(m_path->text()).path());
  PictureRequest request;
  settings.setValue(QStringLiteral("picture/frames"), m_frames->value());
  request.kind = static_cast<PictureKind>(m_kind->currentIndex());
  if (!m_toClipboard) request.path = toPath(m_path->text());
  request.frames = m_frames->value();
  request.view = m_view->currentText().toStdString();
  if (m_references->isChecked()) request.references = m_shownReferences;
  request.size = {m_width->value(), m_height->value()};
  request.samples = m_samples->value();
  request.transparent = m_transparent->isChecked() && m_transparent->isEnabled();
  request.allLayers = m_layers->isChecked() && m_layers->isEnabled();
  return request;
}

}  // namespace dermis
