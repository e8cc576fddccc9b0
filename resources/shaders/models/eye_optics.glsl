// Light at the front of an eye, in the eye's own space: millimetres of a human eyeball (radius 12), its centre at the origin, its
// optical axis +Z. A sphere cap of the cornea's curvature sits on the eyeball, its rim where the iris ends; behind it lies the iris, a
// disc. The space between has one index of refraction (aqueous and cornea differ by 0.04). Needs no uniform, so that tests can
// include it alone.
#ifndef DERMIS_EYE_OPTICS
#define DERMIS_EYE_OPTICS

const float kEyeballRadiusMm = 12.0;
const float kCorneaRadiusMm = 7.8;  // anterior surface, Gullstrand's schematic eye 7.7; mean of adults 7.8

struct EyeShape {
  float rim;       // radius of the cornea's rim
  float curve;     // of the cornea
  float centre_z;  // its centre on the axis
  float iris_z;    // plane of the iris
  float eta;       // 1 / index of refraction
};

EyeShape eyeShape(float iris_radius, float iris_depth, float ior) {
  EyeShape e;
  e.rim = clamp(iris_radius, 1e-3, 0.95 * kEyeballRadiusMm);
  e.curve = max(kCorneaRadiusMm, 1.05 * e.rim);
  e.centre_z = sqrt(kEyeballRadiusMm * kEyeballRadiusMm - e.rim * e.rim) - sqrt(e.curve * e.curve - e.rim * e.rim);
  e.iris_z = e.centre_z + e.curve - iris_depth;
  e.eta = 1.0 / ior;
  return e;
}

vec3 corneaNormal(EyeShape e, vec3 entry) { return (entry - vec3(0.0, 0.0, e.centre_z)) / e.curve; }

// The cornea's point over (x, y).
vec3 corneaOver(EyeShape e, vec2 xy) {
  return vec3(xy, e.centre_z + sqrt(max(e.curve * e.curve - dot(xy, xy), 1e-4)));
}

// Where a ray through `point` that travels along `direction` first meets the cornea's sphere; w 0 where it doesn't.
vec4 corneaEntry(EyeShape e, vec3 point, vec3 direction) {
  vec3 from = point - vec3(0.0, 0.0, e.centre_z);
  float along = dot(from, direction);
  float discriminant = along * along - (dot(from, from) - e.curve * e.curve);
  return vec4(point - direction * (along + sqrt(max(discriminant, 0.0))), discriminant > 0.0 ? 1.0 : 0.0);
}

// Where the plane of the iris is met by what entered at `entry` from `direction`; Snell's law. At the rim the cornea may lie behind
// the plane: there the iris is met at once.
vec2 onIris(EyeShape e, vec3 entry, vec3 direction) {
  vec3 inside = refract(direction, corneaNormal(e, entry), e.eta);
  return entry.xy + inside.xy * (max(entry.z - e.iris_z, 0.0) / max(-inside.z, 0.05));
}

// Of a parallel beam from the unit direction `to_light`: its irradiance on the iris at `iris` over that of a surface which faces it,
// reflection apart, and the cosine at which it entered. How much the beam is drawn together is the determinant of the map from
// entry to iris; the entry that leads to `iris` is found by fixed-point iteration, from a flat cornea on, and a step of Newton's.
struct IrisBeam {
  float gain;
  float cosine;
};
IrisBeam irisBeam(EyeShape e, vec2 iris, vec3 to_light) {
  IrisBeam beam = IrisBeam(0.0, 0.0);
  if (to_light.z <= 0.0) return beam;
  vec3 flat_inside = refract(-to_light, vec3(0.0, 0.0, 1.0), e.eta);
  vec2 xy = iris + flat_inside.xy / flat_inside.z * (0.8 * max(e.centre_z + e.curve - e.iris_z, 0.0));
  for (int i = 0; i < 4; ++i) {
    xy *= min(1.0, e.rim / max(length(xy), 1e-4));
    // The map stretches by 0.9 across the light's plane and by up to 1.9 along it.
    xy += 0.75 * (iris - onIris(e, corneaOver(e, xy), -to_light));
  }
  const float kStep = 0.05;
  vec2 there = onIris(e, corneaOver(e, xy), -to_light);
  vec2 dx = (onIris(e, corneaOver(e, xy + vec2(kStep, 0.0)), -to_light) - there) / kStep;
  vec2 dy = (onIris(e, corneaOver(e, xy + vec2(0.0, kStep)), -to_light) - there) / kStep;
  float area = max(dx.x * dy.y - dx.y * dy.x, 0.25);
  vec2 missed = iris - there;
  xy += vec2(dy.y * missed.x - dy.x * missed.y, dx.x * missed.y - dx.y * missed.x) / area;
  vec3 normal = corneaNormal(e, corneaOver(e, xy));
  beam.cosine = clamp(dot(normal, to_light), 0.0, 1.0);
  // What would have to enter beyond the rim is stopped by the sclera.
  beam.gain = beam.cosine / (normal.z * area) * (1.0 - smoothstep(e.rim - 0.03, e.rim + 0.03, length(xy)));
  return beam;
}

#endif
