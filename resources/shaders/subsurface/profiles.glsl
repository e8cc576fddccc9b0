// The diffusion profiles of a frame, by profile id − 1. C++ twin: ProfileBlock in renderer/passes/diffusion_kernels.h.
#ifndef DERMIS_PROFILES
#define DERMIS_PROFILES

const int kMaxProfiles = 16;
const int kSideTaps = 6;
const int kTableSize = 1024;

layout(std140, binding = 4) uniform ProfileBlock {
  vec4 u_profile_direct[kMaxProfiles];    // rgb share that leaves where it entered; w the radius that holds the rest, mm
  vec4 u_profile_boundary[kMaxProfiles];  // rgb tint of light from beyond the boundary; w how far from flat a surface may be, mm
  // For two passes: the cell about the point and those on each side of it; rgb their share, w where they begin (the first: half its
  // width), mm; one more says where the last ends.
  vec4 u_profile_cells[kMaxProfiles * (kSideTaps + 2)];
};

// Two rows a profile. Texel i of the first: rgb r·R(r) at r = radius · (i/(size − 1))⁴. Of the second: x the radius within which
// i/(size − 1) of the mean of the three leaves, y how much larger the next one is.
layout(binding = 26) uniform sampler2D u_profile_table;

// r · R(r) of a profile that reaches as far as `extent`, at the nearest radius of the table: off by at most 0.5 % of r where three quarters
// of the light leave, as often above as below.
vec3 radiusTimesDensity(float r, float extent, int profile) {
  int at = int(sqrt(sqrt(r / max(extent, 1e-12))) * float(kTableSize - 1) + 0.5);
  return at < kTableSize ? texelFetch(u_profile_table, ivec2(at, 2 * profile), 0).rgb : vec3(0.0);
}

// A radius drawn with the random number u of 0..1, and one over r · pdf(r), its density over the plane.
vec2 drawnRadius(float u, int profile) {
  float at = u * float(kTableSize - 1);
  int low = min(int(at), kTableSize - 2);
  vec2 radius = texelFetch(u_profile_table, ivec2(low, 2 * profile + 1), 0).xy;
  return vec2(radius.x + radius.y * (at - float(low)), 6.28318530717958648 * radius.y * float(kTableSize - 1));
}

// How much of the light from a surface point counts that lies `height` away from where a flat, or evenly curved, surface would have it:
// surfaces that don't belong together exchange none. Both in mm; `tolerance` is a material's, near its diffusion length.
float belongsTogether(float height, float chord, float tolerance) {
  float limit = tolerance * (0.6 + 0.12 * min(chord / max(tolerance, 1e-12), 10.0));
  return clamp(2.0 - abs(height) / max(limit, 1e-12), 0.0, 1.0);
}

#endif
