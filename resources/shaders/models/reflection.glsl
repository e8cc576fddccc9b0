// The lab's mirror, as published: the sharp environment along reflect(−v, n), encoded with pow 1/2.2 in the shader. What is written is
// display-referred; its natural view is Raw.
#include "brdf.glsl"
#include "frame_block.glsl"
#include "lighting/environment.glsl"
#include "surface_types.glsl"

Shading shade(Surface s) {
  vec3 normal = facingNormal(s);
  vec3 mirrored = environmentSharp(reflect(-s.view, normal));

  vec3 colour = min(pow(max(mirrored, 0.0), vec3(1.0 / 2.2)), vec3(kHalfMax));
  return plainShading(vec3(0.0), colour, 1.0, normal);
}
