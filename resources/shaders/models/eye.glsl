// Eyeball: a sclera that scatters, and an iris seen through the cornea, under two specular lobes.
//
// Where the eyeballs are and where they look is found from the mesh (EyeBlock; core/scene/eyeballs.h). Lengths are those of a human
// eyeball, 24 mm across; a larger one is an enlarged human one. The cornea is always the analytic cap of eye_optics.glsl, whether the mesh
// has a plain sphere there, a bulge, or a hollow iris under a shell of its own (a `lens`): a ray is refracted where it meets that
// cap and looked for on the iris, so a shell must not refract again, and doesn't. Where a shell is, it reflects in the cornea's place.
// With an albedo map the iris is in the map, and moves there; the two colours tint it.
#include "material_maps.glsl"
#include "models/two_lobes.glsl"
#include "models/eye_iris.glsl"
#include "models/eye_optics.glsl"

// What is seen at a point.
struct EyeSight {
  float window;       // share of it that is cornea
  float axis_mm;      // distance from the axis of the sclera or iris seen
  vec2 iris;          // place on the iris, mm
  MapPlace uv;
  vec3 cornea_normal;  // world
  mat3 world_from_eye;
};

EyeSight eyeSight(Surface s, EyeShape shape) {
  EyeSight sight = EyeSight(0.0, 2.0 * kEyeballRadiusMm, vec2(0.0), s.uv, s.normal, mat3(1.0));
  if (u_eye_count.x == 0) return sight;
  int nearest = 0;
  float least = 1e30;
  for (int i = 0; i < u_eye_count.x; ++i) {
    float away = distance(s.position, u_eye_centre[i].xyz) / u_eye_centre[i].w;
    if (away < least) {
      least = away;
      nearest = i;
    }
  }
  vec3 axis = u_eye_axis[nearest].xyz;
  vec3 x = normalize(cross(abs(axis.y) > 0.99 ? vec3(0.0, 0.0, -1.0) : vec3(0.0, 1.0, 0.0), axis));
  sight.world_from_eye = mat3(x, cross(axis, x), axis);
  vec3 point = (s.position - u_eye_centre[nearest].xyz) * sight.world_from_eye * (kEyeballRadiusMm / u_eye_centre[nearest].w);
  vec3 travels = -s.view * sight.world_from_eye;

  // The back half counts as beyond the rim of the front one.
  float leaning = length(point.xy) / max(length(point), 1e-4);
  float on_sphere = kEyeballRadiusMm * (point.z > 0.0 ? leaning : 2.0 - leaning);
  vec4 entry = corneaEntry(shape, point, travels);
  float half_width = max(0.5 * u_material.eye_limbus_width_mm, 0.05);
  sight.window = u_material.eye_iris_radius_mm <= 0.0 || entry.w == 0.0 || entry.z < shape.centre_z
                     ? 0.0
                     : 1.0 - smoothstep(shape.rim - half_width, shape.rim + half_width, length(entry.xy));
  sight.iris = onIris(shape, entry.xyz, travels);
  sight.axis_mm = mix(on_sphere, length(sight.iris), sight.window);
  vec2 shift = (sight.iris - point.xy) * (sight.window / kEyeballRadiusMm);
  vec4 gradient = u_eye_uv[nearest];
  sight.uv.uv += vec2(dot(gradient.xy, shift), dot(gradient.zw, shift));
  sight.cornea_normal = sight.world_from_eye * corneaNormal(shape, entry.xyz);
  return sight;
}

vec3 eyeAlbedo(EyeSight sight) {
  // Half of the limbus lies on either side of the iris's rim.
  float half_width = max(0.5 * u_material.eye_limbus_width_mm, 1e-3);
  float from_rim = (sight.axis_mm - u_material.eye_iris_radius_mm) / half_width;
  vec3 iris = u_material.eye_iris_color.rgb;
  if (!hasMap(kMapAlbedo))
    iris = paintedIris(iris, sight.iris, u_material.eye_pupil_radius_mm, u_material.eye_iris_radius_mm,
                       u_material.eye_iris_variation);
  vec3 albedo = mix(iris, u_material.eye_sclera_color.rgb, smoothstep(-1.0, 1.0, from_rim));
  float ring = u_material.eye_limbus_width_mm > 0.0 ? 1.0 - smoothstep(0.0, 1.0, abs(from_rim)) : 0.0;
  return albedo * (1.0 - u_material.eye_limbus_darkness * ring) * colourMap(u_map_albedo, kMapAlbedo, sight.uv).rgb;
}

// A lamp's light on the iris, as addLamp gives it for a body: through the cornea, which draws it together and away from the lamp.
void addIrisLamp(int number, Layer layer, EyeShape shape, EyeSight sight, vec3 position, vec3 vertex_normal, inout vec3 sum) {
  LightSample light = lightAt(number, position);
  IrisBeam beam = irisBeam(shape, sight.iris, normalize(light.to_light * sight.world_from_eye));
  sum += light.irradiance * (beam.gain * shadowAt(number, position, vertex_normal)) * bodyTransmittance(layer, beam.cosine);
}

vec3 irisLamps(Layer layer, LayerPoint p, EyeShape shape, EyeSight sight, vec3 position, vec3 vertex_normal) {
  vec3 sum = vec3(0.0);
#define ADD_LAMP(number) addIrisLamp(number, layer, shape, sight, position, vertex_normal, sum);
  EACH_LIGHT(ADD_LAMP)
#undef ADD_LAMP
  return sum * kInversePi * p.body_in;
}

Shading shade(Surface s) {
  EyeShape shape = eyeShape(u_material.eye_iris_radius_mm, u_material.eye_iris_depth_mm, u_material.eye_cornea_ior);
  EyeSight sight = eyeSight(s, shape);
  vec3 albedo = eyeAlbedo(sight);
  float roughness = u_material.specular_perceptual_roughness * scalarMap(u_map_roughness, kMapRoughness, s.uv);
  float intensity = max(u_material.specular_intensity * scalarMap(u_map_specular, kMapSpecular, s.uv), 0.0);
  float cavity = clamp(u_material.specular_cavity * scalarMap(u_map_cavity, kMapCavity, s.uv), 0.0, 1.0);
  SkyLight sky = skyLight(s, albedo, u_material.occlusion_strength);

  // The tear film is smoother than the sclera, and no map bends it.
  MappedNormal mapped = mappedNormal(s, u_material.surface_normal_strength);
  vec3 normal = normalize(mix(mapped.normal, sight.cornea_normal, sight.window));
  Layer layer = twoLobes(mix(roughness, u_material.eye_cornea_perceptual_roughness, sight.window),
                         mapped.variance * (1.0 - sight.window), intensity);
  LayerPoint p = layerPoint(layer, normal, s.view);
  LayerLight lamps = layerLamps(layer, p, s.position, facingNormal(s));
  LayerLight image = layerImage(layer, p, mix(facingNormal(s), sight.cornea_normal, sight.window), sky);

  vec3 iris_body = irisLamps(layer, p, shape, sight, s.position, facingNormal(s)) +
                    environmentIrradiance(sight.world_from_eye[2]) * sky.share + sky.bounce;
  vec3 body = mix(lamps.body + image.body, iris_body, sight.window);
  float reflects = u_eye_count.y != 0 ? cavity * (1.0 - sight.window) : mix(cavity, 1.0, sight.window);

  Shading result = plainShading(inHalfRange(body), inHalfRange(reflects * (lamps.specular + image.specular)), 1.0, normal);
  result.exit = p.body_out * albedo;
  // What comes from the iris was not scattered under the surface that is seen.
  result.subsurface = 1.0 - sight.window;
  result.occlusion = sky.open;
  result.energy = layerEnergy(p, albedo, reflects);
  return result;
}
