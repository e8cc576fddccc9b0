// Cornea shell: a reflection added over a thin black that covers lens.opacity of what lies behind. Drawn after opaque things,
// premultiplied: picture = specular + (1 − alpha) · behind.
#define DERMIS_LOBES 1
#include "generated/material_block.glsl"
#include "models/layered.glsl"

const float kCorneaIor = 1.376;  // Gullstrand's schematic eye
const float kTearFilmPerceptualRoughness = 0.02;

Shading shade(Surface s) {
  Layer layer;
  layer.body_f0 = vec3(F0_fromIor(kCorneaIor));
  layer.metal_f0 = vec3(1.0);
  layer.metallic = 0.0;
  layer.first = Lobe(kTearFilmPerceptualRoughness, 1.0);

  vec3 normal = facingNormal(s);
  LayerPoint p = layerPoint(layer, normal, s.view);
  LayerLight lamps = layerLamps(layer, p, s.position, facingNormal(s));
  LayerLight image = layerImage(layer, p, normal, SkyLight(vec3(1.0), vec3(0.0), 1.0));

  Shading result = plainShading(vec3(0.0), inHalfRange(lamps.specular + image.specular), u_material.lens_opacity, normal);
  // The published blending, source alpha over one minus source alpha, dims the reflection as well.
  if (u_material.lens_seed_blending != 0) result.specular *= u_material.lens_opacity;
  return result;
}
