// Grey and chrome balls and a colour chart: things of known reflectance, lit as if they stood at u_place and seen from far away.
// C++ side: renderer/passes/reference_objects.cpp.
#include "frame_block.glsl"
#include "brdf.glsl"
#include "lighting/environment.glsl"
#include "lights.glsl"

uniform vec3 u_place;   // world
uniform vec3 u_grey;    // centre in pixels from the lower left, radius; 0: none
uniform vec3 u_chrome;
uniform vec4 u_chart;   // lower left corner, side of a cell; w the share of it that is patch
uniform vec3 u_patches[24];
uniform float u_grey_albedo;
uniform vec2 u_jitter;  // of this sample, pixels

layout(location = 0) out vec4 o_beauty;

// Irradiance/π, which a white Lambertian surface sends back.
vec3 diffuseLight(vec3 normal) {
  vec3 sum = environmentIrradiance(normal);
#define ADD_LIGHT(number)                                                                        \
  {                                                                                              \
    LightSample light = lightAt(number, u_place);                                                \
    sum += light.irradiance * max(dot(normal, light.to_light), 0.0) * kInversePi; \
  }
  EACH_LIGHT(ADD_LIGHT)
#undef ADD_LIGHT
  return sum;
}

// Chromium at normal incidence, linear Rec.709: Lagarde 2011, "Feeding a physically based shading model".
const vec3 kChrome = vec3(0.549, 0.556, 0.554);

vec3 mirrored(vec3 normal, vec3 view) {
  float n_v = max(dot(normal, view), 1e-3);
  vec3 r = reflect(-view, normal);
  vec3 f = F_Schlick(kChrome, n_v);
  vec3 sum = environmentSharp(r) * f;
  // A lamp is a point and would not be seen in a mirror: it has the highlight of a polish that is not quite perfect.
  const float alpha = 0.004, alpha2 = alpha * alpha;
  float root_v = smithRoot(n_v, alpha2);
#define ADD_LIGHT(number)                                                                                    \
  {                                                                                                          \
    LightSample light = lightAt(number, u_place);                                                            \
    vec3 to_light = normalize(light.to_light);                                                               \
    vec3 h = normalize(to_light + view), n_h = cross(normal, h);                                             \
    float n_l = max(dot(normal, to_light), 0.0), h2 = pow(max(dot(normal, h), 0.0), 2.0);                    \
    sum += light.irradiance * n_l * f * DV_GGX(h2, dot(n_h, n_h), n_v, n_l, alpha2, root_v, light.widening); \
  }
  EACH_LIGHT(ADD_LIGHT)
#undef ADD_LIGHT
  return min(sum, vec3(kRadianceMax));
}

void main() {
  vec2 pixel = gl_FragCoord.xy - u_jitter;
  // Rows of the view matrix are the camera's axes in the world.
  mat3 world_from_view = transpose(mat3(u_view));
  vec3 view = world_from_view[2];

  vec2 grey = (pixel - u_grey.xy) / max(u_grey.z, 1e-3);
  vec2 chrome = (pixel - u_chrome.xy) / max(u_chrome.z, 1e-3);
  vec2 cell = (pixel - u_chart.xy) / max(u_chart.z, 1e-3);
  if (u_grey.z > 0.0 && dot(grey, grey) < 1.0) {
    vec3 normal = world_from_view * vec3(grey, sqrt(1.0 - dot(grey, grey)));
    o_beauty = vec4(u_grey_albedo * diffuseLight(normal), 1.0);
  } else if (u_chrome.z > 0.0 && dot(chrome, chrome) < 1.0) {
    vec3 normal = world_from_view * vec3(chrome, sqrt(1.0 - dot(chrome, chrome)));
    o_beauty = vec4(mirrored(normal, view), 1.0);
  } else if (u_chart.z > 0.0 && all(greaterThanEqual(cell, vec2(0.0))) && all(lessThan(cell, vec2(6.0, 4.0)))) {
    vec2 inside = abs(fract(cell) - 0.5);
    bool patch_here = max(inside.x, inside.y) < 0.5 * u_chart.w;
    int index = (3 - int(cell.y)) * 6 + int(cell.x);
    vec3 albedo = patch_here ? u_patches[index] : vec3(0.02);
    o_beauty = vec4(albedo * diffuseLight(view), 1.0);
  } else {
    discard;
  }
}
