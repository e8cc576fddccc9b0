// A visible lamp as a sphere of 64 × 32 quads, made from gl_VertexID.
#include "frame_block.glsl"

uniform vec4 u_sphere;  // centre and radius, scene units

const int kSegments = 64;
const int kRings = 32;

void main() {
  int quad = gl_VertexID / 6;
  int corner = gl_VertexID % 6;
  ivec2 offset = ivec2(corner == 1 || corner == 2 || corner == 4 ? 1 : 0, corner == 2 || corner == 4 || corner == 5 ? 1 : 0);
  ivec2 at = ivec2(quad % kSegments, quad / kSegments) + offset;
  float phi = 6.2831853 * float(at.x) / float(kSegments);
  float theta = 3.1415927 * float(at.y) / float(kRings);
  vec3 direction = vec3(sin(theta) * cos(phi), cos(theta), sin(theta) * sin(phi));
  gl_Position = u_view_projection * vec4(u_sphere.xyz + u_sphere.w * direction, 1.0);
}
