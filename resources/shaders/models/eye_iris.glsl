// An iris without a map: a pupil, fibres that run towards it, a paler collarette and a darker rim. Needs no uniform.
#ifndef DERMIS_EYE_IRIS
#define DERMIS_EYE_IRIS

// 0..1 from two integers: the PCG hash (Jarzynski & Olano 2020, "Hash Functions for GPU Rendering").
float hash01(ivec2 v) {
  uint state = uint(v.x) * 747796405u + uint(v.y) * 2654435769u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return float((word >> 22u) ^ word) / 4294967295.0;
}

// Value noise over turns of the circle and radius, `count` cells a turn.
float fibreNoise(float turn, float along, int count) {
  float x = turn * float(count);
  ivec2 cell = ivec2(floor(vec2(x, along)));
  vec2 f = smoothstep(0.0, 1.0, fract(vec2(x, along)));
  int left = (cell.x % count + count) % count, right = (left + 1) % count;
  return mix(mix(hash01(ivec2(left, cell.y)), hash01(ivec2(right, cell.y)), f.x),
             mix(hash01(ivec2(left, cell.y + 1)), hash01(ivec2(right, cell.y + 1)), f.x), f.y);
}

vec3 paintedIris(vec3 colour, vec2 at, float pupil_radius, float iris_radius, float variation) {
  float r = length(at);
  float t = clamp((r - pupil_radius) / max(iris_radius - pupil_radius, 1e-3), 0.0, 1.0);
  float turn = atan(at.y, at.x) / 6.28318530718 + 0.5;
  // Fibres wander a little on their way out.
  float wandering = turn + 0.006 * (fibreNoise(turn, 5.0 * t, 24) - 0.5);
  float fibres = 0.5 * fibreNoise(wandering, 2.0 * t, 70) + 0.3 * fibreNoise(wandering, 3.0 * t + 7.0, 150) +
                 0.2 * fibreNoise(turn, 2.5 * t + 19.0, 17);
  float collarette = (t - 0.3 + 0.08 * (fibreNoise(turn, 31.0, 40) - 0.5)) / 0.12;
  float shade = 1.0 + variation * (1.6 * (fibres - 0.5) + 0.4 * exp(-collarette * collarette) - 0.35 * smoothstep(0.6, 1.0, t));
  float opening = 1.0 - smoothstep(pupil_radius - 0.1, pupil_radius + 0.1, r);
  if (pupil_radius <= 0.0) opening = 0.0;
  return mix(clamp(colour * shade, 0.0, 1.0), vec3(0.002), opening);
}

#endif
