#include "core/builtin/skin/pigments.h"

#include <algorithm>
#include <cmath>

#include "core/light_rig/light_colour.h"
#include "core/material/builtin_presets.h"

namespace dermis::skin {
namespace {

constexpr int kFirst = 400, kStep = 10;
constexpr std::size_t kCount = 31;  // to 700 nm

// Molar extinction of haemoglobin with and without oxygen, 1/(cm M): Prahl 1999, "Optical Absorption of Hemoglobin",
// compiled from Gratzer and Kollias.
constexpr std::array<double, kCount> kOxygenated = {
    266232,  466840,  480360,  246072, 102580, 62816,   44480, 33209.2, 26629.2, 23684.4, 20932.8,
    20035.2, 24202.4, 39956.8, 53236,  43016,  32613.2, 44496, 50104,   14400.8, 3200,    1506,
    942,     610,     442,     368,    319.6,  294,     277.6, 276,     290};
constexpr std::array<double, kCount> kDeoxygenated = {
    223296,  303956,  407560,  528600,  413280,  103292,  23388.8, 16156.4, 14550,   16684,   20862,
    25773.6, 31589.6, 39036.4, 46592,   53412,   53788,   45072,   37020,   28324.4, 14677.2, 9443.6,
    6509.6,  5148.8,  4345.2,  3750.12, 3226.56, 2795.12, 2407.92, 2051.96, 1794.28};
// CIE standard illuminant D65, relative (CIE 15:2004, table T.1).
constexpr std::array<double, kCount> kD65 = {82.7549, 91.486,  93.4318, 86.6823, 104.865, 117.008, 117.812, 114.861,
                                             115.923, 108.811, 109.354, 107.802, 104.79,  107.689, 104.405, 104.046,
                                             100.0,   96.3342, 95.788,  88.6856, 90.0062, 89.5991, 87.6987, 83.2886,
                                             83.6992, 80.0268, 80.2146, 82.2778, 78.2842, 69.7213, 71.6091};

double sampled(const std::array<double, kCount>& table, double nanometres) {
  const double x = std::clamp((nanometres - kFirst) / kStep, 0.0, static_cast<double>(kCount - 1));
  const auto i = std::min(static_cast<std::size_t>(x), kCount - 2);
  return glm::mix(table.at(i), table.at(i + 1), x - static_cast<double>(i));
}

/// Of skin without pigments, 1/cm (Jacques 1998, "Skin Optics").
double baselineAbsorption(double nanometres) { return 0.244 + 85.3 * std::exp(-(nanometres - 154.0) / 66.2); }

/// Diffuse reflectance of a deep medium without a boundary of its own (Jensen & Buhler 2002, "A Rapid Hierarchical
/// Rendering Technique for Translucent Materials", equation 15 with A = 1: the surface's reflection is the material's).
double deepReflectance(double absorption, double scattering) {
  const double albedo = scattering / (absorption + scattering);
  const double s = std::sqrt(3.0 * (1.0 - albedo));
  return 0.5 * albedo * (1.0 + std::exp(-4.0 / 3.0 * s)) * std::exp(-s);
}

constexpr double kLeastMelanin = 0.0005, kMostMelanin = 0.8;
constexpr double kLeastBlood = 0.0002, kMostBlood = 0.4;

}  // namespace

double bloodAbsorption(double nanometres, double oxygenation) {
  // 150 g of haemoglobin a litre of 64,500 g/mol.
  constexpr double kMolesPerLitre = 150.0 / 64500.0;
  const double extinction = glm::mix(sampled(kDeoxygenated, nanometres), sampled(kOxygenated, nanometres), oxygenation);
  return std::log(10.0) * kMolesPerLitre * extinction;
}

double skinReflectance(double nanometres, const Pigments& pigments) {
  // Two layers as in Krishnaswamy & Baranoski 2004 and Alotaibi & Smith 2017: light crosses the epidermis, which
  // absorbs, is scattered back by the dermis, and crosses the epidermis again. Coefficients: Jacques 1998.
  const double baseline = baselineAbsorption(nanometres);
  const double melanin = 6.6e11 * std::pow(nanometres, -3.33);
  const double epidermis = glm::mix(baseline, melanin, pigments.melanin);
  constexpr double kEpidermisCm = 0.006;
  constexpr double kDiffusePath = 2.0;  // of isotropic light through a slab, against straight
  const double through = std::exp(-2.0 * kDiffusePath * kEpidermisCm * epidermis);
  const double dermis = glm::mix(baseline, bloodAbsorption(nanometres, pigments.oxygenation), pigments.blood);
  const double scattering = 2e5 * std::pow(nanometres, -1.5) + 2e12 * std::pow(nanometres, -4.0);
  return through * deepReflectance(dermis, scattering);
}

glm::dvec3 skinAlbedo(const Pigments& pigments) {
  glm::dvec3 seen(0.0), white(0.0);
  for (std::size_t i = 0; i < kCount; ++i) {
    const double nanometres = kFirst + kStep * static_cast<double>(i);
    const glm::dvec3 weight = kD65.at(i) * colourMatching(nanometres);
    seen += weight * skinReflectance(nanometres, pigments);
    white += weight;
  }
  // White is what reflects all of the light, whatever the matching functions' fit is off by.
  constexpr glm::dvec3 kD65White(0.95047, 1.0, 1.08883);
  return insideRec709(rec709FromXyz(seen / white * kD65White));
}

AlbedoTable::AlbedoTable() {
  for (const double oxygen : {0.0, 1.0})
    for (int b = 0; b < kSteps; ++b)
      for (int m = 0; m < kSteps; ++m) {
        const auto share = [](int i) { return static_cast<double>(i) / (kSteps - 1); };
        const glm::dvec3 albedo = skinAlbedo({kLeastMelanin * std::pow(kMostMelanin / kLeastMelanin, share(m)),
                                              kLeastBlood * std::pow(kMostBlood / kLeastBlood, share(b)), oxygen});
        m_logarithms.emplace_back(glm::log(glm::max(albedo, glm::dvec3(1e-5))));
      }
}

const glm::vec3& AlbedoTable::logarithm(int melanin, int blood, int oxygen) const {
  const int entry = (oxygen * kSteps + blood) * kSteps + melanin;
  return m_logarithms[static_cast<std::size_t>(entry)];
}

glm::vec3 AlbedoTable::at(float melanin, float blood, float oxygenation) const {
  const auto place = [](float value, double least, double most) {
    const double x = std::log(std::max(static_cast<double>(value), least) / least) / std::log(most / least);
    return static_cast<float>(std::min(x, 1.0) * (kSteps - 1));
  };
  const float x = place(melanin, kLeastMelanin, kMostMelanin), y = place(blood, kLeastBlood, kMostBlood);
  const int i = std::min(static_cast<int>(x), kSteps - 2), j = std::min(static_cast<int>(y), kSteps - 2);
  const float u = x - static_cast<float>(i), v = y - static_cast<float>(j);
  const auto plane = [&](int oxygen) {
    return glm::mix(glm::mix(logarithm(i, j, oxygen), logarithm(i + 1, j, oxygen), u),
                    glm::mix(logarithm(i, j + 1, oxygen), logarithm(i + 1, j + 1, oxygen), u), v);
  };
  return glm::exp(glm::mix(plane(0), plane(1), std::clamp(oxygenation, 0.0F, 1.0F)));
}

Pigments pigmentsOf(const glm::dvec3& albedo) {
  // A grid, then finer ones round its best: two unknowns, no gradient to go wrong.
  const auto error = [&](const Pigments& p) {
    const glm::dvec3 off =
        glm::log(glm::max(skinAlbedo(p), glm::dvec3(1e-6))) - glm::log(glm::max(albedo, glm::dvec3(1e-6)));
    // What differs in brightness alone costs less: albedos that people publish are not all of the same kind.
    const double brightness = (off.r + off.g + off.b) / 3.0;
    const glm::dvec3 colour = off - brightness;
    return glm::dot(colour, colour) + 0.15 * brightness * brightness;
  };
  // Skin without any melanin or blood is nobody's.
  const double leastM = std::log(0.008), mostM = std::log(0.6), leastB = std::log(0.001), mostB = std::log(0.12);
  double lowM = leastM, highM = mostM, lowB = leastB, highB = mostB;
  Pigments best;
  for (int round = 0; round < 8; ++round) {
    double least = 1e30;
    constexpr int kGrid = 14;
    for (int i = 0; i <= kGrid; ++i)
      for (int j = 0; j <= kGrid; ++j) {
        const Pigments p{std::exp(glm::mix(lowM, highM, i / static_cast<double>(kGrid))),
                         std::exp(glm::mix(lowB, highB, j / static_cast<double>(kGrid))), 0.75};
        if (const double e = error(p); e < least) {
          least = e;
          best = p;
        }
      }
    const double m = std::log(best.melanin), b = std::log(best.blood);
    // Wide enough for an optimum that lies along a slanting valley.
    const double halfM = 2.5 * (highM - lowM) / kGrid, halfB = 2.5 * (highB - lowB) / kGrid;
    lowM = std::max(m - halfM, leastM);
    highM = std::min(m + halfM, mostM);
    lowB = std::max(b - halfB, leastB);
    highB = std::min(b + halfB, mostB);
  }
  return best;
}

glm::dvec3 toneAlbedo(double tone) {
  static const std::array<glm::dvec3, 6> kTones = [] {
    constexpr std::array<std::string_view, 6> kIds = {"skin_tone_i",  "skin_tone_ii", "skin_tone_iii",
                                                      "skin_tone_iv", "skin_tone_v",  "skin_tone_vi"};
    std::array<glm::dvec3, 6> tones{};
    Warnings warnings;
    for (std::size_t i = 0; i < kIds.size(); ++i)
      tones.at(i) = loadBuiltinPreset(kIds.at(i), warnings).value().parameters.baseAlbedo.rgb;
    return tones;
  }();
  const double at = std::clamp(tone, 1.0, 6.0) - 1.0;
  const auto i = std::min(static_cast<std::size_t>(at), kTones.size() - 2);
  return glm::exp(glm::mix(glm::log(kTones.at(i)), glm::log(kTones.at(i + 1)), at - static_cast<double>(i)));
}

}  // namespace dermis::skin
