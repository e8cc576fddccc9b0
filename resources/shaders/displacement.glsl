// The normal of a displaced surface, for fragment shaders with DERMIS_DISPLACED.
#ifndef DERMIS_DISPLACEMENT
#define DERMIS_DISPLACEMENT

#include "displacement_height.glsl"

// The height that a pixel sees at coordinates of the map.
float heightSeen(vec2 st) {
#ifdef DERMIS_TILES
  float height = heightOf(tileTexel(u_map_displacement, kMapDisplacement, st, dFdx(st), dFdy(st)));
  return tileIsMissing(kMapDisplacement, st) ? 0.0 : height;
#else
  return heightOf(texture(u_map_displacement, st));
#endif
}

// The normal of P + h N: N − ∇h / (1 + h κ), with ∇ on the base surface (∇h = h_u ∇u + h_v ∇v) and κ its mean curvature, which for a
// sphere is exact (Blinn 1978, "Simulation of Wrinkled Surfaces"; Mikkelsen 2008, "Simulation of Wrinkled Surfaces Revisited"). The map's
// slope comes from four taps half a texel from the point, which is Sobel's filter on texels: continuous, where the difference of two
// bilinear values is not.
vec3 displacedNormal(vec3 normal, vec2 uv, vec3 gradient_u, vec3 gradient_v, float curvature) {
  vec2 st = uv * mapTiling(kMapDisplacement);
  float lod = max(textureQueryLod(u_map_displacement, st).y, 0.0);
  vec2 reach = 0.5 * exp2(lod) / vec2(textureSize(u_map_displacement, 0).xy);
  vec4 h = vec4(heightSeen(st - reach), heightSeen(st + vec2(reach.x, -reach.y)), heightSeen(st + vec2(-reach.x, reach.y)),
                heightSeen(st + reach));
  vec2 slope = vec2(h.y + h.w - h.x - h.z, h.z + h.w - h.x - h.y) / (4.0 * reach) * u_maps[kMapDisplacement].transform.zw;
  float stretch = max(1.0 + 0.25 * dot(h, vec4(1.0)) * curvature, 0.1);
  return normalize(normal - (slope.x * gradient_u + slope.y * gradient_v) / stretch);
}

#endif
