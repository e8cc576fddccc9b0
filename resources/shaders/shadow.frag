// Depth only. Where a material has cut-outs they let light through.
#ifdef DERMIS_CUT_OUTS
#include "generated/material_block.glsl"
#include "material_maps.glsl"

in vec2 v_uv;

void main() {
  float alpha = u_material.metallic_roughness_opacity * colourMap(u_map_albedo, kMapAlbedo, MapPlace(v_uv, vec2(0.0), vec2(0.0))).a;
  if (alpha < u_material.metallic_roughness_alpha_cutoff) discard;
}
#else
void main() {}
#endif
