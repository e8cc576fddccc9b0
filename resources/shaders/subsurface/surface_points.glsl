// Points of the surface under the pixels, and where points of space lie on the screen. World space, scene units; pixels count from the
// lower left, their centres at halves.
#ifndef DERMIS_SURFACE_POINTS
#define DERMIS_SURFACE_POINTS

#include "frame_block.glsl"
#include "octahedron.glsl"

layout(binding = 21) uniform sampler2D u_entering;  // a: share that diffuses
layout(binding = 22) uniform sampler2D u_geometry;  // vertex normal on the octahedron, profile id, thickness
layout(binding = 23) uniform sampler2D u_depth;     // reversed: 0 where nothing is

// What the depth buffer says lies at a place of the screen.
vec3 worldAt(vec2 screen, float depth) {
  vec4 world = u_inverse_view_projection * vec4(screen * u_viewport.zw * 2.0 - 1.0, depth, 1.0);
  return world.xyz / world.w;
}

// By how much that moves for a step on the screen that keeps the depth.
vec3 worldStep(vec2 screen_step, float depth) {
  float w = u_inverse_view_projection[2].w * depth + u_inverse_view_projection[3].w;
  vec2 clip = 2.0 * screen_step * u_viewport.zw / w;
  return u_inverse_view_projection[0].xyz * clip.x + u_inverse_view_projection[1].xyz * clip.y;
}

vec3 towardsViewer(vec3 position) {
  return u_camera_position.w > 0.5 ? -u_camera_forward.xyz : normalize(u_camera_position.xyz - position);
}

// Two unit vectors in the surface: the first as near to the picture's horizontal as the surface lets it be.
void tangentFrame(vec3 normal, out vec3 along, out vec3 across) {
  vec3 right = vec3(u_view[0][0], u_view[1][0], u_view[2][0]);
  vec3 up = vec3(u_view[0][1], u_view[1][1], u_view[2][1]);
  vec3 flat_right = right - normal * dot(normal, right);
  float length2 = dot(flat_right, flat_right);
  along = length2 > 1e-4 ? flat_right * inversesqrt(length2) : normalize(up - normal * dot(normal, up));
  across = cross(normal, along);
}

// A position in clip space without its depth, and where that is on the screen.
vec3 clipOf(vec4 world) {
  vec4 clip = u_view_projection * world;
  return clip.xyw;
}
vec2 screenOf(vec3 clip) { return (clip.xy / clip.z * 0.5 + 0.5) * u_viewport.xy; }

// Evenly spread over neighbouring pixels of the picture: Jimenez 2014, "Next Generation Post Processing in Call of Duty", interleaved
// gradient noise.
float gradientNoise(vec2 screen) { return fract(52.9829189 * fract(dot(screen, vec2(0.06711056, 0.00583715)))); }

#endif
