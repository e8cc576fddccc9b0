// From textures of a frame to images in memory, first row on top.
#pragma once

#include <glm/glm.hpp>

#include "core/image/image.h"
#include "gl/gl_objects.h"
#include "renderer.h"

namespace dermis {

/// The mean of `samples`. Beauty RGBA premultiplied; the other radiances RGB, premultiplied; Normal RGB, Occlusion,
/// Thickness and Depth one channel, the mean over what covers the pixel and 0 where nothing does; Energy one channel,
/// premultiplied; ProfileId the largest number that touched the pixel.
[[nodiscard]] Image aovFromSums(Aov aov, const gl::Texture& sums, int samples);
/// The same where nothing was drawn.
[[nodiscard]] Image blackAov(Aov aov, glm::ivec2 size);

/// U16 where `wide`, else U8.
[[nodiscard]] Image displayFromTexture(const gl::Texture& texture, bool wide);
[[nodiscard]] Image blackDisplay(glm::ivec2 size, bool wide);

}  // namespace dermis
