// What a shading model is given and what it gives back. Vectors are in world space, lengths in scene units, colours
// linear Rec.709.
#ifndef DERMIS_SURFACE_TYPES
#define DERMIS_SURFACE_TYPES

// Where maps are read, and how far that moves from one pixel to the next, which tells how blurred: set where the driver can't know,
// because the pixels beside this one may show another part of the mesh.
struct MapPlace {
  vec2 uv;
  vec2 dx;
  vec2 dy;
};

struct Surface {
  vec3 position;
  vec3 normal;   // interpolated vertex normal, unit
  vec4 tangent;  // xyz unit, w = ±1: bitangent = w · cross(normal, tangent); xyz = 0 where the mesh has none
  vec3 view;     // unit, from the point to the camera
  MapPlace uv;
  bool front_facing;
  float baked_occlusion;     // share of the sky that the mesh itself leaves free; 1 where nothing is known
  float baked_thickness_mm;  // of the material behind the point; negative where nothing is known
  vec3 sky_share;            // the environment's irradiance in the mesh's own shadow over what it is without
  vec3 bounce;               // irradiance/π that comes from other parts of the mesh
  vec3 far_light;            // the environment's irradiance/π on the far side of the material
};

// What arrives of light that doesn't come straight from a lamp.
struct SkyLight {
  vec3 share;   // of the environment's irradiance
  vec3 bounce;  // irradiance/π of what the rest of the mesh sends on
  float open;   // ambient occlusion, 1 in the open
};

// Light through the body is split in two, because what lies between is diffusion: `entering` is what goes in, as the radiance that a
// perfectly white body would send back, `exit` is what leaving multiplies it by. Without diffusion the body's radiance is their product.
struct Shading {
  vec3 entering;
  vec3 exit;
  float subsurface;    // share of `entering` that diffuses; the rest leaves where it entered (Lambert)
  vec3 transmission;   // radiance of light from the far side
  vec3 specular;       // radiance reflected at the surface, and emission
  float alpha;         // coverage of what lies behind; the radiances are already multiplied by what they need
  float occlusion;
  float thickness_mm;  // 0 where the model has none
  float energy;        // share of a white environment that is sent to the viewer, of the channel that sends most
  vec3 shading_normal;
};

// A surface without diffusion, transmission and thickness.
Shading plainShading(vec3 diffuse, vec3 specular, float alpha, vec3 normal) {
  return Shading(diffuse, vec3(1.0), 0.0, vec3(0.0), specular, alpha, 1.0, 0.0, 0.0, normal);
}

// Whether the inside of the surface is looked at. At the silhouette of a closed mesh a pixel may fall on a triangle that just turns
// away while its interpolated normal doesn't; turning that normal round would light the rim from behind, so it is left alone.
bool seenFromBehind(Surface s) { return !s.front_facing && dot(s.normal, s.view) < -0.05; }

// The vertex normal of the side that is seen.
vec3 facingNormal(Surface s) { return seenFromBehind(s) ? -s.normal : s.normal; }

#endif
