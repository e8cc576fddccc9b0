// How one material's maps are read. C++ twin: DrawBlock in renderer/passes/uniform_blocks.h.
//
// scalar = dot(texel, channel) * transform.x + transform.y, with scale and invert folded in; coordinates = uv * transform.zw.

struct MapData {
  vec4 channel;
  vec4 transform;
};

layout(std140, binding = 2) uniform DrawBlock {
  MapData u_maps[13];  // by TextureSlot
  ivec4 u_map_bits;    // x present, y flip green, each a bit a slot; z 1 if the mesh has texture coordinates; w profile id
  vec4 u_scattering;   // rgb the length that the body's scattering has, mm; w what it means, see transmission.glsl
  vec4 u_mean_albedo;  // rgb of the surfaces that wear the material
  // Eyeballs of an eye's mesh, see core/scene/eyeballs.h.
  ivec4 u_eye_count;     // x; y 1 where a shell of its own reflects in the cornea's place
  vec4 u_eye_centre[4];  // w radius
  vec4 u_eye_axis[4];
  vec4 u_eye_uv[4];      // gradient of the texture coordinates
  uvec4 u_map_tiles[13];  // by TextureSlot: a bit for each UDIM tile that is there; zeros for other maps
};
