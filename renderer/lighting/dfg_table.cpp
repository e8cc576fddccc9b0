#include "lighting/dfg_table.h"

#include <cstring>
#include <string_view>
#include <vector>

#include "lighting/dfg_layout.h"

/// Embedded by the build: the output of make_dfg_tables.
extern "C" const char dermis_dfg_tables[];

namespace dermis {
namespace {

gl::Texture tableTexture(std::string_view label, int index) {
  constexpr std::size_t kFloats = std::size_t{2} * kDfgEdge * kDfgEdge;
  std::vector<float> texels(kFloats);
  std::memcpy(texels.data(), dermis_dfg_tables + static_cast<std::size_t>(index) * kFloats * sizeof(float),
              kFloats * sizeof(float));
  gl::Texture texture =
      gl::Texture::create({.format = GL_RG32F, .width = kDfgEdge, .height = kDfgEdge, .label = std::string(label)});
  texture.upload(0, GL_RG, GL_FLOAT, texels.data());
  return texture;
}

}  // namespace

DfgTables DfgTables::create() {
  DfgTables tables;
  tables.m_smith = tableTexture("DFG, height-correlated Smith", 0);
  tables.m_schlickIbl = tableTexture("DFG, Schlick-GGX for image light", 1);
  return tables;
}

void DfgTables::bind() const {
  m_smith.bind(kSmithUnit);
  m_schlickIbl.bind(kSchlickIblUnit);
}

}  // namespace dermis
