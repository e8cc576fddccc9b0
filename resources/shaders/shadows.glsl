// Which lights a point sees, and how far light has come through the body to it, from the lights' depth maps.
//
// A map holds the depth of what a light sees first, at the centres of its texels. A lit point is compared there, not where it lies: its
// surface is a plane for as long as half a texel, and what that plane's depth is at a texel's centre is known exactly (Isidoro 2006,
// "Shadow Mapping: GPU-based Tips and Techniques", receiver plane depth bias). So a lit plane needs no bias at any angle, and the edge of a
// shadow lies where it should; in a still picture the grid is moved with every sample, which makes it a step. What is left, rounding and
// facets, is taken care of by asking from a little above the surface, in scene units known for each map.
#ifndef DERMIS_SHADOWS
#define DERMIS_SHADOWS

#include "frame_block.glsl"

struct ShadowView {
  mat4 texel_from_world;  // of a position relative to the centre: texels and reversed depth
  vec4 plane_x;           // a world plane's coefficients in those
  vec4 plane_y;
  vec4 plane_z;
  vec4 texel;  // x width, scene units, in a perspective map at distance 1; y 1/depth range, 0 in a perspective map; z offset along the
               // normal; w layer, -1 where there is no map
};

layout(std140, binding = 3) uniform ShadowBlock {
  vec4 u_shadow_centre;  // xyz world; w texels across a map
  vec4 u_shadow_filter;  // x 1 between texels, 0 the nearest one
  ivec4 u_shadow_of[16];  // by light: x the first view of its cube, 0 if it has a single one, which is that of its own number
  ShadowView u_shadow_views[112];
};

layout(binding = 24) uniform sampler2DArray u_shadow_maps;

const float kSteepest = 20.0;  // tangent of the lowest light (3°) for which a plane's depth is followed
const float kInside = 1e9;     // depth of nothing: no light is held back there

// The view of a cube that a direction from the light lies in.
int shadowFace(vec3 d) {
  vec3 a = abs(d);
  if (a.x >= a.y && a.x >= a.z) return d.x > 0.0 ? 0 : 1;
  if (a.y >= a.z) return d.y > 0.0 ? 2 : 3;
  return d.z > 0.0 ? 4 : 5;
}

// The view of `light` that `position` falls in.
int shadowViewOf(int light, vec3 position) {
  int cube = u_shadow_of[light].x;
  return cube == 0 ? light : cube + shadowFace(position - u_lights[light].position_type.xyz);
}

// Four texels about a point, as textureGather orders them (0 1, 1 1, 1 0, 0 0), and how much each counts.
struct ShadowTexels {
  vec4 depth;
  vec4 weight;
  vec4 dx;  // from the point to their centres, texels
  vec4 dy;
};

ShadowTexels shadowTexels(vec2 texel, float layer, bool between) {
  vec2 corner = floor(texel - 0.5);
  vec2 f = texel - 0.5 - corner;
  ShadowTexels t;
  t.depth = textureGather(u_shadow_maps, vec3((corner + 1.0) / u_shadow_centre.w, layer));
  t.dx = vec4(0.0, 1.0, 1.0, 0.0) - f.x;
  t.dy = vec4(1.0, 1.0, 0.0, 0.0) - f.y;
  vec2 w = between ? f : step(0.5, f);
  t.weight = vec4((1.0 - w.x) * w.y, w.x * w.y, w.x * (1.0 - w.y), (1.0 - w.x) * (1.0 - w.y));
  return t;
}

// 1 where the light reaches `position`, 0 where something is in the way. `normal` is the unit vertex normal of the side that is seen; what
// it says of the surface's slope counts, so don't give one that a normal map has bent. 1 for lights without shadows.
float shadowAt(int light, vec3 position, vec3 normal) {
  ShadowView view = u_shadow_views[shadowViewOf(light, position)];
  if (view.texel.w < 0.0) return 1.0;
  vec3 p = position - u_shadow_centre.xyz + normal * view.texel.z;
  vec4 clip = view.texel_from_world * vec4(p, 1.0);
  vec3 q = clip.xyz / max(clip.w, 1e-6);
  // The surface's plane in texels and depth gives the depth's slope, as far as the light isn't too low. One that turns away has none that
  // the light could see.
  vec4 plane = vec4(normal, -dot(normal, p));
  float facing = dot(view.plane_z, plane);
  vec2 slope = vec2(dot(view.plane_x, plane), dot(view.plane_y, plane)) / -max(facing, 1e-20);
  if (facing <= 0.0) slope = vec2(0.0);
  float steepest = kSteepest * view.texel.x * (view.texel.y > 0.0 ? view.texel.y : q.z);
  slope = clamp(slope, -steepest, steepest);
  ShadowTexels t = shadowTexels(q.xy, view.texel.w, u_shadow_filter.x > 0.5);
  // Reversed depth: what is nearer to the light is larger.
  return dot(t.weight, step(t.depth, vec4(q.z) + slope.x * t.dx + slope.y * t.dy));
}

// The same for a point on the far side of a body: the surface that lies `thickness_mm` below `position`, whose normal is taken to be
// -normal. Tells whether the light that comes through starts in the sun, so to speak.
float shadowOfFarSide(int light, vec3 position, vec3 normal, float thickness_mm) {
  return shadowAt(light, position - normal * (thickness_mm / u_units.x), -normal);
}

// Millimetres that light has come through the body, from where the light enters it to `position`, which should lie a little inside:
// Jimenez, Whelan, Sundstedt & Gutierrez 2010, "Real-Time Realistic Skin Translucency": shrunk along -normal by `shrink_mm`
// (transmission.normal_scale), so that a thin rim isn't missed. Distances between texels are interpolated. Where the point itself is lit the
// result is about shrink_mm over the cosine; behind another object it is the distance to that. kInside for lights without a map.
float shadowThicknessMm(int light, vec3 position, vec3 normal, float shrink_mm) {
  vec3 inside = position - normal * (shrink_mm / u_units.x);
  ShadowView view = u_shadow_views[shadowViewOf(light, inside)];
  if (view.texel.w < 0.0) return kInside;
  vec4 clip = view.texel_from_world * vec4(inside - u_shadow_centre.xyz, 1.0);
  vec3 q = clip.xyz / max(clip.w, 1e-6);
  ShadowTexels t = shadowTexels(q.xy, view.texel.w, true);
  vec4 through;
  if (view.texel.y > 0.0) {
    through = (t.depth - q.z) / view.texel.y;
  } else {
    // Reversed depth is near/distance, and along a ray the way is as the distance.
    float near = view.texel_from_world[3].z;
    float slant = distance(inside, u_lights[light].position_type.xyz) / clip.w;
    through = (vec4(clip.w) - near / max(t.depth, 1e-12)) * slant;
  }
  return max(dot(t.weight, through), 0.0) * u_units.x;
}

#endif
