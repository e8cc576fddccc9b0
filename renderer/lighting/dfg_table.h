// The two tables of the split sum's BRDF half, resident on the GPU.
#pragma once

#include "gl/gl_objects.h"

namespace dermis {

/// u_dfg_smith and u_dfg_schlick_ibl of lighting/dfg.glsl, made from the tables that the build computed.
class DfgTables {
 public:
  static constexpr GLuint kSmithUnit = 18, kSchlickIblUnit = 19;

  [[nodiscard]] static DfgTables create();
  void bind() const;
  [[nodiscard]] const gl::Texture& smith() const { return m_smith; }
  [[nodiscard]] const gl::Texture& schlickIbl() const { return m_schlickIbl; }

 private:
  gl::Texture m_smith, m_schlickIbl;
};

}  // namespace dermis
