// Runs a GLSL function over a list of inputs on the GPU, so that it can be compared with its C++ twin.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "gl/shader_library.h"

namespace dermis::test {

struct ProbeInput {
  glm::vec4 a{0.0F}, b{0.0F}, c{0.0F}, d{0.0F};
};
struct ProbeOutput {
  glm::vec4 a{0.0F}, b{0.0F};
};

/// `body` is GLSL that includes what it needs and defines `void probe(vec4 a, vec4 b, vec4 c, vec4 d, out vec4 x, out
/// vec4 y)`. Textures and uniform blocks are the caller's to bind. A shader that doesn't compile fails the test and
/// returns nothing.
[[nodiscard]] std::vector<ProbeOutput> runProbe(gl::ShaderLibrary& library, const std::string& body,
                                                std::span<const ProbeInput> inputs);

}  // namespace dermis::test
