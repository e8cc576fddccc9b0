// Diffusion for a moving picture, in two passes: along the picture's horizontal on the surface, then across it. Each pass weighs cells of
// a line through the point by how much of the profile's line spread they hold, so a straight edge of light along either direction
// comes out as it should; light from one point spreads less roundly than in disc.frag. Distances are millimetres on the tangent plane;
// places off it, by the depth buffer, count for less, and the sum is divided by the weights found. The perspective of a step is taken
// from the point itself. Drawn with the depth test, so that only the model's pixels cost anything.
#include "subsurface/profiles.glsl"
#include "subsurface/surface_points.glsl"

#ifdef DERMIS_FIRST
layout(location = 0) out vec4 o_spread;  // a: depth
#else
#include "subsurface/compose.glsl"
layout(binding = 27) uniform sampler2D u_spread;  // a: depth, so that each tap is one fetch; 0 where nothing diffuses
#endif

#ifdef DERMIS_ONE_PROFILE
#define PROFILE 0
#else
#define PROFILE profile
#endif

struct Line {
  vec2 start, step;    // on the screen: of the point, of a millimetre along the line
  vec3 depth_plane;    // depth = x · column + y · row + z: affine on the screen for any plane
  float height_scale;  // from a difference of depths to one along the normal, mm
};

struct Gathered {
  vec3 light, weight;
};

void gather(Line line, float x_mm, vec3 cell, int id, float tolerance, inout Gathered sum) {
  ivec2 there = ivec2(floor(line.start + x_mm * line.step));
  ivec2 inside = clamp(there, ivec2(0), ivec2(u_viewport.xy) - 1);
#ifdef DERMIS_FIRST
  vec4 other = texelFetch(u_entering, inside, 0);
  float depth = texelFetch(u_depth, inside, 0).r;
  float share = other.a;
#else
  vec4 other = texelFetch(u_spread, inside, 0);
  float depth = other.a;
  const float share = 1.0;
#endif
  float height = (depth - dot(line.depth_plane, vec3(vec2(there) + 0.5, 1.0))) * line.height_scale;
  float together = inside == there && depth > 0.0 ? belongsTogether(height, abs(x_mm), tolerance) : 0.0;
#ifndef DERMIS_ONE_PROFILE
  if (int(texelFetch(u_geometry, inside, 0).z + 0.5) != id) together = 0.0;
#endif
  vec3 weight = cell * (together * share);
  sum.light += weight * other.rgb;
  sum.weight += weight;
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 entering = texelFetch(u_entering, pixel, 0);
  vec4 geometry = texelFetch(u_geometry, pixel, 0);
  float depth = texelFetch(u_depth, pixel, 0).r;
  int id = int(geometry.z + 0.5);
  if (id == 0 || entering.a <= 0.0) {
#ifdef DERMIS_FIRST
    o_spread = vec4(0.0);
#else
    compose(pixel, entering.rgb, entering.rgb, depth > 0.0);
#endif
    return;
  }

  int profile = id - 1;
  vec3 p = worldAt(gl_FragCoord.xy, depth);
  vec3 normal = fromOctahedron(geometry.xy);
  vec3 along, across;
  tangentFrame(normal, along, across);
#ifdef DERMIS_FIRST
  vec3 axis = along, other_axis = across;
  const float kNoiseShift = 0.0;
#else
  vec3 axis = across, other_axis = along;
  const float kNoiseShift = 0.5;
#endif
  // What a millimetre along each axis does to column, row and depth; from that the depth of the tangent plane everywhere.
  float unit = 1.0 / u_units.x;
  vec4 clip = u_view_projection * vec4(p, 1.0);
  vec4 step_a = u_view_projection * vec4(axis * unit, 0.0);
  vec4 step_b = u_view_projection * vec4(other_axis * unit, 0.0);
  vec3 slope_a = (step_a.xyz - clip.xyz / clip.w * step_a.w) / clip.w;
  vec3 slope_b = (step_b.xyz - clip.xyz / clip.w * step_b.w) / clip.w;
  slope_a.xy *= 0.5 * u_viewport.xy;
  slope_b.xy *= 0.5 * u_viewport.xy;
  float determinant = slope_a.x * slope_b.y - slope_a.y * slope_b.x;
  determinant = abs(determinant) < 1e-9 ? 1e-9 : determinant;
  vec2 gradient = vec2(slope_a.z * slope_b.y - slope_b.z * slope_a.y, slope_b.z * slope_a.x - slope_a.z * slope_b.x) / determinant;

  Line line;
  line.start = gl_FragCoord.xy;
  line.step = slope_a.xy;
  line.depth_plane = vec3(gradient, depth - dot(gradient, gl_FragCoord.xy));
  // The normal's own step in depth, at the same place of the screen: depth per mm of height along it.
  vec4 step_n = u_view_projection * vec4(normal * unit, 0.0);
  vec3 slope_n = (step_n.xyz - clip.xyz / clip.w * step_n.w) / clip.w;
  slope_n.xy *= 0.5 * u_viewport.xy;
  float depth_per_mm = slope_n.z - dot(gradient, slope_n.xy);
  line.height_scale = 1.0 / (abs(depth_per_mm) < 1e-20 ? 1e-20 : depth_per_mm);

  // Where in its cell each tap falls differs from pixel to pixel, so that few taps make no steps.
  float noise = fract(gradientNoise(gl_FragCoord.xy + u_window.xy) + kNoiseShift);
  float tolerance = u_profile_boundary[PROFILE].w;
  Gathered sum = Gathered(vec3(0.0), vec3(0.0));
  vec4 cell = u_profile_cells[PROFILE * (kSideTaps + 2)];
  gather(line, (2.0 * noise - 1.0) * cell.w, cell.rgb, id, tolerance, sum);
  for (int i = 1; i <= kSideTaps; ++i) {
    cell = u_profile_cells[PROFILE * (kSideTaps + 2) + i];
    float width = u_profile_cells[PROFILE * (kSideTaps + 2) + i + 1].w - cell.w;
    gather(line, cell.w + noise * width, cell.rgb, id, tolerance, sum);
    gather(line, -cell.w - (1.0 - noise) * width, cell.rgb, id, tolerance, sum);
  }
  vec3 light = sum.light / max(sum.weight, vec3(1e-20));
#ifdef DERMIS_FIRST
  light = mix(entering.rgb, light, greaterThan(sum.weight, vec3(1e-18)));
  o_spread = vec4(light, depth);
#else
  light = mix(texelFetch(u_spread, pixel, 0).rgb, light, greaterThan(sum.weight, vec3(1e-18)));
  light = mix(light, entering.rgb, u_profile_direct[PROFILE].rgb);
  compose(pixel, entering.rgb, mix(entering.rgb, light, entering.a), true);
#endif
}
