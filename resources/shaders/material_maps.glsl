// Reading a material's maps through DrawBlock. Whether a map is there is a uniform, so that no program is compiled when a map comes
// or goes. Software GL runs both sides of every branch and would fetch from maps that aren't there: it gets DERMIS_MAPS, the bits as a
// constant.
#ifndef DERMIS_MATERIAL_MAPS
#define DERMIS_MATERIAL_MAPS

#include "draw_block.glsl"
#include "surface_types.glsl"
#ifdef DERMIS_TILES
#include "map_tiles.glsl"
#define MapSampler sampler2DArray
#else
#define MapSampler sampler2D
#endif

// Indices of TextureSlot, which are the texture units as well.
const int kMapAlbedo = 0;
const int kMapNormal = 1;
const int kMapDetailNormal = 2;
const int kMapDetailMask = 3;
const int kMapMetallic = 4;
const int kMapRoughness = 5;
const int kMapSpecular = 6;
const int kMapCavity = 7;
const int kMapOcclusion = 8;
const int kMapDisplacement = 9;
const int kMapThickness = 10;
const int kMapSubsurface = 11;
const int kMapEmissive = 12;

layout(binding = 0) uniform MapSampler u_map_albedo;
layout(binding = 1) uniform MapSampler u_map_normal;
layout(binding = 2) uniform MapSampler u_map_detail_normal;
layout(binding = 3) uniform MapSampler u_map_detail_mask;
layout(binding = 4) uniform MapSampler u_map_metallic;
layout(binding = 5) uniform MapSampler u_map_roughness;
layout(binding = 6) uniform MapSampler u_map_specular;
layout(binding = 7) uniform MapSampler u_map_cavity;
layout(binding = 8) uniform MapSampler u_map_occlusion;
layout(binding = 9) uniform MapSampler u_map_displacement;
layout(binding = 10) uniform MapSampler u_map_thickness;
layout(binding = 11) uniform MapSampler u_map_subsurface;
layout(binding = 12) uniform MapSampler u_map_emissive;

#ifdef DERMIS_MAPS
bool hasMap(int slot) { return (DERMIS_MAPS & (1 << slot)) != 0; }
#else
bool hasMap(int slot) { return (u_map_bits.x & (1 << slot)) != 0; }
#endif

vec2 mapTiling(int slot) { return u_maps[slot].transform.zw; }

// A texel as blurred as the pixel is large.
vec4 texelAt(MapSampler map, int slot, MapPlace at, vec2 tiling) {
#if defined(DERMIS_TILES) && defined(DERMIS_GRADIENTS)
  return tileTexel(map, slot, at.uv * tiling, at.dx * tiling, at.dy * tiling);
#elif defined(DERMIS_TILES) && defined(DERMIS_NO_DERIVATIVES)
  return tileTexel(map, slot, at.uv * tiling, vec2(0.0), vec2(0.0));
#elif defined(DERMIS_TILES)
  return tileTexel(map, slot, at.uv * tiling, dFdx(at.uv) * tiling, dFdy(at.uv) * tiling);
#elif defined(DERMIS_GRADIENTS)
  return textureGrad(map, at.uv * tiling, at.dx * tiling, at.dy * tiling);
#else
  return texture(map, at.uv * tiling);
#endif
}

// A data map's value, channel chosen, inverted and scaled as the slot says; 1 where there is no map.
float scalarMap(MapSampler map, int slot, MapPlace at) {
  if (!hasMap(slot)) return 1.0;
  vec2 tiling = mapTiling(slot);
  float value = dot(texelAt(map, slot, at, tiling), u_maps[slot].channel) * u_maps[slot].transform.x + u_maps[slot].transform.y;
#ifdef DERMIS_TILES
  if (tileIsMissing(slot, at.uv * tiling)) value = withoutTile(slot);
#endif
  return value;
}

// A colour map's value with its alpha; 1 where there is no map.
vec4 colourMap(MapSampler map, int slot, MapPlace at) {
  if (!hasMap(slot)) return vec4(1.0);
  vec2 tiling = mapTiling(slot);
  vec4 texel = texelAt(map, slot, at, tiling);
  vec4 colour = vec4(max(texel.rgb * u_maps[slot].transform.x + u_maps[slot].transform.y, 0.0), texel.a);
#ifdef DERMIS_TILES
  if (tileIsMissing(slot, at.uv * tiling)) colour = vec4(vec3(withoutTile(slot)), 1.0);
#endif
  return colour;
}

// How much image light the occlusion map leaves: strength 0 ignores the map (glTF 2.0, occlusionTexture.strength).
float occlusionMap(MapPlace at, float strength) {
  if (!hasMap(kMapOcclusion)) return 1.0;
  return 1.0 + strength * (clamp(scalarMap(u_map_occlusion, kMapOcclusion, at), 0.0, 1.0) - 1.0);
}

// Interreflection where only the occlusion is known: a surface that sees the share `visibility` of the sky sees itself, and light on it,
// in the rest. Jimenez, Wu, Pesce & Jarabo 2016, "Practical Realtime Strategies for Accurate Indirect Occlusion", equation 10 and its fit: 1
// in the open.
vec3 multiBounce(float visibility, vec3 albedo) {
  vec3 a = 2.0404 * albedo - 0.3324;
  vec3 b = -4.7951 * albedo + 0.6417;
  vec3 c = 2.7552 * albedo + 0.6903;
  return min(max(vec3(visibility), ((visibility * a + b) * visibility + c) * visibility), 1.0);
}

// What arrives of light that doesn't come straight from a lamp: the map's where there is one, else what was baked of the mesh.
SkyLight skyLight(Surface s, vec3 albedo, float strength) {
  if (hasMap(kMapOcclusion)) {
    float ao = occlusionMap(s.uv, strength);
    return SkyLight(multiBounce(ao, albedo), vec3(0.0), ao);
  }
  return SkyLight(1.0 + strength * (s.sky_share - 1.0), strength * s.bounce, 1.0 + strength * (s.baked_occlusion - 1.0));
}

// What a normal map says of a place.
struct MappedNormal {
  vec3 normal;    // unit, tangent frame or world
  float variance;  // of the slopes that a pixel sees as one, along one axis: widens the lobes, alpha² + 2 variance
};

// A normal map's texel as a direction in the tangent frame, its slope multiplied by `strength` and by the slot's scale. Where a pixel
// holds many texels their mean is shorter than 1; by how much tells their variance (Toksvig 2005, "Mipmapping Normal Maps"): a slope's
// variance σ² along each axis leaves a length of 1 / (1 + σ²). Eight bits leave a length uncertain by half a percent, which is none.
MappedNormal tangentNormal(MapSampler map, int slot, MapPlace at, vec2 tiling, float strength) {
  vec3 n = texelAt(map, slot, at, tiling).xyz * 2.0 - 1.0;
#ifdef DERMIS_TILES
  if (tileIsMissing(slot, at.uv * tiling)) n = vec3(0.0, 0.0, 1.0);
#endif
  float shortened = clamp(length(n), 0.25, 0.995);
  if ((u_map_bits.y & (1 << slot)) != 0) n.y = -n.y;
  float factor = strength * abs(u_maps[slot].transform.x);
  n.xy *= factor;
  return MappedNormal(normalize(vec3(n.xy, max(n.z, 1e-3))), (0.995 / shortened - 1.0) * factor * factor);
}

// Puts the detail normal on top of the base normal as if the base were flat: reoriented normal mapping, Barré-Brisebois & Hill
// 2012, "Blending in Detail".
vec3 reorientedNormal(vec3 base, vec3 detail) {
  vec3 t = base + vec3(0.0, 0.0, 1.0);
  vec3 u = detail * vec3(-1.0, -1.0, 1.0);
  return normalize(t * dot(t, u) - u * t.z);
}

// From the tangent frame (MikkTSpace's: neither interpolated vector is orthogonal exactly) to the world.
vec3 worldNormal(Surface s, vec3 n) {
  vec3 tangent = s.tangent.xyz - s.normal * dot(s.normal, s.tangent.xyz);
  float length2 = dot(tangent, tangent);
  if (length2 < 1e-8) return facingNormal(s);
  tangent *= inversesqrt(length2);
  vec3 bitangent = s.tangent.w * cross(s.normal, tangent);
  vec3 world = normalize(tangent * n.x + bitangent * n.y + s.normal * n.z);
  return seenFromBehind(s) ? -world : world;
}

// The normal that is lit: the vertex normal bent by the normal map.
MappedNormal mappedNormal(Surface s, float strength) {
  if (!hasMap(kMapNormal) || u_map_bits.z == 0) return MappedNormal(facingNormal(s), 0.0);
  MappedNormal base = tangentNormal(u_map_normal, kMapNormal, s.uv, mapTiling(kMapNormal), strength);
  return MappedNormal(worldNormal(s, base.normal), base.variance);
}

// The same with the tiling detail normal on top, where its mask lets it.
MappedNormal mappedNormalWithDetail(Surface s, float strength, float detail_strength, float detail_tiling) {
  bool based = hasMap(kMapNormal), detailed = hasMap(kMapDetailNormal) && detail_strength != 0.0;
  if (u_map_bits.z == 0 || !(based || detailed)) return MappedNormal(facingNormal(s), 0.0);
  MappedNormal base = MappedNormal(vec3(0.0, 0.0, 1.0), 0.0);
  if (based) base = tangentNormal(u_map_normal, kMapNormal, s.uv, mapTiling(kMapNormal), strength);
  if (!detailed) return MappedNormal(worldNormal(s, base.normal), base.variance);
  float mask = clamp(scalarMap(u_map_detail_mask, kMapDetailMask, s.uv), 0.0, 1.0);
  vec2 tiling = mapTiling(kMapDetailNormal) * detail_tiling;
  MappedNormal detail = tangentNormal(u_map_detail_normal, kMapDetailNormal, s.uv, tiling, detail_strength * mask);
  return MappedNormal(worldNormal(s, reorientedNormal(base.normal, detail.normal)), base.variance + detail.variance);
}

#endif
