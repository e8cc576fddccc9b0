// What is seen where there is no surface: the environment, or something made of it. Drawn at infinite depth.
#include "frame_block.glsl"
#include "lighting/environment.glsl"

// DERMIS_BACKGROUND is one of these.
#define BACKGROUND_ENVIRONMENT 0
#define BACKGROUND_IRRADIANCE 1
#define BACKGROUND_PREFILTERED 2

uniform float u_perceptual_roughness;
uniform float u_maximum;  // what the target holds

in vec2 v_clip;
layout(location = 0) out vec4 o_beauty;

void main() {
  // Reversed depth: 1 is the near plane. A point on it, seen from the camera, is the direction.
  vec4 near = u_inverse_view_projection * vec4(v_clip, 1.0, 1.0);
  vec3 direction = u_camera_position.w > 0.5 ? u_camera_forward.xyz
                                             : normalize(near.xyz / near.w - u_camera_position.xyz);
#if DERMIS_BACKGROUND == BACKGROUND_IRRADIANCE
  vec3 radiance = environmentIrradiance(direction);
#elif DERMIS_BACKGROUND == BACKGROUND_PREFILTERED
  vec3 radiance = environmentPrefiltered(direction, u_perceptual_roughness);
#else
  vec3 radiance = environmentSharp(direction);
#endif
  o_beauty = vec4(min(radiance, vec3(u_maximum)), 1.0);
}
