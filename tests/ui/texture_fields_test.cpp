// The fields of a map: on several slots each keeps what was not changed.
#include <QComboBox>

#include "ui/docks/texture_row.h"
#include "ui/editor_fixture.h"

namespace dermis {
namespace {

class TextureFields : public Editor {
 protected:
  const QString face = QStringLiteral("face"), eye = QStringLiteral("eye");
  void SetUp() override {
    Editor::SetUp();
    image = std::make_shared<Image>(Image{2, 2, 4, PixelType::U8, std::vector<std::byte>(16), "map"});
    wear(face, TextureChannel::R, {2.0F, 3.0F}, "face.png");
    wear(eye, TextureChannel::B, {1.0F, 1.0F}, "eye.png");
    document().setCurrentSlot(face);
    document().setEditedSlots({face, eye});
    reveal(find(QStringLiteral("textures.folder")));
  }
  void wear(const QString& slot, TextureChannel channel, std::array<float, 2> tiling, const char* path) {
    TextureBinding binding;
    binding.path = path;
    binding.channel = channel;
    binding.uvScale = tiling;
    document().setTexture(slot, TextureSlot::Roughness, binding, image);
  }
  const TextureBinding& of(const QString& slot) {
    return document().slotLook(slot)->worn.material.texture(TextureSlot::Roughness);
  }
  std::shared_ptr<const Image> image;
};

TEST_F(TextureFields, AnEditOfSeveralSlotsChangesOnlyItsOwnField) {
  auto* tiling = find<NumberField>(QStringLiteral("texture.roughness.uv_scale"));
  const int entries = undo().count();
  reveal(tiling);
  tiling->setValue(4.0);
  EXPECT_EQ(undo().count(), entries + 1);
  EXPECT_EQ(of(face).channel, TextureChannel::R);
  EXPECT_EQ(of(eye).channel, TextureChannel::B);
  EXPECT_EQ(of(face).path, "face.png");
  EXPECT_EQ(of(eye).path, "eye.png");
  EXPECT_EQ(of(eye).uvScale, (std::array<float, 2>{4.0F, 4.0F}));
  undo().undo();
  EXPECT_EQ(of(eye).uvScale, (std::array<float, 2>{1.0F, 1.0F}));
}

TEST_F(TextureFields, ATilingThatDiffersAcrossAndAlongKeepsItsShape) {
  auto* tiling = find<NumberField>(QStringLiteral("texture.roughness.uv_scale"));
  reveal(tiling);
  EXPECT_EQ(tiling->value(), 2.0);
  tiling->setValue(4.0);
  EXPECT_EQ(of(face).uvScale, (std::array<float, 2>{4.0F, 6.0F}));
}

TEST_F(TextureFields, AChannelGoesToAllAndLeavesTheirTilingAlone) {
  auto* channel = find<QComboBox>(QStringLiteral("texture.roughness.channel"));
  Q_EMIT channel->activated(1);
  EXPECT_EQ(of(face).channel, TextureChannel::G);
  EXPECT_EQ(of(eye).channel, TextureChannel::G);
  EXPECT_EQ(of(face).uvScale, (std::array<float, 2>{2.0F, 3.0F}));
  EXPECT_EQ(of(eye).uvScale, (std::array<float, 2>{1.0F, 1.0F}));
}

}  // namespace
}  // namespace dermis
