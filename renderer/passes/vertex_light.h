// Light that vertices know of: the share of the environment that arrives, what comes through the body and from other
// parts of the mesh. Computed when what it depends on changes, which the camera is not.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "gl/shader_library.h"
#include "passes/frame_context.h"
#include "passes/uniform_blocks.h"

namespace dermis {

/// What computes the light of a part's vertices. `withLamps`: light of lamps through the body is added to the far
/// side's (skin only), for pictures that don't ask for it at each pixel.
[[nodiscard]] gl::ProgramSources vertexLightProgram(const ResolvedScene& scene, std::size_t slot, bool withLamps);

class VertexLight {
 public:
  /// Brings the light of the vertices of frame.level up to date, of request.verticesAtOnce in this call; false where
  /// some are left. The frame's blocks, shadow maps and DFG tables are bound; `shadowRevision` changes with what the
  /// maps hold. Leaves program and maps changed.
  bool update(const FrameContext& frame, const FrameBlock& block, std::uint64_t shadowRevision, bool withLamps);
  /// Grows with every change of some vertex's light.
  [[nodiscard]] std::uint64_t revision() const { return m_revision; }

 private:
  std::uint64_t m_geometryRevision = 0;  ///< of the vertices that hold what m_known says
  /// All that a part's light was computed from, and the level whose vertices, and those of coarser ones, hold it.
  struct Known {
    std::vector<std::byte> key;
    int level = 0;
    std::uint32_t missing = 0;  ///< of the level's vertices, at the end of their range
  };
  std::vector<Known> m_known;  ///< by part
  std::uint64_t m_revision = 0;
};

}  // namespace dermis
