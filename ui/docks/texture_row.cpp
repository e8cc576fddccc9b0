#include "ui/docks/texture_row.h"

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QDesktopServices>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QStyle>
#include <QToolButton>
#include <QUrl>
#include <QVBoxLayout>
#include <cmath>

#include "core/base/file_reference.h"
#include "core/image/image_tiles.h"
#include "ui/docks/dropped_paths.h"
#include "ui/docks/panel.h"
#include "ui/rows/choice_editors.h"
#include "ui/rows/elided_label.h"
#include "ui/rows/number_field.h"
#include "ui/text.h"
#include "ui/theme/metrics.h"
#include "ui/thumbnails.h"
#include "ui/translation.h"

namespace dermis {
namespace {

constexpr int kThumbnailSide = 48;

QString describe(const Image& image) {
  static const QStringList kTypes = {TextureRow::tr("8-bit"), TextureRow::tr("16-bit"), TextureRow::tr("half"),
                                     TextureRow::tr("float")};
  static const QStringList kChannels = {TextureRow::tr("grey"), TextureRow::tr("grey + alpha"), QStringLiteral("RGB"),
                                        QStringLiteral("RGBA")};
  if (!image.tiles.empty())
    return (image.tiles.size() == 1 ? TextureRow::tr("UDIM, %1 tile, %2 × %3")
                                    : TextureRow::tr("UDIM, %1 tiles, %2 × %3 each"))
        .arg(image.tiles.size())
        .arg(image.width)
        .arg(tileHeight(image));
  return QStringLiteral("%1 × %2  ·  %3 %4")
      .arg(image.width)
      .arg(image.height)
      .arg(kTypes[static_cast<int>(image.type)], kChannels[image.channels - 1]);
}

}  // namespace

TextureRow::TextureRow(const TextureSlotRow& slot, QWidget* parent) : QFrame(parent), m_slot(slot) {
  setObjectName(QStringLiteral("texture.") + text(slot.id));
  setAccessibleName(tr("Texture maps › %1").arg(tableText(slot.label)));
  setProperty("card", true);
  setAcceptDrops(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(metrics::kGap, metrics::kGap, metrics::kGap, metrics::kGap);
  column->setSpacing(metrics::kGap);
  buildHead();
  buildDetails();
  showBinding({}, nullptr, MapWatcher::State::Good);
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
  auto* name = new QLabel(tableText(m_slot.label), this);
  name->setProperty("heading", true);
  m_file = new ElidedLabel(this);
  m_size = new QLabel(this);
  m_size->setProperty("quiet", true);
  m_size->setWordWrap(true);  // what is wrong with a file takes more room than its size
  words->addWidget(name);
  words->addWidget(m_file);
  words->addWidget(m_size);
  m_locate = new QPushButton(tr("Locate…"), this);
  m_locate->setObjectName(objectName() + QStringLiteral(".locate"));
  m_locate->setAccessibleName(tr("%1 map: locate the missing file").arg(tableText(m_slot.label)));
  m_locate->setToolTip(tr("Say where the file is now; other missing maps that lie beside it come along"));
  words->addWidget(m_locate, 0, Qt::AlignLeft);
  head->addLayout(words, 1);
  connect(m_locate, &QPushButton::clicked, this, &TextureRow::locateRequested);
  const QString label = tableText(m_slot.label);
  auto* choose = iconButton("open", tr("%1 map: choose a file").arg(label), this);
  m_reload = iconButton("reload", tr("%1 map: read the file again").arg(label), this);
  m_clear = iconButton("close", tr("%1 map: clear").arg(label), this);
  choose->setObjectName(objectName() + QStringLiteral(".choose"));
  m_clear->setObjectName(objectName() + QStringLiteral(".clear"));
  m_reload->setObjectName(objectName() + QStringLiteral(".reload"));
  for (QToolButton* button : {choose, m_reload, m_clear}) head->addWidget(button, 0, Qt::AlignTop);
  static_cast<QVBoxLayout*>(layout())->addLayout(head);
  connect(choose, &QToolButton::clicked, this, &TextureRow::chooseRequested);
  connect(m_reload, &QToolButton::clicked, this, &TextureRow::reloadRequested);
  connect(m_clear, &QToolButton::clicked, this, &TextureRow::clearRequested);
}

void TextureRow::buildDetails() {
  const QString label = tableText(m_slot.label);
  const auto changed = [this](const BindingChange& change) { Q_EMIT bindingEdited(change, newGesture()); };
  m_details = new QWidget(this);
  auto* grid = new QGridLayout(m_details);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(metrics::kGap);
  grid->setVerticalSpacing(metrics::kRowSpacing);
  grid->setColumnStretch(1, 1);
  grid->setColumnStretch(3, 1);
  const auto put = [&](int row, int column, const QString& words, QWidget* control, const char* id,
                       const QString& meaning) {
    auto* name = new QLabel(words, m_details);
    name->setProperty("quiet", true);
    grid->addWidget(name, row, column);
    grid->addWidget(control, row, column + 1);
    control->setAccessibleName(tr("%1 map › %2").arg(label, words));
    control->setObjectName(objectName() + QLatin1Char('.') + QLatin1String(id));
    name->setToolTip(meaning);
    for (QWidget* each : {static_cast<QWidget*>(name), control}) each->setWhatsThis(meaning);
  };
  m_space = new QuietComboBox(m_details);
  m_space->addItems({tr("Automatic"), QStringLiteral("sRGB"), tr("Linear"), tr("Raw")});
  put(0, 0, tr("Space"), m_space, "color_space",
      tr("How the file's numbers are read: automatic goes by the map and the kind of file, linear is Rec.709, raw "
         "changes "
         "nothing"));
  m_space->setToolTip(m_space->whatsThis());
  connect(m_space, &QComboBox::activated, this, [changed](int index) {
    static constexpr const char* kSpaces[] = {"", "srgb", "linear", "raw"};
    changed([index](TextureBinding& b) {
      b.colorSpace = index == 0 ? std::nullopt : std::optional<std::string>(kSpaces[index]);
    });
  });
  m_channel = new QuietComboBox(m_details);
  m_channel->addItems(
      {QStringLiteral("R"), QStringLiteral("G"), QStringLiteral("B"), QStringLiteral("A"), tr("Luminance")});
  put(0, 2, tr("Channel"), m_channel, "channel",
      tr("Which channel of the file holds the value, as in packed maps; luminance weighs red, green and blue"));
  m_channel->setToolTip(m_channel->whatsThis());
  m_channel->setVisible(m_slot.isScalar);
  grid->itemAtPosition(0, 2)->widget()->setVisible(m_slot.isScalar);
  connect(m_channel, &QComboBox::activated, this, [changed](int index) {
    changed([index](TextureBinding& b) { b.channel = static_cast<TextureChannel>(index); });
  });

  const auto number = [&](NumberField*& field, const NumberRange& range, int column, const QString& words,
                          const char* id, const QString& meaning, auto change) {
    field = new NumberField(range, m_details);
    put(1, column, words, field, id, meaning);
    connect(field, &NumberField::edited, this, [this, change](double value, Gesture gesture) {
      Q_EMIT bindingEdited([change, value](TextureBinding& b) { change(b, static_cast<float>(value)); }, gesture);
    });
  };
  number(m_tiling, NumberRange{0.001, 1000, 0, 10, {}}, 0, tr("Tiling"), "uv_scale",
         tr("How often the map repeats across; a map that repeats otherwise upwards keeps its shape. 0.001 to 1000"),
         [](TextureBinding& b, float v) {
           // One that differs across and along keeps its shape.
           const float shape = b.uvScale[0] != 0.0F ? b.uvScale[1] / b.uvScale[0] : 1.0F;
           b.uvScale = {v, v * shape};
         });
  number(m_scale, NumberRange{-1000, 1000, 0, 2, {}}, 2, tr("Scale"), "scale",
         tr("What the map's value is multiplied with; of a normal map, how steep it is. −1000 to 1000"),
         [](TextureBinding& b, float v) { b.scale = v; });

  const bool isNormal = m_slot.slot == TextureSlot::Normal || m_slot.slot == TextureSlot::DetailNormal;
  m_invert = new QCheckBox(tr("Invert"), m_details);
  m_flip = new QCheckBox(tr("Flip green (DirectX)"), m_details);
  m_invert->setObjectName(objectName() + QStringLiteral(".invert"));
  m_flip->setObjectName(objectName() + QStringLiteral(".flip_green"));
  m_invert->setToolTip(tr("Read 1 − value: for gloss maps as roughness, and inverted masks"));
  m_flip->setToolTip(tr("For normal maps with −Y, as DirectX tools write them"));
  for (QCheckBox* box : {m_invert, m_flip}) box->setWhatsThis(box->toolTip());
  m_invert->setAccessibleName(tr("%1 map › Invert").arg(label));
  m_flip->setAccessibleName(tr("%1 map › Flip green").arg(label));
  m_invert->setVisible(m_slot.isScalar);
  m_flip->setVisible(isNormal);
  grid->addWidget(m_invert, 2, 0, 1, 4);
  grid->addWidget(m_flip, 3, 0, 1, 4);
  connect(m_invert, &QCheckBox::toggled, this,
          [changed](bool on) { changed([on](TextureBinding& b) { b.invert = on; }); });
  connect(m_flip, &QCheckBox::toggled, this,
          [changed](bool on) { changed([on](TextureBinding& b) { b.flipGreen = on; }); });
  static_cast<QVBoxLayout*>(layout())->addWidget(m_details);
}

void TextureRow::showBinding(const TextureBinding& binding, const std::shared_ptr<const Image>& image,
                             MapWatcher::State state) {
  const bool newPicture = image != m_image;
  m_binding = binding;
  m_image = image;
  const bool present = binding.present();
  const bool missing = present && state == MapWatcher::State::Missing;
  const bool broken = present && !missing && (image == nullptr || state == MapWatcher::State::Broken);
  if (!present || !image)
    m_thumbnail->setPixmap({}), m_thumbnail->setText(present ? QStringLiteral("?") : QStringLiteral("+"));
  else if (newPicture)
    drawThumbnail();
  const QString name = image && binding.path.starts_with("embedded:")
                           ? text(image->name)
                           : pathText(std::filesystem::path(binding.path).filename());
  m_file->setFullText(present ? name : QString());
  m_file->setToolTip(present ? text(binding.path) : QString());
  m_file->setVisible(present);
  const QString stays = image ? tr(", its last picture stays") : QString();
  m_size->setText(!present  ? tr("Drop an image here, or choose one")
                  : missing ? tr("The file is missing") + stays
                  : broken  ? tr("The file can't be read") + stays
                            : describe(*image));
  if (const bool warns = missing || broken; m_size->property("warning").toBool() != warns) {
    m_size->setProperty("warning", warns);
    m_size->style()->unpolish(m_size);
    m_size->style()->polish(m_size);
  }
  m_locate->setVisible(missing || (broken && !image));
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

void TextureRow::drawThumbnail() {
  const double ratio = devicePixelRatioF();
  QPixmap picture = QPixmap::fromImage(mapThumbnail(*m_image, static_cast<int>(std::lround(kThumbnailSide * ratio))));
  picture.setDevicePixelRatio(ratio);
  m_thumbnail->setPixmap(picture);
}

bool TextureRow::event(QEvent* event) {
  // Another screen may have more pixels.
  if (event->type() == QEvent::ScreenChangeInternal && m_image && m_binding.present()) drawThumbnail();
  return QFrame::event(event);
}

void TextureRow::markDrop(bool active) {
  setProperty("dropActive", active);
  style()->unpolish(this);
  style()->polish(this);
}

void TextureRow::dragEnterEvent(QDragEnterEvent* event) {
  if (localPaths(event->mimeData()).isEmpty()) return;
  event->acceptProposedAction();
  markDrop(true);
}
void TextureRow::dragLeaveEvent(QDragLeaveEvent*) { markDrop(false); }
void TextureRow::dropEvent(QDropEvent* event) {
  markDrop(false);
  event->acceptProposedAction();
  Q_EMIT dropped(localPaths(event->mimeData()));
}
void TextureRow::mouseDoubleClickEvent(QMouseEvent*) { Q_EMIT chooseRequested(); }

void TextureRow::reveal() { QDesktopServices::openUrl(QUrl::fromLocalFile(QFileInfo(text(m_binding.path)).path())); }

void TextureRow::contextMenuEvent(QContextMenuEvent* event) {
  QMenu menu(this);
  menu.setObjectName(QStringLiteral("texture.menu"));
  const bool present = m_binding.present();
  const bool isFile = present && !namesNoFile(m_binding.path);
  const auto add = [&](const QString& words, const char* id, bool enabled, auto slot) {
    QAction* action = menu.addAction(words);
    action->setObjectName(QLatin1String(id));
    action->setEnabled(enabled);
    connect(action, &QAction::triggered, this, slot);
  };
  add(tr("Choose file…"), "texture.choose", true, &TextureRow::chooseRequested);
  add(tr("Locate…"), "texture.locate", isFile, &TextureRow::locateRequested);
  add(tr("Read the file again"), "texture.reload", isFile, &TextureRow::reloadRequested);
  menu.addSeparator();
  add(tr("Show in the file manager"), "texture.reveal", isFile, &TextureRow::reveal);
  add(tr("Copy path"), "texture.copyPath", present,
      [this] { QApplication::clipboard()->setText(text(m_binding.path)); });
  menu.addSeparator();
  add(tr("Clear"), "texture.clear", present, &TextureRow::clearRequested);
  menu.exec(event->globalPos());
}

}  // namespace dermis
