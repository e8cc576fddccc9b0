// Skin: two specular lobes over a body that scatters: light that enters spreads before it leaves (subsurface_pass), and where the body is
// thin some leaves through its far side.
#include "material_maps.glsl"
#include "models/two_lobes.glsl"
#include "transmission.glsl"

// Words of transmission.thickness_source.
const int kThicknessFromMap = 0;
const int kThicknessFromMesh = 1;
const int kThicknessFromShadow = 2;

// Millimetres of material behind the point. Where nothing is known it is as thick as the material gets.
float bodyThicknessMm(Surface s) {
  float least = u_material.transmission_thickness_min_mm, most = max(u_material.transmission_thickness_max_mm, least);
  if (u_material.transmission_thickness_source == kThicknessFromMap)
    return mix(least, most, clamp(scalarMap(u_map_thickness, kMapThickness, s.uv), 0.0, 1.0));
  return s.baked_thickness_mm < 0.0 ? most : clamp(s.baked_thickness_mm, least, most);
}

// Light from the far side, and the least of the thicknesses it came through.
struct BodyLight {
  vec3 light;
  float least_mm;
};

// What the layer lets into the body of a lamp's light.
#ifdef DERMIS_FAR_LAMPS
// At vertices its mean over the hemisphere: a reflection's parameters then change nothing there (VertexLight's key).
struct Entrance {
  vec3 share;
};
vec3 letIn(Entrance entrance, float cosine) { return entrance.share; }
#else
struct Entrance {
  Layer layer;
  vec3 body_in;
};
vec3 letIn(Entrance entrance, float cosine) { return entrance.body_in * bodyTransmittance(entrance.layer, cosine); }
#endif

void lampThrough(int number, Entrance entrance, SlabScattering scattering, vec3 position, vec3 normal, bool from_shadow, float thickness_mm,
                 inout BodyLight sum) {
  LightSample light = lightAt(number, position);
  float cosine = clamp(-dot(normal, light.to_light), 0.0, 1.0);
  if (cosine <= 0.0) return;
  float shrink = u_material.transmission_normal_scale, through_mm, lit = 1.0;
  // A thickness that is known is asked for its shadow a little beyond the far side: thicknesses are averages.
  float beyond = from_shadow ? 0.0 : 1.25 * thickness_mm + shrink;
  float way = shadowThicknessMm(number, position - normal * (beyond / u_units.x), normal, from_shadow ? shrink : 0.0);
  if (from_shadow) {
    // The way through the body begins a little inside it. Through a slab it is as long as that is thick over the cosine; where the light only
    // just doesn't graze, a body is no slab but round, and the way itself counts.
    float slant = mix(1.0, cosine, smoothstep(0.3, 0.7, cosine));
    through_mm = min(way * slant + shrink, u_material.transmission_thickness_max_mm);
    sum.least_mm = min(sum.least_mm, through_mm);
  } else {
    // Where that place still lies a little inside the body, the slab is thicker by what is left of the way; what lies farther off is another
    // part of the body, and casts its shadow.
    float rest = way >= kInside ? 0.0 : way;  // no way for a light without shadows
    lit = 1.0 - smoothstep(thickness_mm + 2.0, 2.0 * (thickness_mm + 2.0), rest);
    through_mm = thickness_mm + rest * cosine;
  }
  sum.light += light.irradiance * cosine * lit * letIn(entrance, cosine) * slabShares(scattering, through_mm).transmitted;
}

// Light of the lamps that comes through the body, as irradiance/π: times body_out it is radiance. `normal` is the vertex normal of the
// side that is seen; the far side faces the other way. Where the thickness is the shadows' to tell, each lamp has its own, and
// `thickness_mm` becomes the least of them as far as nothing else is known.
vec3 lampsThrough(Entrance entrance, SlabScattering scattering, vec3 position, vec3 normal, bool known, inout float thickness_mm) {
  BodyLight through = BodyLight(vec3(0.0), thickness_mm);
  bool from_shadow = u_material.transmission_thickness_source == kThicknessFromShadow;
  vec3 transmitted = slabShares(scattering, thickness_mm).transmitted;
  if (from_shadow || max(transmitted.r, max(transmitted.g, transmitted.b)) >= 1e-5) {
#define ADD_LAMP(number) lampThrough(number, entrance, scattering, position, normal, from_shadow, thickness_mm, through);
    EACH_LIGHT(ADD_LAMP)
#undef ADD_LAMP
  }
  if (from_shadow && !known) thickness_mm = through.least_mm;
  return through.light * kInversePi;
}

#ifdef DERMIS_FAR_LAMPS
// The same for a moving picture on software GL, asked at the vertices: light that has come through a body is soft. What it gives is added
// to the environment's light on the far side, so the slab's share is taken out again. The body has the mean albedo here.
vec4 farSideWithLamps(vec3 position, vec3 normal, vec2 uv, vec4 far) {
  Surface s;
  s.uv.uv = uv;
  s.baked_thickness_mm = far.a;
  float thickness_mm = bodyThicknessMm(s);
  SlabScattering scattering = slabScattering(u_mean_albedo.rgb, u_scattering.rgb, int(u_scattering.w));
  vec3 lamps = lampsThrough(Entrance(vec3(1.0)), scattering, position, normal, far.a >= 0.0, thickness_mm);
  far.rgb = inHalfRange(far.rgb + lamps / max(slabShares(scattering, thickness_mm).transmitted, 1e-6));
  if (far.a < 0.0 && u_material.transmission_thickness_source == kThicknessFromShadow) far.a = thickness_mm;
  return far;
}
#else

Shading shade(Surface s) {
  vec3 albedo = u_material.base_albedo.rgb * colourMap(u_map_albedo, kMapAlbedo, s.uv).rgb;
  float metallic = clamp(u_material.base_metallic * scalarMap(u_map_metallic, kMapMetallic, s.uv), 0.0, 1.0);
  float roughness = u_material.specular_perceptual_roughness * scalarMap(u_map_roughness, kMapRoughness, s.uv);
  float intensity = max(u_material.specular_intensity * scalarMap(u_map_specular, kMapSpecular, s.uv), 0.0);
  float cavity = clamp(u_material.specular_cavity * scalarMap(u_map_cavity, kMapCavity, s.uv), 0.0, 1.0);
  SkyLight sky = skyLight(s, albedo, u_material.occlusion_strength);
  MappedNormal mapped = mappedNormalWithDetail(s, u_material.surface_normal_strength, u_material.surface_detail_strength,
                                               u_material.surface_detail_tiling);
  vec3 normal = mapped.normal;

  Layer layer = twoLobes(roughness, mapped.variance, intensity);
  layer.metal_f0 = albedo;
  layer.metallic = metallic;

  LayerPoint p = layerPoint(layer, normal, s.view);
  LayerLight lamps = layerLamps(layer, p, s.position, facingNormal(s));
  LayerLight image = layerImage(layer, p, facingNormal(s), sky);

  // albedo^m goes in, albedo^(1 − m) comes out: m = 0 keeps texture detail sharp (d'Eon & Luebke 2007, GPU Gems 3, section 14.4).
  vec3 safe_albedo = max(albedo, vec3(1e-5));
  vec3 inwards = pow(safe_albedo, vec3(u_material.subsurface_albedo_mix));

  Shading result;
  result.entering = inHalfRange(inwards * (lamps.body + image.body));
  result.subsurface = clamp(u_material.subsurface_weight * scalarMap(u_map_subsurface, kMapSubsurface, s.uv), 0.0, 1.0);

  // Light through the body, from lamps and environment behind it.
  result.thickness_mm = bodyThicknessMm(s);
  SlabScattering scattering = slabScattering(albedo, u_scattering.rgb, int(u_scattering.w));
#ifdef DERMIS_MOVING
  const vec3 lamps_through = vec3(0.0);  // farSideWithLamps has added it to s.far_light
#else
  vec3 lamps_through =
      lampsThrough(Entrance(layer, p.body_in), scattering, s.position, facingNormal(s), s.baked_thickness_mm >= 0.0, result.thickness_mm);
#endif
  SlabShares slab = slabShares(scattering, result.thickness_mm);
  float amount = u_material.transmission_weight * result.subsurface;
  vec3 tint = amount * u_material.transmission_tint.rgb;
  vec3 kept = keptByBody(slab, albedo, amount, tint * slab.transmitted);
  result.transmission = inHalfRange(p.body_out * tint * (lamps_through + slab.transmitted * s.far_light));

  result.exit = p.body_out * kept * (safe_albedo / inwards);
  result.energy = layerEnergy(p, albedo * kept + tint * slab.transmitted, cavity);
  // Pores and creases swallow reflections; what they swallow is not diffused either.
  result.specular = inHalfRange(cavity * (lamps.specular + image.specular));
  result.alpha = 1.0;
  result.occlusion = sky.open;
  result.shading_normal = normal;
  return result;
}
#endif
