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
};
