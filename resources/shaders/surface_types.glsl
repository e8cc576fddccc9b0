// What a shading model is given and what it gives back. Vectors are in world space, lengths in scene units, colours
// linear Rec.709.
#ifndef DERMIS_SURFACE_TYPES
#define DERMIS_SURFACE_TYPES

struct Surface {
  vec3 position;
  vec3 normal;            // interpolated vertex normal, unit
  vec3 geometric_normal;  // of the triangle, unit
  vec4 tangent;           // xyz unit, w = ±1: bitangent = w · cross(normal, tangent); xyz = 0 where the mesh has none
  vec3 view;              // unit, from the point to the camera
  vec2 uv;
  bool front_facing;
};

struct Shading {
  vec3 diffuse;   // radiance leaving through the body of the material
  vec3 specular;  // radiance reflected at its surface, and emission
  float alpha;    // coverage of what lies behind; diffuse and specular are already multiplied by what they need
  float occlusion;
  vec3 shading_normal;
};

// Whether the inside of the surface is looked at. At the silhouette of a closed mesh a pixel may fall on a triangle that just turns
// away while its interpolated normal doesn't; turning that normal round would light the rim from behind, so it is left alone.
bool seenFromBehind(Surface s) { return !s.front_facing && dot(s.normal, s.view) < -0.05; }

// The vertex normal of the side that is seen.
vec3 facingNormal(Surface s) { return seenFromBehind(s) ? -s.normal : s.normal; }

#endif
