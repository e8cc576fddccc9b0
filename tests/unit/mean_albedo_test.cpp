// The mean albedo of a textured material: over the surface, not over the image.
#include "core/scene/mean_albedo.h"

#include <gtest/gtest.h>

#include "core/scene/primitives.h"

namespace dermis {
namespace {

ResolvedScene planeWith(std::vector<unsigned char> texels, int width, int height) {
  ResolvedScene scene;
  scene.model = std::make_shared<Model>(makePlane());
  scene.slots.resize(1);
  scene.slots[0].material.parameters.baseAlbedo.rgb = {1.0F, 0.5F, 0.25F};
  auto image = std::make_shared<Image>();
  image->width = width;
  image->height = height;
  image->channels = 1;
  for (const unsigned char texel : texels) image->pixels.push_back(static_cast<std::byte>(texel));
  scene.slots[0].images.at(static_cast<std::size_t>(TextureSlot::Albedo)) = image;
  return scene;
}

TEST(MeanAlbedo, WithoutAMapIsTheColour) {
  ResolvedScene scene = planeWith({255}, 1, 1);
  scene.slots[0].images.fill(nullptr);
  EXPECT_EQ(meanAlbedo(scene, 0), glm::vec3(1.0F, 0.5F, 0.25F));
}

TEST(MeanAlbedo, DecodesAndAverages) {
  // Half black, half white: the mean of the light, not of the code values.
  ResolvedScene scene = planeWith({0, 255, 255, 0}, 2, 2);
  EXPECT_NEAR(meanAlbedo(scene, 0).x, 0.5F, 0.01F);
  EXPECT_NEAR(meanAlbedo(scene, 0).y, 0.25F, 0.005F);
  scene = planeWith({188}, 1, 1);
  EXPECT_NEAR(meanAlbedo(scene, 0).x, 0.5029F, 1e-3F) << "sRGB 188";
  scene.slots[0].material.texture(TextureSlot::Albedo).colorSpace = "linear";
  EXPECT_NEAR(meanAlbedo(scene, 0).x, 188.0F / 255.0F, 1e-4F);
}

TEST(MeanAlbedo, LooksOnlyWhereTheSurfaceIs) {
  // The surface uses the lower left quarter of the image, which is white; rows run from the top.
  ResolvedScene scene = planeWith({0, 0, 255, 0}, 2, 2);
  auto model = std::make_shared<Model>(*scene.model);
  for (glm::vec2& uv : model->uvs) uv *= 0.49F;
  scene.model = model;
  EXPECT_NEAR(meanAlbedo(scene, 0).x, 1.0F, 1e-4F);
}

}  // namespace
}  // namespace dermis
