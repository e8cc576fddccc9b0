#include "gpu/models_probe.h"

#include <gtest/gtest.h>

namespace dermis::test {

std::vector<ProbeOutput> runProbe(gl::ShaderLibrary& library, const std::string& body,
                                  std::span<const ProbeInput> inputs) {
  static const std::string kFrame = R"(
layout(local_size_x = 64) in;
struct ProbeInput { vec4 a, b, c, d; };
struct ProbeOutput { vec4 a, b; };
layout(std430, binding = 0) readonly buffer Inputs { ProbeInput inputs[]; };
layout(std430, binding = 1) writeonly buffer Outputs { ProbeOutput outputs[]; };
void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= inputs.length()) return;
  ProbeOutput result = ProbeOutput(vec4(0.0), vec4(0.0));
  probe(inputs[i].a, inputs[i].b, inputs[i].c, inputs[i].d, result.a, result.b);
  outputs[i] = result;
}
)";
  gl::ProgramSources sources;
  sources.compute = "probe.comp";
  sources.defines = {"DERMIS_COMPUTE"};
  sources.generated["probe.comp"] = body + kFrame;
  const auto program = library.program(sources);
  EXPECT_TRUE(program.has_value()) << program.error().message;
  if (!program) return {};
  std::vector<ProbeOutput> results(inputs.size());
  const gl::Buffer in = gl::Buffer::fixed("probe inputs", std::as_bytes(inputs));
  const gl::Buffer out = gl::Buffer::writable("probe outputs", results.size() * sizeof(ProbeOutput));
  (*program)->use();
  in.bindStorage(0);
  out.bindStorage(1);
  glDispatchCompute(static_cast<GLuint>((inputs.size() + 63) / 64), 1, 1);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glGetNamedBufferSubData(out.id(), 0, static_cast<GLsizeiptr>(results.size() * sizeof(ProbeOutput)), results.data());
  return results;
}

}  // namespace dermis::test
