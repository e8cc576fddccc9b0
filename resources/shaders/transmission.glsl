// Light that comes through a thin body from its far side, by diffusion through a slab.
//
// With the source at the depth z₀ = 2ℓ/3 and no light beyond the extrapolated boundaries z_e = 0.7104 ℓ outside both faces, a slab of
// thickness t lets through and sends back
//   T(t) = sinh(κ(z₀ + z_e)) / sinh(κ(t + 2z_e))
//   R(t) = sinh(κ(t + z_e − z₀)) / sinh(κ(t + 2z_e)),   κ = √(3(1 − α)) / ℓ
// with ℓ the mean free path and α the single-scattering albedo that gives the surface its albedo A (Chiang et al. 2016, "Practical and
// Controllable Subsurface Scattering for Production Path Tracing", equation 1). R(∞) is A to a percent, so A · R(t)/R(∞) is what a
// body sends back whose other light leaves through the far side. Written with falling exponentials only: nothing overflows.
#ifndef DERMIS_TRANSMISSION
#define DERMIS_TRANSMISSION

// A body's scattering at a point, a colour channel a component.
struct SlabScattering {
  vec3 k;      // κℓ = √(3(1 − α))
  vec3 kappa;  // 1/mm
};

struct SlabShares {
  vec3 transmitted;  // T(t)
  vec3 kept;         // R(t)/R(∞)
};

// Words of subsurface.radius_reading.
const int kReadingDiffuseMeanFreePath = 0;
const int kReadingMeanFreePath = 1;
const int kReadingBurleyD = 2;

// `lengths` in mm mean what `reading` says: 1/σ_tr; 1/σ_t′; or Burley's d, which is ℓ over the fit of Christensen & Burley 2015 for
// diffuse light (equation 5).
SlabScattering slabScattering(vec3 albedo, vec3 lengths, int reading) {
  vec3 a = clamp(albedo, 0.0, 1.0);
  SlabScattering s;
  s.k = 1.73205081 * exp(0.5 * a * (-5.09406 + a * (2.61188 - 4.31805 * a)));
  vec3 fit = 1.9 - a + 3.5 * (a - 0.8) * (a - 0.8);
  vec3 mean_free_path = lengths;
  if (reading == kReadingDiffuseMeanFreePath) mean_free_path = lengths * s.k;
  if (reading == kReadingBurleyD) mean_free_path = lengths * fit;
  s.kappa = s.k / max(mean_free_path, 1e-6);
  return s;
}

SlabShares slabShares(SlabScattering s, float thickness_mm) {
  vec3 through = exp(-s.kappa * max(thickness_mm, 0.0));  // e^(−κt)
  vec3 both = 1.0 / (1.0 - exp(-2.8416 * s.k) * through * through);  // 1 / (1 − e^(−2κ(t + 2z_e)))
  SlabShares shares;
  shares.transmitted = through * exp(-0.0437333 * s.k) * (1.0 - exp(-2.7541333 * s.k)) * both;
  shares.kept = (1.0 - exp(-0.0874667 * s.k) * through * through) * both;
  return shares;
}

// What of the body's reflection is left over, so that no more comes back and goes through than came in: the share `amount` of the
// body is a slab that the light may leave through, `transmitted` what goes through it (amount and tint included).
vec3 keptByBody(SlabShares shares, vec3 albedo, float amount, vec3 transmitted) {
  return min(1.0 - amount * (1.0 - shares.kept), (1.0 - transmitted) / max(albedo, 1e-5));
}

#endif
