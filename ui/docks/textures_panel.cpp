#include "ui/docks/textures_panel.h"

#include <QFileDialog>
#include <QLabel>
#include <QSettings>
#include <QVBoxLayout>
#include <algorithm>

#include "core/material/parameter_table.h"
#include "ui/docks/texture_row.h"
#include "ui/document/document.h"
#include "ui/document/loading.h"
#include "ui/text.h"
#include "ui/theme/metrics.h"

namespace dermis {

bool readsMap(ShadingModel model, TextureSlot slot) {
  const auto uses = [model](std::string_view id) {
    const ParameterRow* row = findParameter(id);
    return row != nullptr && row->usedBy(model);
  };
  switch (slot) {
    case TextureSlot::Normal:
      return uses("surface.normal_strength") || model == ShadingModel::Thesis;
    case TextureSlot::DetailNormal:
    case TextureSlot::DetailMask:
      return uses("surface.detail_strength");
    case TextureSlot::Thickness:
      return uses("transmission.weight");
    default:
      break;
  }
  const auto rows = parameterTable();
  return std::any_of(rows.begin(), rows.end(),
                     [&](const ParameterRow& row) { return row.map == slot && row.usedBy(model); });
}

TexturesPanel::TexturesPanel(Document& document, Loading& loading, QWidget* parent)
    : Panel(parent), m_document(document), m_loading(loading) {
  m_title = new QLabel(this);
  m_title->setProperty("quiet", true);
  strip()->addWidget(m_title);
  auto* holder = new QWidget(this);
  auto* column = new QVBoxLayout(holder);
  column->setContentsMargins(metrics::kMargin, metrics::kMargin, metrics::kMargin, metrics::kMargin);
  column->setSpacing(metrics::kGap + 2);
  for (const TextureSlotRow& slot : textureSlots()) {
    auto* row = new TextureRow(slot, holder);
    m_rows.at(static_cast<std::size_t>(slot.slot)) = row;
    column->addWidget(row);
    const TextureSlot which = slot.slot;
    connect(row, &TextureRow::fileChosen, this, [this, which](const QString& path) { assign(which, path); });
    connect(row, &TextureRow::chooseRequested, this, [this, which] { choose(which); });
    connect(row, &TextureRow::clearRequested, this,
            [this, which] { m_document.setTexture(m_document.currentSlot(), which, TextureBinding{}, nullptr); });
    connect(row, &TextureRow::reloadRequested, this, [this, which] {
      if (const SlotLook* look = m_document.currentLook()) assign(which, text(look->worn.material.texture(which).path));
    });
    connect(row, &TextureRow::bindingEdited, this, [this, which](const TextureBinding& binding, Gesture gesture) {
      const SlotLook* look = m_document.currentLook();
      if (look != nullptr)
        m_document.setTexture(m_document.currentSlot(), which, binding,
                              look->worn.images.at(static_cast<std::size_t>(which)), gesture);
    });
  }
  m_nothing = new QLabel(tr("This shading model reads no maps."), holder);
  m_nothing->setProperty("quiet", true);
  column->addWidget(m_nothing);
  addWidget(holder);
  finish();
  connect(&m_document, &Document::changed, this, [this](Change what) {
    if (what == Change::Everything || what == Change::Material) refresh();
  });
  connect(&m_document, &Document::currentSlotChanged, this, &TexturesPanel::refresh);
  refresh();
}

void TexturesPanel::assign(TextureSlot slot, const QString& path) {
  m_loading.assignTexture(m_document.currentSlot(), slot, toPath(path));
}

void TexturesPanel::choose(TextureSlot slot) {
  const QString folder = QSettings().value(QStringLiteral("folders/textures")).toString();
  const QString path =
      QFileDialog::getOpenFileName(this, tr("Choose the %1 map").arg(text(textureSlotRow(slot).label).toLower()),
                                   folder, tr("Images (%1);;All files (*)").arg(namePatterns(FileKind::Image)));
  if (path.isEmpty()) return;
  QSettings().setValue(QStringLiteral("folders/textures"), QFileInfo(path).path());
  assign(slot, path);
}

void TexturesPanel::refresh() {
  const SlotLook* look = m_document.currentLook();
  setEnabled(look != nullptr);
  if (look == nullptr) return;
  m_title->setText(tr("Maps of “%1”").arg(m_document.currentSlot()));
  bool any = false;
  for (const TextureSlotRow& slot : textureSlots()) {
    TextureRow* row = m_rows.at(static_cast<std::size_t>(slot.slot));
    const TextureBinding& binding = look->worn.material.texture(slot.slot);
    const bool shown = readsMap(look->worn.material.model, slot.slot);
    row->setVisible(shown);
    any = any || shown;
    row->showBinding(binding, look->worn.images.at(static_cast<std::size_t>(slot.slot)));
  }
  m_nothing->setVisible(!any);
}

}  // namespace dermis
