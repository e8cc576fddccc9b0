// The specular layer that the material's specular.* say: two lobes over a dielectric.
#ifndef DERMIS_TWO_LOBES
#define DERMIS_TWO_LOBES

#define DERMIS_LOBES 2
#include "generated/material_block.glsl"
#include "models/layered.glsl"

// `slope_variance` is what the normal maps leave unseen (MappedNormal).
Layer twoLobes(float perceptual_roughness, float slope_variance, float intensity) {
  Layer layer;
  layer.body_f0 = u_material.specular_f0.w > 0.5 ? u_material.specular_f0.rgb : vec3(F0_fromIor(u_material.specular_ior));
  layer.metal_f0 = vec3(1.0);
  layer.metallic = 0.0;
  vec2 lobes = clamp(perceptual_roughness * u_material.specular_lobe_scale, kMinPerceptualRoughness, 1.0);
  layer.first = Lobe(widenedRoughness(lobes.x, slope_variance), intensity * (1.0 - u_material.specular_lobe_mix));
  layer.second = Lobe(widenedRoughness(lobes.y, slope_variance), intensity * u_material.specular_lobe_mix);
  return layer;
}

#endif
