// Diffusion for stillness and export: every sample of the picture gathers light from a disc of the surface around the point, the places
// drawn from the profile itself.
//
// What leaves at p is ∫ E(q) R(|q − p|) dA(q) over the surface. Places t are drawn on the tangent plane at p, as the mean of the three
// channels' profiles has them; q is the surface under the pixel where t is seen. With J = dA(q)/dA(t) the ratio of the areas that one
// piece of the screen shows of surface and tangent plane, a sample weighs R(|q − p|) J / pdf(t); the sum is divided by the weights
// found, so a white body stays white. E is taken as constant over a pixel, which makes a profile narrower than a pixel Lambert's.
#include "subsurface/compose.glsl"
#include "subsurface/profiles.glsl"
#include "subsurface/surface_points.glsl"

#ifndef DERMIS_SAMPLES
#define DERMIS_SAMPLES 16
#endif
const float kTwoPi = 6.28318530717958648;
// One step of the golden angle, as a rotation.
const vec2 kGoldenStep = vec2(-0.737368878, 0.675490294);

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 here = texelFetch(u_entering, pixel, 0);
  vec4 geometry = texelFetch(u_geometry, pixel, 0);
  float depth = texelFetch(u_depth, pixel, 0).r;
  int id = int(geometry.z + 0.5);
  if (id == 0 || here.a <= 0.0) {
    compose(pixel, here.rgb, here.rgb, depth > 0.0);
    return;
  }

  int profile = id - 1;
  vec4 direct = u_profile_direct[profile];
  float extent = direct.w, tolerance = u_profile_boundary[profile].w;
  vec3 p = worldAt(gl_FragCoord.xy, depth);
  vec3 normal = fromOctahedron(geometry.xy);
  vec3 along, across;
  tangentFrame(normal, along, across);
  float unit = 1.0 / u_units.x;  // a millimetre in scene units
  vec3 clip = clipOf(vec4(p, 1.0));
  vec3 clip_along = clipOf(vec4(along * unit, 0.0)), clip_across = clipOf(vec4(across * unit, 0.0));
  bool orthographic = u_camera_position.w > 0.5;
  // The tangent plane lies as far from the camera everywhere; a place on it at p + step has the squared distance t2 of the camera.
  vec3 from_viewer = orthographic ? u_camera_forward.xyz : p - u_camera_position.xyz;
  float plane = max(abs(dot(normal, from_viewer)), orthographic ? 0.05 : 1e-12);
  float p2 = dot(from_viewer, from_viewer);
  vec2 p2_step = 2.0 * unit * vec2(dot(along, from_viewer), dot(across, from_viewer));

  vec2 in_picture = gl_FragCoord.xy + u_window.xy;
  // Each pixel turns the pattern and shifts its radii; each sample of the picture does so again.
  float turn = kTwoPi * fract(gradientNoise(in_picture) + u_random.x);
  float shift = fract(gradientNoise(in_picture.yx + vec2(37.0, 113.0)) + u_random.y);
  vec2 direction = vec2(cos(turn), sin(turn));

  vec3 light = vec3(0.0), found = vec3(0.0), beyond = vec3(0.0);
  for (int i = 0; i < DERMIS_SAMPLES; ++i) {
    vec2 drawn = drawnRadius((float(i) + shift) / float(DERMIS_SAMPLES), profile);
    float r = drawn.x;
    direction = vec2(direction.x * kGoldenStep.x - direction.y * kGoldenStep.y,
                     direction.x * kGoldenStep.y + direction.y * kGoldenStep.x);
    vec2 offset = r * direction;
    vec3 clip_t = clip + offset.x * clip_along + offset.y * clip_across;
    vec2 screen = screenOf(clip_t);
    vec2 pixel_t = clamp(floor(screen), vec2(0.0), u_viewport.xy - 1.0);
    ivec2 there = ivec2(pixel_t);
    vec4 other = texelFetch(u_entering, there, 0);
    vec3 other_geometry = texelFetch(u_geometry, there, 0).xyz;
    float other_depth = texelFetch(u_depth, there, 0).r;
    bool counts = other_depth > 0.0 && clip_t.z > 0.0 && all(lessThan(abs(screen - pixel_t - 0.5), vec2(0.5001)));

    // The surface at that very place, by the tangent plane of its pixel's centre: from where the ray meets the centre's depth along the
    // ray to the plane.
    vec3 other_normal = fromOctahedron(other_geometry.xy);
    vec2 in_pixel = screen - pixel_t - 0.5;
    vec3 step_there = worldStep(in_pixel, other_depth);
    vec3 at_depth = worldAt(pixel_t + 0.5, other_depth) + step_there;
    vec3 ray = orthographic ? u_camera_forward.xyz : at_depth - u_camera_position.xyz;
    float ray2 = dot(ray, ray), towards = dot(other_normal, ray);
    float least = 0.05 * sqrt(ray2);
    float onwards = -dot(other_normal, step_there) / (towards > 0.0 ? max(towards, least) : min(towards, -least));
    vec3 chord = at_depth + onwards * ray - p;

    // On an evenly curved surface the chord meets both normals at the same angle.
    float chord2 = dot(chord, chord);
    float distance_mm = max(sqrt(chord2) * u_units.x, 1e-9);
    float height_mm = 0.5 * dot(normal + other_normal, chord) * u_units.x;
    float together = belongsTogether(height_mm, distance_mm, tolerance);
    float area;
    if (orthographic) {
      area = plane / max(abs(towards), 0.05);
    } else {
      // cos/distance² of the plane over that of the surface.
      float further = 1.0 + onwards;
      float ratio = further * further * ray2 / (p2 + dot(offset, p2_step) + r * r * unit * unit);
      area = plane / max(abs(further * towards), 1e-12) * ratio * sqrt(ratio);
    }
    // Before it is divided by the sum, a sample weighs R(distance) · area / pdf(r).
    vec3 weight = radiusTimesDensity(distance_mm, extent, profile) * (drawn.y * r / distance_mm * together * min(area, 8.0));
    weight = counts ? weight : vec3(0.0);
    bool same = int(other_geometry.z + 0.5) == id;
    beyond += same ? vec3(0.0) : weight;
    weight *= same ? other.a : 0.0;
    light += weight * other.rgb;
    found += weight;
  }

  vec3 share = found / max(found + beyond, vec3(1e-20));
  vec3 spread = light / max(found, vec3(1e-20));
  spread *= mix(u_profile_boundary[profile].rgb, vec3(1.0), share);
  spread = mix(here.rgb, spread, greaterThan(found, vec3(1e-18)));
  spread = mix(spread, here.rgb, direct.rgb);
  compose(pixel, here.rgb, mix(here.rgb, spread, here.a), true);
}
