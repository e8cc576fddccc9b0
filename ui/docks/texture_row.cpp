#include "ui/docks/texture_row.h"

#include <QCheckBox>
#include <QContextMenuEvent>
#include <QDragEnterEvent>
#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <QMimeData>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>

#include "core/base/file_reference.h"
#include "ui/docks/panel.h"
#include "ui/rows/choice_editors.h"
#include "ui/rows/number_field.h"
#include "ui/text.h"
#include "ui/theme/metrics.h"
#include "ui/thumbnails.h"

namespace dermis {
namespace {

constexpr int kThumbnailSide = 48;

QString describe(const Image& image) {
  static const QStringList kTypes = {TextureRow::tr("8-bit"), TextureRow::tr("16-bit"), TextureRow::tr("half"),
                                     TextureRow::tr("float")};
  static const QStringList kChannels = {TextureRow::tr("grey"), TextureRow::tr("grey + alpha"), QStringLiteral("RGB"),
                                        QStringLiteral("RGBA")};
  return QStringLiteral("%1 × %2  ·  %3 %4")
      .arg(image.width)
      .arg(image.height)
      .arg(kTypes[static_cast<int>(image.type)], kChannels[image.channels - 1]);
}

}  // namespace

TextureRow::TextureRow(const TextureSlotRow& slot, QWidget* parent) : QFrame(parent), m_slot(slot) {
  setObjectName(QStringLiteral("texture.") + text(slot.id));
  setAccessibleName(tr("Texture maps › %1").arg(text(slot.label)));
  setProperty("card", true);
  setAcceptDrops(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(metrics::kGap, metrics::kGap, metrics::kGap, metrics::kGap);
  column->setSpacing(metrics::kGap);
  buildHead();
  buildDetails();
  showBinding({}, nullptr);
}

void TextureRow::buildHead() {
  auto* head = new QHBoxLayout();
  head->setSpacing(metrics::kMargin);
  m_thumbnail = new QLabel(this);
  m_thumbnail->setFixedSize(kThumbnailSide, kThumbnailSide);
  m_thumbnail->setAlignment(Qt::AlignCenter);
  m_thumbnail->setProperty("quiet", true);
  m_thumbnail->setProperty("thumbnailWell", true);
  head->addWidget(m_thumbnail);
  auto* words = new QVBoxLayout();
  words->setSpacing(1);
  auto* name = new QLabel(text(m_slot.label), this);
  name->setProperty("heading", true);
  m_file = new QLabel(this);
  m_file->setMinimumWidth(40);
  m_size = new QLabel(this);
  m_size->setProperty("quiet", true);
  words->addWidget(name);
  words->addWidget(m_file);
  words->addWidget(m_size);
  head->addLayout(words, 1);
  const QString label = text(m_slot.label);
  auto* choose = iconButton("open", tr("%1 map: choose a file").arg(label), this);
  m_reload = iconButton("reload", tr("%1 map: read the file again").arg(label), this);
  m_clear = iconButton("close", tr("%1 map: clear").arg(label), this);
  choose->setObjectName(objectName() + QStringLiteral(".choose"));
  m_clear->setObjectName(objectName() + QStringLiteral(".clear"));
  for (QToolButton* button : {choose, m_reload, m_clear}) head->addWidget(button, 0, Qt::AlignTop);
  static_cast<QVBoxLayout*>(layout())->addLayout(head);
  connect(choose, &QToolButton::clicked, this, &TextureRow::chooseRequested);
  connect(m_reload, &QToolButton::clicked, this, &TextureRow::reloadRequested);
  connect(m_clear, &QToolButton::clicked, this, &TextureRow::clearRequested);
}

void TextureRow::buildDetails() {
  const QString label = text(m_slot.label);
  const auto changed = [this](auto change) {
    TextureBinding next = m_binding;
    change(next);
    Q_EMIT bindingEdited(next, newGesture());
  };
  m_details = new QWidget(this);
  auto* grid = new QGridLayout(m_details);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(metrics::kGap);
  grid->setVerticalSpacing(metrics::kRowSpacing);
  grid->setColumnStretch(1, 1);
  grid->setColumnStretch(3, 1);
  const auto put = [&](int row, int column, const QString& words, QWidget* control, const char* id) {
    auto* name = new QLabel(words, m_details);
    name->setProperty("quiet", true);
    grid->addWidget(name, row, column);
    grid->addWidget(control, row, column + 1);
    control->setAccessibleName(tr("%1 map › %2").arg(label, words));
    control->setObjectName(objectName() + QLatin1Char('.') + QLatin1String(id));
  };
  m_space = new QuietComboBox(m_details);
  m_space->addItems({tr("Automatic"), QStringLiteral("sRGB"), tr("Linear"), tr("Raw")});
  put(0, 0, tr("Space"), m_space, "color_space");
  connect(m_space, &QComboBox::activated, this, [changed](int index) {
    static constexpr const char* kSpaces[] = {"", "srgb", "linear", "raw"};
    changed([&](TextureBinding& b) {
      b.colorSpace = index == 0 ? std::nullopt : std::optional<std::string>(kSpaces[index]);
    });
  });
  m_channel = new QuietComboBox(m_details);
  m_channel->addItems(
      {QStringLiteral("R"), QStringLiteral("G"), QStringLiteral("B"), QStringLiteral("A"), tr("Luminance")});
  put(0, 2, tr("Channel"), m_channel, "channel");
  m_channel->setVisible(m_slot.isScalar);
  grid->itemAtPosition(0, 2)->widget()->setVisible(m_slot.isScalar);
  connect(m_channel, &QComboBox::activated, this, [changed](int index) {
    changed([&](TextureBinding& b) { b.channel = static_cast<TextureChannel>(index); });
  });

  const auto number = [&](NumberField*& field, const NumberRange& range, int column, const QString& words,
                          const char* id, auto change) {
    field = new NumberField(range, m_details);
    put(1, column, words, field, id);
    connect(field, &NumberField::edited, this, [this, change](double value, Gesture gesture) {
      TextureBinding next = m_binding;
      change(next, static_cast<float>(value));
      Q_EMIT bindingEdited(next, gesture);
    });
  };
  number(m_tiling, NumberRange{0.001, 1000, 0, 10, {}}, 0, tr("Tiling"), "uv_scale", [](TextureBinding& b, float v) {
    b.uvScale = {v, v};
  });
  number(m_scale, NumberRange{-1000, 1000, 0, 2, {}}, 2, tr("Scale"), "scale",
         [](TextureBinding& b, float v) { b.scale = v; });

  const bool isNormal = m_slot.slot == TextureSlot::Normal || m_slot.slot == TextureSlot::DetailNormal;
  m_invert = new QCheckBox(tr("Invert"), m_details);
  m_flip = new QCheckBox(tr("Flip green (DirectX)"), m_details);
  m_invert->setAccessibleName(tr("%1 map › Invert").arg(label));
  m_flip->setAccessibleName(tr("%1 map › Flip green").arg(label));
  m_invert->setVisible(m_slot.isScalar);
  m_flip->setVisible(isNormal);
  grid->addWidget(m_invert, 2, 0, 1, 4);
  grid->addWidget(m_flip, 3, 0, 1, 4);
  connect(m_invert, &QCheckBox::toggled, this,
          [changed](bool on) { changed([&](TextureBinding& b) { b.invert = on; }); });
  connect(m_flip, &QCheckBox::toggled, this,
          [changed](bool on) { changed([&](TextureBinding& b) { b.flipGreen = on; }); });
  static_cast<QVBoxLayout*>(layout())->addWidget(m_details);
}

void TextureRow::showBinding(const TextureBinding& binding, const std::shared_ptr<const Image>& image) {
  const bool newPicture = image != m_image;
  m_binding = binding;
  m_image = image;
  const bool present = binding.present();
  if (!present)
    m_thumbnail->setPixmap({}), m_thumbnail->setText(QStringLiteral("+"));
  else if (newPicture && image)
    m_thumbnail->setPixmap(QPixmap::fromImage(mapThumbnail(*image, kThumbnailSide)));
  const QString name = image && binding.path.starts_with("embedded:")
                           ? text(image->name)
                           : pathText(std::filesystem::path(binding.path).filename());
  m_file->setText(present ? m_file->fontMetrics().elidedText(name, Qt::ElideMiddle, 190) : QString());
  m_file->setToolTip(present ? text(binding.path) : QString());
  m_file->setVisible(present);
  m_size->setText(!present ? tr("Drop an image here, or choose one") : image ? describe(*image) : tr("not loaded"));
  m_clear->setVisible(present);
  m_reload->setVisible(present && !namesNoFile(binding.path));
  m_details->setVisible(present);
  const QSignalBlocker blockers[] = {QSignalBlocker(m_space), QSignalBlocker(m_channel), QSignalBlocker(m_invert),
                                     QSignalBlocker(m_flip)};
  const std::string space = binding.colorSpace.value_or("");
  m_space->setCurrentIndex(space == "srgb" ? 1 : space == "linear" ? 2 : space == "raw" ? 3 : 0);
  if (!space.empty() && m_space->currentIndex() == 0) m_space->setCurrentIndex(-1);
  m_space->setPlaceholderText(text(space));
  m_channel->setCurrentIndex(static_cast<int>(binding.channel));
  m_invert->setChecked(binding.invert);
  m_flip->setChecked(binding.flipGreen);
  m_tiling->showNumber(static_cast<double>(binding.uvScale[0]));
  m_scale->showNumber(static_cast<double>(binding.scale));
}

void TextureRow::markDrop(bool active) {
  setProperty("dropActive", active);
  style()->unpolish(this);
  style()->polish(this);
}

void TextureRow::dragEnterEvent(QDragEnterEvent* event) {
  if (!event->mimeData()->hasUrls() || !event->mimeData()->urls().first().isLocalFile()) return;
  event->acceptProposedAction();
  markDrop(true);
}
void TextureRow::dragLeaveEvent(QDragLeaveEvent*) { markDrop(false); }
void TextureRow::dropEvent(QDropEvent* event) {
  markDrop(false);
  event->acceptProposedAction();
  Q_EMIT fileChosen(event->mimeData()->urls().first().toLocalFile());
}
void TextureRow::mouseDoubleClickEvent(QMouseEvent*) { Q_EMIT chooseRequested(); }

void TextureRow::contextMenuEvent(QContextMenuEvent* event) {
  QMenu menu(this);
  connect(menu.addAction(tr("Choose file…")), &QAction::triggered, this, &TextureRow::chooseRequested);
  QAction* reload = menu.addAction(tr("Read the file again"));
  QAction* clear = menu.addAction(tr("Clear"));
  reload->setEnabled(m_binding.present());
  clear->setEnabled(m_binding.present());
  connect(reload, &QAction::triggered, this, &TextureRow::reloadRequested);
  connect(clear, &QAction::triggered, this, &TextureRow::clearRequested);
  menu.exec(event->globalPos());
}

}  // namespace dermis
