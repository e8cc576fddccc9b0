// What the passes of one frame share.
#pragma once

#include <set>
#include <string>

#include "gl/shader_library.h"
#include "passes/camera_matrices.h"
#include "passes/render_targets.h"
#include "passes/scene_resources.h"
#include "renderer.h"

namespace dermis {

/// Collects messages, each text once until it is cleared: a broken shader is not said sixty times a second.
class MessageLog {
 public:
  void say(const std::string& message) {
    if (m_said.insert(message).second) m_new.push_back(message);
  }
  [[nodiscard]] Warnings take() { return std::exchange(m_new, {}); }
  void clear() { m_said.clear(); }

 private:
  std::set<std::string> m_said;
  Warnings m_new;
};

struct FrameContext {
  const FrameRequest& request;
  const ResolvedScene& scene;
  const SceneResources& resources;
  const RenderTargets& targets;
  gl::ShaderLibrary& shaders;
  MessageLog& messages;
  CameraMatrices camera;       ///< of what the images hold, the targets' data window
  CameraMatrices wholeCamera;  ///< of the picture
  bool multisampled = false;
  int level = 0;  ///< of the model's triangles (Geometry::levelWithin)

  /// Of what the images hold; request.size is the picture's.
  [[nodiscard]] glm::ivec2 size() const { return targets.dataWindow().extent(); }
  /// The level that a part is drawn with: blended ones are few, displaced ones have their own.
  [[nodiscard]] int levelOf(const SlotResources& slot) const {
    return slot.kind == DrawKind::Opaque && !slot.displaced ? level : 0;
  }

  /// The program in use, or null (and a message) where it doesn't compile.
  const gl::Program* useProgram(const gl::ProgramSources& sources) const {
    auto program = shaders.program(sources);
    if (!program) {
      messages.say(program.error().message);
      return nullptr;
    }
    (*program)->use();
    return *program;
  }
};

}  // namespace dermis
