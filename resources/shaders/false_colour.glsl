// Numbers as colours, display-encoded. C++ twin: renderer/colour/false_colour.cpp.
#ifndef DERMIS_FALSE_COLOUR
#define DERMIS_FALSE_COLOUR

const vec3 kAboveRange = vec3(0.86, 0.10, 0.10);

// Viridis (Firing, van der Walt and Smith, matplotlib 2015, CC0): a polynomial fitted to the published table.
vec3 viridis(float share) {
  float t = clamp(share, 0.0, 1.0);
  const vec3 c0 = vec3(0.276788, 0.003760, 0.337536);
  const vec3 c1 = vec3(-0.135082, 1.479996, 0.959632);
  const vec3 c2 = vec3(2.095792, -0.615107, 5.078130);
  const vec3 c3 = vec3(-13.319863, -2.501471, -40.379558);
  const vec3 c4 = vec3(20.558165, 8.221440, 97.061529);
  const vec3 c5 = vec3(-6.324603, -8.707683, -101.116871);
  const vec3 c6 = vec3(-2.167732, 3.023969, 38.195460);
  return c0 + t * (c1 + t * (c2 + t * (c3 + t * (c4 + t * (c5 + t * c6)))));
}

#endif
