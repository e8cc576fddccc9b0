// What ray casting found of each vertex (renderer/core/bake/mesh_bake.h), and the environment's light by it.
//
// The hidden part of the sky, the light that other parts of the mesh send on and the light that a vertex's far side receives are transfer
// vectors in nine real spherical harmonics: times the environment's coefficients they are irradiance/π (Sloan, Kautz & Snyder 2002,
// "Precomputed Radiance Transfer for Real-Time Rendering in Dynamic, Low-Frequency Lighting Environments", equation 7).
#include "draw_block.glsl"
#include "frame_block.glsl"
#include "lights.glsl"

// A vertex's vectors, four coefficients each (VertexBake; halves, two a word).
layout(std430, binding = 2) readonly buffer MeshBake { uvec2 u_mesh_bake[]; };

vec4 a_hidden_0;  // hidden sky, coefficients 0 to 3
vec4 a_hidden_4;  // 4 to 7
vec4 a_hidden_8;  // 8; thickness in mm, negative where nothing is known; far side 0 and 1
vec4 a_far_2;     // far side, 2 to 5
vec4 a_far_6;     // 6 to 8; bounce 0
vec4 a_bounce_1;  // 1 to 4
vec4 a_bounce_5;  // 5 to 8

vec4 bakedFour(uint vertex, uint number) {
  uvec2 halves = u_mesh_bake[7u * vertex + number];
  return vec4(unpackHalf2x16(halves.x), unpackHalf2x16(halves.y));
}

// Has to be called before anything else here; where nothing is baked, vertices know nothing.
void readMeshBake(uint vertex, bool baked) {
  a_hidden_0 = a_hidden_4 = a_far_2 = a_far_6 = a_bounce_1 = a_bounce_5 = vec4(0.0);
  a_hidden_8 = vec4(0.0, -1.0, 0.0, 0.0);
  if (!baked) return;
  a_hidden_0 = bakedFour(vertex, 0u);
  a_hidden_4 = bakedFour(vertex, 1u);
  a_hidden_8 = bakedFour(vertex, 2u);
  a_far_2 = bakedFour(vertex, 3u);
  a_far_6 = bakedFour(vertex, 4u);
  a_bounce_1 = bakedFour(vertex, 5u);
  a_bounce_5 = bakedFour(vertex, 6u);
}

struct BakedSky {
  vec3 share;      // the environment's irradiance with the mesh's own shadow over what it is without
  float open;      // ambient occlusion
  vec3 far_light;  // irradiance/π of the far side
  vec3 bounce;     // irradiance/π of light that comes from other parts of the mesh
};

vec3 bouncedLamp(LightSample light) {
  vec3 l = light.to_light;
  float received = 0.28209479 * a_far_6.w + 0.48860251 * (a_bounce_1.x * l.y + a_bounce_1.y * l.z + a_bounce_1.z * l.x) +
                   1.09254843 * (a_bounce_1.w * l.x * l.y + a_bounce_5.x * l.y * l.z + a_bounce_5.z * l.x * l.z) +
                   0.31539157 * a_bounce_5.y * (3.0 * l.z * l.z - 1.0) + 0.54627422 * a_bounce_5.w * (l.x * l.x - l.y * l.y);
  return max(received, 0.0) * light.irradiance;
}

// Light that reaches this vertex by way of others, from the environment and from the lamps, whose own light is a direction's as far as
// nine coefficients can tell. The first bounce is exact for a mesh of one albedo; of the others it is taken that the surfaces which
// this one sees are hidden from the sky as much as each other: by the share `among`. In a white world a white mesh is white.
vec3 bounced(vec3 position) {
  vec3 once = a_far_6.w * u_environment_harmonics[0].rgb + a_bounce_1.x * u_environment_harmonics[1].rgb +
              a_bounce_1.y * u_environment_harmonics[2].rgb + a_bounce_1.z * u_environment_harmonics[3].rgb +
              a_bounce_1.w * u_environment_harmonics[4].rgb + a_bounce_5.x * u_environment_harmonics[5].rgb +
              a_bounce_5.y * u_environment_harmonics[6].rgb + a_bounce_5.z * u_environment_harmonics[7].rgb +
              a_bounce_5.w * u_environment_harmonics[8].rgb;
#define ADD_LAMP(number) once += bouncedLamp(lightAt(number, position));
  EACH_LIGHT(ADD_LAMP)
#undef ADD_LAMP
  float among = min(1.0 - a_far_6.w / max(a_hidden_0.x, 1e-6), 0.999);
  return max(once, 0.0) * u_mean_albedo.rgb / (1.0 - u_mean_albedo.rgb * among);
}

// Irradiance/π of a direction that sees the whole environment (Ramamoorthi & Hanrahan 2001, equation 13).
vec3 openIrradiance(vec3 n) {
  vec3 first = 0.28209479 * u_environment_harmonics[0].rgb +
               (2.0 / 3.0 * 0.48860251) * (n.y * u_environment_harmonics[1].rgb + n.z * u_environment_harmonics[2].rgb +
                                           n.x * u_environment_harmonics[3].rgb);
  vec3 second = 1.09254843 * (n.x * n.y * u_environment_harmonics[4].rgb + n.y * n.z * u_environment_harmonics[5].rgb +
                              n.x * n.z * u_environment_harmonics[7].rgb) +
                0.31539157 * (3.0 * n.z * n.z - 1.0) * u_environment_harmonics[6].rgb +
                0.54627422 * (n.x * n.x - n.y * n.y) * u_environment_harmonics[8].rgb;
  return first + 0.25 * second;
}

BakedSky bakedSky(vec3 position, vec3 normal) {
  vec3 hidden = a_hidden_0.x * u_environment_harmonics[0].rgb + a_hidden_0.y * u_environment_harmonics[1].rgb +
                a_hidden_0.z * u_environment_harmonics[2].rgb + a_hidden_0.w * u_environment_harmonics[3].rgb +
                a_hidden_4.x * u_environment_harmonics[4].rgb + a_hidden_4.y * u_environment_harmonics[5].rgb +
                a_hidden_4.z * u_environment_harmonics[6].rgb + a_hidden_4.w * u_environment_harmonics[7].rgb +
                a_hidden_8.x * u_environment_harmonics[8].rgb;
  vec3 far = a_hidden_8.z * u_environment_harmonics[0].rgb + a_hidden_8.w * u_environment_harmonics[1].rgb +
             a_far_2.x * u_environment_harmonics[2].rgb + a_far_2.y * u_environment_harmonics[3].rgb +
             a_far_2.z * u_environment_harmonics[4].rgb + a_far_2.w * u_environment_harmonics[5].rgb +
             a_far_6.x * u_environment_harmonics[6].rgb + a_far_6.y * u_environment_harmonics[7].rgb +
             a_far_6.z * u_environment_harmonics[8].rgb;
  BakedSky sky;
  sky.open = clamp(1.0 - a_hidden_0.x / 0.28209479, 0.0, 1.0);
  // Nine coefficients ring: a direction that receives next to nothing of the environment's mean may come out as negative. There the
  // share is what it is under an even sky.
  vec3 all = openIrradiance(normal);
  vec3 mean = max(0.28209479 * u_environment_harmonics[0].rgb, 1e-9);
  vec3 sure = smoothstep(vec3(0.05), vec3(0.2), all / mean);
  vec3 share = clamp(1.0 - hidden / max(all, 1e-3 * mean), 0.0, 1.0);
  sky.share = mix(vec3(sky.open), share, sure);
  sky.far_light = max(a_hidden_8.y < 0.0 ? openIrradiance(-normal) : far, 0.0);
  sky.bounce = bounced(position);
  return sky;
}
