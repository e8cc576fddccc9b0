// Unit vectors as two numbers in −1..1: Cigolle et al. 2014, "A Survey of Efficient Representations for Independent Unit Vectors".
#ifndef DERMIS_OCTAHEDRON
#define DERMIS_OCTAHEDRON

vec2 toOctahedron(vec3 n) {
  n /= abs(n.x) + abs(n.y) + abs(n.z);
  if (n.z < 0.0) n.xy = (1.0 - abs(n.yx)) * vec2(n.x >= 0.0 ? 1.0 : -1.0, n.y >= 0.0 ? 1.0 : -1.0);
  return n.xy;
}

vec3 fromOctahedron(vec2 e) {
  vec3 n = vec3(e, 1.0 - abs(e.x) - abs(e.y));
  if (n.z < 0.0) n.xy = (1.0 - abs(n.yx)) * vec2(n.x >= 0.0 ? 1.0 : -1.0, n.y >= 0.0 ? 1.0 : -1.0);
  return normalize(n);
}

#endif
