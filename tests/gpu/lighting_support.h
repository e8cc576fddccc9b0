// Environments made in the test, and what the definitions say of them: plain double sums over every pixel, written
// without a look at the code under test.
#pragma once

#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <numbers>
#include <random>
#include <vector>

#include "core/scene/resolved_scene.h"

namespace dermis::test {

/// RGB of pixel (i, j).
using PixelFunction = std::function<glm::vec3(int i, int j)>;

inline std::shared_ptr<const Image> makeFloatImage(int width, int height, const PixelFunction& pixel) {
  auto image = std::make_shared<Image>();
  image->width = width;
  image->height = height;
  image->channels = 3;
  image->type = PixelType::Float;
  std::vector<glm::vec3> values;
  for (int j = 0; j < height; ++j)
    for (int i = 0; i < width; ++i) values.push_back(pixel(i, j));
  image->pixels.resize(values.size() * sizeof(glm::vec3));
  std::memcpy(image->pixels.data(), values.data(), image->pixels.size());
  return image;
}

inline std::shared_ptr<const EnvironmentImages> latLongEnvironment(int width, int height, const PixelFunction& pixel) {
  auto images = std::make_shared<EnvironmentImages>();
  images->latLong = makeFloatImage(width, height, pixel);
  images->name = "test.hdr";
  return images;
}

/// Where a lat-long pixel looks, as the conventions say: u = .5 to −Z, u = .75 to +X, the top row to +Y.
inline glm::dvec3 pixelDirection(int i, int j, int width, int height) {
  const double phi = ((i + 0.5) / width - 0.5) * 2.0 * std::numbers::pi;
  const double theta = (j + 0.5) / height * std::numbers::pi;
  return {std::sin(theta) * std::sin(phi), std::cos(theta), -std::sin(theta) * std::cos(phi)};
}

inline glm::vec3 imagePixel(const Image& image, int i, int j) {
  glm::vec3 value;
  std::memcpy(&value,
              image.pixels.data() +
                  (static_cast<std::size_t>(j) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(i)) *
                      sizeof(glm::vec3),
              sizeof value);
  return value;
}

/// What a surface or lobe that looks along n receives: sums over all pixels.
struct ExactLight {
  glm::dvec3 irradiance{0.0};           ///< / π
  std::vector<glm::dvec3> prefiltered;  ///< for each perceptual roughness
};

/// Σ L K ω / Σ K ω over all pixels, K = n·l for irradiance and D(h) (n·l) with n = v = r for a GGX lobe (D: Walter et
/// al. 2007, equation 33).
inline ExactLight exactLight(const Image& image, const glm::dvec3& n, const std::vector<float>& roughnesses) {
  ExactLight light;
  light.prefiltered.assign(roughnesses.size(), glm::dvec3(0.0));
  std::vector<double> totals(roughnesses.size(), 0.0), alpha2;
  for (const float r : roughnesses) alpha2.push_back(std::pow(static_cast<double>(r), 4.0));
  double total = 0.0;
  for (int j = 0; j < image.height; ++j) {
    const double theta = (j + 0.5) / image.height * std::numbers::pi;
    for (int i = 0; i < image.width; ++i) {
      const double phi = ((i + 0.5) / image.width - 0.5) * 2.0 * std::numbers::pi;
      const glm::dvec3 l{std::sin(theta) * std::sin(phi), std::cos(theta), -std::sin(theta) * std::cos(phi)};
      const double cosine = glm::dot(n, l);
      if (cosine <= 0.0) continue;
      const double w = cosine * std::sin(theta);
      const glm::dvec3 radiance(imagePixel(image, i, j));
      light.irradiance += w * radiance;
      total += w;
      // |n × h|² = |n − l|² / 4 for h half way between unit vectors: it keeps its digits for narrow lobes.
      const glm::dvec3 apart = n - l;
      const double sine2 = glm::dot(apart, apart) / 4.0;
      for (std::size_t k = 0; k < alpha2.size(); ++k) {
        const double d = alpha2[k] * (1.0 - sine2) + sine2;
        light.prefiltered[k] += w / (d * d) * radiance;
        totals[k] += w / (d * d);
      }
    }
  }
  light.irradiance /= total;
  for (std::size_t k = 0; k < alpha2.size(); ++k) light.prefiltered[k] /= totals[k];
  return light;
}

/// The 26 directions of a cube's faces, edges and corners.
inline std::vector<glm::vec3> cubeDirections26() {
  std::vector<glm::vec3> directions;
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z)
        if (x != 0 || y != 0 || z != 0) directions.push_back(glm::normalize(glm::vec3(x, y, z)));
  return directions;
}

/// 26 directions that favour no texel: a spiral.
inline std::vector<glm::vec3> spiralDirections26() {
  std::vector<glm::vec3> directions;
  for (int i = 0; i < 26; ++i) {
    const double y = 1.0 - 2.0 * (i + 0.5) / 26.0;
    const double turn = 2.399963 * i;
    const double r = std::sqrt(1.0 - y * y);
    directions.emplace_back(r * std::cos(turn), y, r * std::sin(turn));
  }
  return directions;
}

/// Root of the mean square error over the root of the mean square value, all directions and channels.
inline double relativeRms(const std::vector<glm::vec3>& got, const std::vector<glm::dvec3>& want) {
  double error = 0.0;
  double value = 0.0;
  for (std::size_t i = 0; i < got.size(); ++i) {
    const glm::dvec3 difference = glm::dvec3(got[i]) - want[i];
    error += glm::dot(difference, difference);
    value += glm::dot(want[i], want[i]);
  }
  return std::sqrt(error / value);
}

/// The four lights the accuracy is asserted on, each with its own difficulty.
struct NamedEnvironment {
  const char* name;
  std::shared_ptr<const EnvironmentImages> images;
};

inline std::vector<NamedEnvironment> testEnvironments() {
  constexpr int kWidth = 1024, kHeight = 512;
  std::vector<NamedEnvironment> list;
  list.push_back({"sky", latLongEnvironment(kWidth, kHeight, [](int i, int j) {
                    const glm::dvec3 d = pixelDirection(i, j, kWidth, kHeight);
                    return d.y > 0.0 ? glm::mix(glm::vec3(1.2F, 1.1F, 1.0F), glm::vec3(0.2F, 0.4F, 1.0F),
                                                static_cast<float>(d.y))
                                     : glm::vec3(0.15F, 0.12F, 0.1F);
                  })});
  list.push_back({"sun of 86,000", latLongEnvironment(kWidth, kHeight, [](int i, int j) {
                    // Two pixels across, as real ones are, over a dim sky.
                    const bool sun = i >= 699 && i <= 700 && j >= 141 && j <= 142;
                    return sun ? glm::vec3(86000.0F, 70000.0F, 52000.0F) : glm::vec3(0.3F, 0.4F, 0.5F);
                  })});
  list.push_back(
      {"soft boxes in the dark", latLongEnvironment(kWidth, kHeight, [](int i, int j) {
         const bool key = i > 300 && i < 380 && j > 100 && j < 180;
         const bool rim = i > 820 && i < 840 && j > 150 && j < 330;
         return key ? glm::vec3(40.0F, 36.0F, 30.0F) : rim ? glm::vec3(60.0F, 70.0F, 90.0F) : glm::vec3(0.02F);
       })});
  auto random = std::make_shared<std::mt19937>(7U);
  list.push_back({"many small lamps", latLongEnvironment(kWidth, kHeight, [random](int, int) {
                    const auto roll = (*random)();
                    const float grey = 0.05F + static_cast<float>(roll & 1023U) / 8192.0F;
                    return roll % 2003U == 0 ? glm::vec3(grey + 900.0F, grey + 700.0F, grey + 400.0F) : glm::vec3(grey);
                  })});
  return list;
}

}  // namespace dermis::test
