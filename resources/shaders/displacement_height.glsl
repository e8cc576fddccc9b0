// Heights of a displaced surface, in scene units along its directions. Only where the slot has a displacement map.
#ifndef DERMIS_DISPLACEMENT_HEIGHT
#define DERMIS_DISPLACEMENT_HEIGHT

#include "frame_block.glsl"
#include "generated/material_block.glsl"
#include "material_maps.glsl"

float heightOf(vec4 texel) {
  float value = dot(texel, u_maps[kMapDisplacement].channel) * u_maps[kMapDisplacement].transform.x +
                u_maps[kMapDisplacement].transform.y;
  return (value - u_material.surface_displacement_midlevel) * u_material.surface_displacement_mm / u_units.x;
}

#ifdef DERMIS_TILES
// Without a tile nothing is displaced.
float heightLod(vec2 uv, float lod) {
  vec3 place = tilePlace(kMapDisplacement, uv * mapTiling(kMapDisplacement));
  return place.z < 0.0 ? 0.0 : heightOf(textureLod(u_map_displacement, place, lod));
}
#else
float heightLod(vec2 uv, float lod) { return heightOf(textureLod(u_map_displacement, uv * mapTiling(kMapDisplacement), lod)); }
#endif

#endif
