// Planes and spheres lit by halves, for tests of diffusion.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/material/diffusion_profile.h"
#include "core/scene/primitives.h"
#include "gpu/frame_support.h"

namespace dermis::test {

/// Skin whose light comes from its environment alone and is multiplied by its albedo before diffusion: a map with a
/// black and a white half is a step of light.
[[nodiscard]] Material bareSkin();
/// Black on the left half, white on the right.
[[nodiscard]] std::shared_ptr<const Image> stepMap();
/// Two half planes side by side, the right one `behind` scene units farther away. Each looks at one half of the map
/// only, so that no filter blurs the step of light between them. In one slot, or in one each.
[[nodiscard]] Model twoHalves(float behind, bool sameSlot);
/// Those of `widthMm` in one plane and one slot, seen from the front by an orthographic camera that shows them whole.
[[nodiscard]] ResolvedScene stepScene(const Material& material, float widthMm);

/// What is seen across the edge: distance from it in mm (lit for x > 0) and colour, the mean along the edge.
struct EdgePoint {
  double x = 0.0;
  glm::dvec3 colour{0.0};
};

class SubsurfaceTest : public FrameTest {
 protected:
  /// One frame of a moving picture, as its beauty is before the display.
  Image moving(const ResolvedScene& scene);
  /// Rows around the middle of the picture averaged; `mmPerPixel` across the edge on the surface.
  [[nodiscard]] static std::vector<EdgePoint> acrossTheMiddle(const Image& image, double mmPerPixel, int rows = 8);
  /// Root of the mean square difference to the profile's edge over |x| < reachMm, the largest of the three channels;
  /// `pixelMm` is the footprint that the picture's samples average over, 0 where it is one at the centre. Written as
  /// CSV where the environment variable DERMIS_CURVES names a folder.
  static double errorOfEdge(const std::vector<EdgePoint>& seen, const DiffusionProfile& profile, double reachMm,
                            double pixelMm, const std::string& name);
};

}  // namespace dermis::test
