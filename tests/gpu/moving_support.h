// A scene with everything in it, and the frames of a window that draws on the CPU.
#pragma once

#include "gpu/frame_support.h"

namespace dermis::test {

/// A dense ball of skin with every kind of map that matters, thin on its left and thick on its right, in a studio, with
/// shadows on it and a lamp behind.
[[nodiscard]] ResolvedScene everything();

class MovingTest : public FrameTest {
 protected:
  static constexpr int kEdge = 160;  ///< pixels

  void SetUp() override;
  /// One that takes the short cuts of software GL, whatever the driver is.
  void makeSoftwareRenderer();
  /// A frame of a window in which something is being dragged.
  [[nodiscard]] FrameRequest movingFrame(const ResolvedScene& scene, const Window& window) const;
};

}  // namespace dermis::test
