// Maps of UDIM tiles, for programs with DERMIS_TILES: every map is an array then, a layer a tile; one without tiles has one layer and
// repeats. Each tile has its own mips and ends at its edge, so that nothing of its neighbours gets in, however small it is seen.
#ifndef DERMIS_MAP_TILES
#define DERMIS_MAP_TILES

#include "draw_block.glsl"

// The layer of the tile of a unit square; −1 where there is none.
int tileLayer(uvec4 tiles, ivec2 square) {
  if (square.x < 0 || square.x > 9 || square.y < 0 || square.y > 9) return -1;
  int number = square.y * 10 + square.x, word = number >> 5;
  uint bit = 1u << (number & 31);
  if ((tiles[word] & bit) == 0u) return -1;
  int before = bitCount(tiles[word] & (bit - 1u));
  for (int i = 0; i < 3; ++i) before += i < word ? bitCount(tiles[i]) : 0;
  return before;
}

// Where in its tile a place lies, and the tile's layer. A place on an edge, within rounding, is that tile's which is there. C++ twin:
// tilePlace() in core/image/image_tiles.h.
vec3 tilePlace(int slot, vec2 uv) {
  uvec4 tiles = u_map_tiles[slot];
  if (tiles == uvec4(0u)) return vec3(uv, 0.0);
  const float edge = 1e-4;
  for (int i = 0; i < 3; ++i) {
    vec2 square = floor(uv + (i == 0 ? 0.0 : i == 1 ? -edge : edge));
    int layer = tileLayer(tiles, ivec2(square));
    if (layer >= 0) return vec3(uv - square, float(layer));
  }
  return vec3(uv, -1.0);
}

// What a map is read as in a square without a tile: what leaves the material as it is without the map, and nothing where the map adds
// something. Normals are flat there.
float withoutTile(int slot) { return slot == 4 || slot == 12 ? 0.0 : 1.0; }  // metallic, emissive

bool tileIsMissing(int slot, vec2 uv) { return tilePlace(slot, uv).z < 0.0; }

vec4 tileTexel(sampler2DArray map, int slot, vec2 uv, vec2 dx, vec2 dy) {
  vec3 place = tilePlace(slot, uv);
  return textureGrad(map, vec3(place.xy, max(place.z, 0.0)), dx, dy);
}

#endif
