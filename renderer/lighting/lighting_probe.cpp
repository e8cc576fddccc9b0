#include "lighting/lighting_probe.h"

#include <cmath>

#include "lighting/dfg_table.h"
#include "passes/uniform_blocks.h"

namespace dermis {

Result<std::vector<glm::vec3>> probeLighting(gl::ShaderLibrary& shaders, const EnvironmentMap* map,
                                             std::span<const LightingQuery> queries, float rotationDegrees,
                                             float exposureStops) {
  if (queries.empty()) return std::vector<glm::vec3>{};
  gl::ProgramSources sources;
  sources.compute = "lighting/probe.comp";
  const auto program = shaders.program(sources);
  if (!program) return tl::unexpected(program.error());

  FrameBlock frame;
  frame.environmentFromWorld = environmentFromWorld(rotationDegrees);
  frame.environmentScale.x = std::exp2(exposureStops) * (map != nullptr ? map->scale() : 1.0F);
  const gl::Buffer block = gl::Buffer::fixed("probe, frame", bytesOf(frame));
  const gl::Buffer asked = gl::Buffer::fixed("probe, queries", std::as_bytes(queries));
  const gl::Buffer answers = gl::Buffer::writable("probe, answers", queries.size() * sizeof(glm::vec4));
  const DfgTables tables = DfgTables::create();

  glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  (*program)->use();
  block.bindUniform(kFrameBinding);
  asked.bindStorage(0);
  answers.bindStorage(1);
  tables.bind();
  if (map != nullptr) map->bind();
  constexpr std::size_t kGroup = 64;
  glDispatchCompute(static_cast<GLuint>((queries.size() + kGroup - 1) / kGroup), 1, 1);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);

  std::vector<glm::vec4> read(queries.size());
  glGetNamedBufferSubData(answers.id(), 0, static_cast<GLsizeiptr>(read.size() * sizeof(glm::vec4)), read.data());
  return std::vector<glm::vec3>(read.begin(), read.end());
}

}  // namespace dermis
