// Light rigs as pictures: their integrals against closed forms and against quadratures of the lamps themselves.
#include "core/light_rig/rig_picture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <numbers>

#include "core/base/resources.h"
#include "core/builtin/environments.h"
#include "core/light_rig/light_colour.h"
#include "core/light_rig/rig_io.h"
#include "core/light_rig/sky_model.h"
#include "reference/quadrature.h"

namespace dermis {
namespace {

constexpr double kPi = std::numbers::pi;

LightRig rigOf(const std::string& elements, int width = 512) {
  Warnings warnings;
  const auto rig = readRig(R"({"format": "dermis.rig", "version": 1, "white_luminance_cd_m2": 250, "width": )" +
                               std::to_string(width) + ", \"elements\": [" + elements + "]}",
                           "test", warnings);
  EXPECT_TRUE(rig) << (rig ? "" : rig.error().message);
  EXPECT_TRUE(warnings.empty());
  return rig.value_or(LightRig{});
}

/// ∫ L weight(direction) dω over a lat-long picture, written down anew from the convention.
glm::dvec3 integral(const Image& image, const std::function<double(const glm::dvec3&)>& weight) {
  glm::dvec3 sum(0.0);
  for (int j = 0; j < image.height; ++j) {
    const double theta = kPi * (j + 0.5) / image.height;
    const double texel =
        (std::cos(kPi * j / image.height) - std::cos(kPi * (j + 1) / image.height)) * 2.0 * kPi / image.width;
    for (int i = 0; i < image.width; ++i) {
      const double phi = ((i + 0.5) / image.width - 0.5) * 2.0 * kPi;
      glm::vec3 value;
      std::memcpy(&value, image.pixels.data() + static_cast<std::size_t>(j * image.width + i) * sizeof value,
                  sizeof value);
      sum += glm::dvec3(value) * texel *
             weight({std::sin(theta) * std::sin(phi), std::cos(theta), -std::sin(theta) * std::cos(phi)});
    }
  }
  return sum;
}
glm::dvec3 solidAngle(const Image& image) {
  return integral(image, [](const glm::dvec3&) { return 1.0; });
}
glm::dvec3 facing(const Image& image, const glm::dvec3& normal) {
  return integral(image, [&](const glm::dvec3& d) { return std::max(glm::dot(d, normal), 0.0); });
}

/// Of a w×h rectangle at distance d that is looked at along its axis.
double rectangleSolidAngle(double w, double h, double d) {
  return 4.0 * std::atan(w * h / (2.0 * d * std::sqrt(4.0 * d * d + w * w + h * h)));
}

TEST(RigPicture, SolidAnglesAreThoseOfTheShapes) {
  // In the middle, across the seam, on a pole, turned: nothing depends on where the texels lie.
  for (const char* place :
       {R"("azimuth_degrees": 30, "elevation_degrees": 20)", R"("azimuth_degrees": 1, "elevation_degrees": 70)",
        R"("azimuth_degrees": 180.3, "elevation_degrees": 0)", R"("azimuth_degrees": 77, "elevation_degrees": 90)",
        R"("azimuth_degrees": -60, "elevation_degrees": -35)"}) {
    const std::string at = std::string(place) + R"(, "distance_m": 2.5, "radiance": 1)";
    const auto measured = [&](const std::string& rest) {
      const auto picture = rigPicture(rigOf("{" + at + "," + rest + "}"));
      return solidAngle(**picture).g;
    };
    EXPECT_NEAR(measured(R"("type": "softbox", "size_m": [1.4, 0.9])") / rectangleSolidAngle(1.4, 0.9, 2.5), 1.0, 1e-3)
        << place;
    EXPECT_NEAR(
        measured(R"("type": "strip", "size_m": [0.1, 1.6], "roll_degrees": 33)") / rectangleSolidAngle(0.1, 1.6, 2.5),
        1.0, 2e-3)
        << place;
    const auto cap = [](double diameter) { return 2.0 * kPi * (1.0 - std::cos(std::atan(diameter / 2.0 / 2.5))); };
    EXPECT_NEAR(measured(R"("type": "disc", "diameter_m": 0.6)") / cap(0.6), 1.0, 1e-3) << place;
    EXPECT_NEAR(measured(R"("type": "disc", "diameter_degrees": 0.5)") / (2.0 * kPi * (1.0 - std::cos(kPi / 720.0))),
                1.0, 5e-3)
        << place;
    EXPECT_NEAR(measured(R"("type": "ring", "diameter_m": 0.8, "inner_share": 0.75)") / (cap(0.8) - cap(0.6)), 1.0,
                2e-3)
        << place;
  }
}

TEST(RigPicture, WindowsLoseTheirBars) {
  // Two by two panes of 0.5 m with bars of 0.05 m: each pane of glass is 0.45 m wide, its middle 0.25 m from the axis.
  const auto corner = [](double x, double y) { return std::atan(x * y / (2.0 * std::sqrt(x * x + y * y + 4.0))); };
  const double glass = 4.0 * (corner(0.475, 0.475) - 2.0 * corner(0.475, 0.025) + corner(0.025, 0.025));
  const auto picture =
      rigPicture(rigOf(R"({"type": "window", "azimuth_degrees": 50, "distance_m": 2, "size_m": [1, 1], "panes": [2, 2],
                "bar_share": 0.1})"));
  EXPECT_NEAR(solidAngle(**picture).g / glass, 1.0, 2e-3);
}

TEST(RigPicture, StatedIrradiancesAndIlluminancesArriveWhateverTheShape) {
  for (const char* shape :
       {R"("type": "softbox", "edge_share": 0.4, "soft_share": 0.3, "grid_degrees": 35)",
        R"("type": "strip", "size_m": [0.2, 1.5], "aim_m": [0.5, 1, 0.3])", R"("type": "ring", "diameter_m": 0.5)",
        R"("type": "window", "panes": [3, 2], "lower_share": 0.3, "aim_m": [0, 1, 0])",
        R"("type": "glow", "size_degrees": [90, 50], "roll_degrees": 20)"}) {
    const glm::dvec3 axis = glm::dvec3(rigDirection(-70.0F, 25.0F));
    const std::string at = std::string(R"({"azimuth_degrees": -70, "elevation_degrees": 25, )") + shape;
    EXPECT_NEAR(facing(**rigPicture(rigOf(at + R"(, "irradiance": 2.5})")), axis).g, 2.5, 0.003) << shape;
    EXPECT_NEAR(facing(**rigPicture(rigOf(at + R"(, "illuminance_lux": 500})")), axis).g, 2.0, 0.003) << shape;
    // Temperatures change the colour, not how bright it is.
    EXPECT_NEAR(luminance(facing(**rigPicture(rigOf(at + R"(, "irradiance": 2.5, "temperature_k": 2800})")), axis)),
                2.5, 0.003)
        << shape;
  }
}

TEST(RigPicture, SoftboxesWithFalloffGiveWhatAQuadratureOverTheirFaceGives) {
  // E = ∫ L cos cos′ / r² dA over the face, which looks past the subject.
  const glm::dvec3 centre = glm::dvec3(rigDirection(40.0F, 30.0F)) * 1.8;
  const glm::dvec3 aim(0.3, -0.2, 0.4);
  const glm::dvec3 normal = glm::normalize(aim - centre);
  const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), normal));
  const glm::dvec3 up = glm::cross(normal, right);
  const double width = 1.2, height = 0.8, edge = 0.3, grid = std::tan(glm::radians(50.0));
  const glm::dvec3 axis = glm::normalize(centre);
  double expected = 0.0;
  const auto nodes = reference::gaussLegendre(64);
  for (const auto& u : nodes)
    for (const auto& v : nodes) {
      const glm::dvec2 q(2.0 * u.x - 1.0, 2.0 * v.x - 1.0);
      const glm::dvec3 p = centre + right * (q.x * width / 2.0) + up * (q.y * height / 2.0);
      const glm::dvec3 d = glm::normalize(p);
      const double cosine = -glm::dot(d, normal);
      const double cells =
          (1.0 - std::abs(glm::dot(d, right)) / cosine / grid) * (1.0 - std::abs(glm::dot(d, up)) / cosine / grid);
      const double radiance = 3.0 * (1.0 + (edge - 1.0) * 0.5 * glm::dot(q, q)) * cells;
      expected += u.weight * v.weight * width * height * radiance * cosine * glm::dot(d, axis) / glm::dot(p, p);
    }
  const auto picture = rigPicture(rigOf(
      R"({"type": "softbox", "azimuth_degrees": 40, "elevation_degrees": 30, "distance_m": 1.8, "size_m": [1.2, 0.8],
          "aim_m": [0.3, -0.2, 0.4], "edge_share": 0.3, "grid_degrees": 50, "radiance": 3})"));
  EXPECT_NEAR(facing(**picture, axis).g / expected, 1.0, 1e-3);
}

TEST(RigPicture, DomesAndOvercastSkiesFollowTheirClosedForms) {
  const glm::dvec3 up(0, 1, 0);
  EXPECT_NEAR(facing(**rigPicture(rigOf(R"({"type": "dome"})")), up).r, kPi, 1e-4);
  // ∫ (h + (z − h) sᵅ) s dω = 2π (h/2 + (z − h)/(α + 2))
  const auto gradient = rigPicture(rigOf(R"({"type": "dome", "zenith": 2, "horizon": 0.5, "exponent": 1.7})"));
  EXPECT_NEAR(facing(**gradient, up).g, 2.0 * kPi * (0.25 + 1.5 / 3.7), 1e-3);
  // Moon & Spencer: a level plane below an overcast sky of zenith luminance L receives 7π/9 L.
  const auto sky = rigPicture(rigOf(R"({"type": "overcast", "luminance_cd_m2": 250})"));
  EXPECT_NEAR(facing(**sky, up).g, 7.0 * kPi / 9.0, 1e-3);
  EXPECT_EQ(facing(**sky, -up).g, 0.0);
  const auto above = rigPicture(rigOf(R"({"type": "ground", "albedo": [0.3, 0.2, 0.1]}, {"type": "overcast"})"));
  EXPECT_NEAR(facing(**above, -up).r / (0.3 * 7.0 * kPi / 9.0), 1.0, 1e-3);
  EXPECT_NEAR(facing(**above, -up).b / (0.1 * 7.0 * kPi / 9.0), 1.0, 1e-3);
}

TEST(RigPicture, TheSunHasItsIlluminanceHoweverWideItsDisc) {
  const glm::dvec3 expected = sunIlluminance(3.0, glm::radians(12.0)) / 250.0;
  const glm::dvec3 sun(rigDirection(100.0F, 12.0F));
  for (const char* width : {"0.533", "2", "9"}) {
    const auto picture =
        rigPicture(rigOf(std::string(R"({"type": "sky", "azimuth_degrees": 100, "elevation_degrees": 12, "turbidity": 3,
                              "sky_share": 0, "sun_diameter_degrees": )") +
                         width + "}"));
    const glm::dvec3 found = facing(**picture, sun);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i] / expected[i], 1.0, 4e-3) << width;
  }
}

TEST(RigPicture, PlacesFollowTheFileConvention) {
  // Azimuth 0 is +Z, the camera's side; 90 is +X; elevation is towards +Y. Roll turns anticlockwise for the subject.
  const auto centroid = [](const std::string& text) {
    const auto picture = rigPicture(rigOf(text));
    return glm::normalize(glm::dvec3(integral(**picture, [](const glm::dvec3& d) { return d.x; }).g,
                                     integral(**picture, [](const glm::dvec3& d) { return d.y; }).g,
                                     integral(**picture, [](const glm::dvec3& d) { return d.z; }).g));
  };
  EXPECT_NEAR(glm::distance(centroid(R"({"type": "disc"})"), {0, 0, 1}), 0.0, 1e-3);
  EXPECT_NEAR(glm::distance(centroid(R"({"type": "disc", "azimuth_degrees": 90})"), {1, 0, 0}), 0.0, 1e-3);
  EXPECT_NEAR(glm::distance(centroid(R"({"type": "glow", "elevation_degrees": 90})"), {0, 1, 0}), 0.0, 1e-3);
  // A strip before the subject, turned by 45°: its upper end goes to the subject's left, which is +X.
  const auto picture = rigPicture(rigOf(R"({"type": "strip", "size_m": [0.2, 2], "roll_degrees": 45})"));
  EXPECT_GT(integral(**picture, [](const glm::dvec3& d) { return d.x * d.y; }).g, 0.002);
}

TEST(RigPicture, DisabledElementsAreDarkAndTheRestAddsUp) {
  const std::string a = R"({"type": "disc", "diameter_m": 0.4})", b = R"({"type": "glow", "azimuth_degrees": 10})";
  const double both = solidAngle(**rigPicture(rigOf(a + "," + b))).g;
  const double first = solidAngle(**rigPicture(rigOf(a))).g, second = solidAngle(**rigPicture(rigOf(b))).g;
  EXPECT_NEAR(both, first + second, 1e-5);
  EXPECT_NEAR(solidAngle(**rigPicture(rigOf(a + R"(, {"type": "glow", "enabled": false})"))).g, first, 1e-9);
}

TEST(BuiltinRigs, EveryOneIsSoundAndListed) {
  const auto rows = builtinEnvironments();
  EXPECT_EQ(rows.size(), resourcePaths("rigs/").size());
  for (const BuiltinEnvironmentRow& row : rows) {
    EXPECT_FALSE(row.label.empty() || row.sentence.empty()) << row.id;
    Warnings warnings;
    const auto rig = readRig(resource("rigs/" + row.id + ".json"), row.id, warnings);
    ASSERT_TRUE(rig) << rig.error().message;
    EXPECT_TRUE(warnings.empty()) << row.id << ": " << warnings.front();
    // What each element states is what it gives on its own, whatever the picture's size.
    for (const RigElement& element : rig->elements) {
      if (!element.irradiance || element.color) continue;
      LightRig alone = *rig;
      alone.elements = {element};
      const glm::dvec3 axis = element.type == RigElementType::Dome
                                  ? glm::dvec3(0, 1, 0)
                                  : glm::dvec3(rigDirection(element.azimuthDegrees, element.elevationDegrees));
      EXPECT_NEAR(luminance(facing(**rigPicture(alone, 256), axis)) / static_cast<double>(*element.irradiance), 1.0,
                  2e-3)
          << row.id << " " << element.name;
    }
  }
}

TEST(BuiltinRigs, ExposureSuitsSkinInAllOfThem) {
  // The brighter of what arrives from the camera's side, from above and from the sides; a rim light comes from behind.
  for (const BuiltinEnvironmentRow& row : builtinEnvironments()) {
    const auto environment = builtinEnvironment(row.id, 256);
    double most = 0.0;
    for (const glm::dvec3& normal :
         {glm::dvec3(0, 0, 1), glm::dvec3(0, 1, 0), glm::dvec3(1, 0, 0), glm::dvec3(-1, 0, 0)})
      most = std::max(most, luminance(facing(*environment->latLong, normal)));
    EXPECT_GT(most, 1.5) << row.id;
    EXPECT_LT(most, 8.0) << row.id;
  }
}

}  // namespace
}  // namespace dermis
