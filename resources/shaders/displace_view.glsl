// From where a displaced surface is drawn, and how finely. Plain uniforms, so that any pass can set its own:
// drawDisplaced() in renderer/passes/displacement.h.
uniform mat4 u_displace_clip;         // clip from world
uniform vec4 u_displace_eye;          // xyz the viewer, w 0; or the unit direction towards it, w 1
uniform vec4 u_displace_planes[4];    // sides of what is seen, unit normals inwards
uniform vec4 u_displace_detail;       // x pieces per scene unit at distance 1 (anywhere for w 1 above), y most pieces of an edge,
                                      // z texels per scene unit over x, w cosine below which an edge faces away
uniform vec2 u_displace_texels;       // between vertices where edges are divided at most, and where they are not
uniform float u_displace_reach;       // farthest that anything is displaced, scene units
uniform int u_displace_seam;          // of the draw's first triangle; −1 where none lies on a seam

float displaceDistance(vec3 position) {
  return u_displace_eye.w > 0.5 ? 1.0 : max(distance(position, u_displace_eye.xyz), 1e-6);
}
vec3 displaceToEye(vec3 position) {
  return u_displace_eye.w > 0.5 ? u_displace_eye.xyz : normalize(u_displace_eye.xyz - position);
}
