// The Texture maps dock: the maps that the current material can wear.
#pragma once

#include <array>

#include "core/material/shading_model.h"
#include "core/material/texture_slot.h"
#include "ui/docks/panel.h"

class QLabel;

namespace dermis {

class Document;
class Loading;
class TextureRow;

/// Whether a shading model reads a map.
[[nodiscard]] bool readsMap(ShadingModel model, TextureSlot slot);

class TexturesPanel : public Panel {
  Q_OBJECT
 public:
  TexturesPanel(Document& document, Loading& loading, QWidget* parent = nullptr);

 private:
  void assign(TextureSlot slot, const QString& path);
  void choose(TextureSlot slot);
  void refresh();

  Document& m_document;
  Loading& m_loading;
  QLabel* m_title = nullptr;
  QLabel* m_nothing = nullptr;
  std::array<TextureRow*, kTextureSlotCount> m_rows{};
};

}  // namespace dermis
