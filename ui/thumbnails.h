// Small pictures made on the CPU: an environment's panorama, a map, a material's ball.
#pragma once

#include <QImage>

#include "core/scene/resolved_scene.h"

namespace dermis {

/// A lat-long environment through a simple curve; a plain field for a constant one.
[[nodiscard]] QImage panoramaThumbnail(const EnvironmentImages& environment, QSize size);
/// A map as its file would show in an image viewer; alpha is ignored.
[[nodiscard]] QImage mapThumbnail(const Image& image, int side);
/// A ball under one soft light: says colour, gloss and metal at a glance; it is a sign, not a rendering.
[[nodiscard]] QImage materialBall(const Material& material, int side);

}  // namespace dermis
