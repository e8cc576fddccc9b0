#include "core/light_rig/rig_picture.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <numbers>
#include <vector>

#include "core/bake/parallel.h"
#include "core/light_rig/light_colour.h"
#include "core/light_rig/rig_shapes.h"
#include "core/light_rig/sky_model.h"

namespace dermis {
namespace {

constexpr double kPi = std::numbers::pi;

/// The texels' places on the sphere: rows between polar angles, columns between azimuths, as the file convention has
/// it.
class Grid {
 public:
  Grid(int width, int height) : width(width), height(height) {
    for (int row = 0; row < height; ++row) m_rows.push_back(slope(polar(row + 0.5)));
    for (int column = 0; column < width; ++column) m_columns.push_back(slope(azimuth(column + 0.5)));
  }

  int width, height;

  [[nodiscard]] double polar(double row) const { return kPi * row / height; }
  [[nodiscard]] double azimuth(double column) const { return (column / width - 0.5) * 2.0 * kPi; }
  [[nodiscard]] double texelAngle() const { return kPi / height; }
  [[nodiscard]] double solidAngle(int row) const {
    return 2.0 * kPi / width * (std::cos(polar(row)) - std::cos(polar(row + 1)));
  }
  [[nodiscard]] glm::dvec3 middle(int column, int row) const {
    const glm::dvec2& r = m_rows[static_cast<std::size_t>(row)];
    const glm::dvec2& c = m_columns[static_cast<std::size_t>(column)];
    return {r.y * c.y, r.x, -r.y * c.x};
  }
  [[nodiscard]] static glm::dvec3 direction(double cosine, double azimuth) {
    const double sine = std::sqrt(std::max(1.0 - cosine * cosine, 0.0));
    return {sine * std::sin(azimuth), cosine, -sine * std::cos(azimuth)};
  }

 private:
  static glm::dvec2 slope(double angle) { return {std::cos(angle), std::sin(angle)}; }
  std::vector<glm::dvec2> m_rows, m_columns;
};

/// Radiance by texel, of some rows.
class Canvas {
 public:
  Canvas(const Grid& grid, int first, int last)
      : grid(grid),
        first(first),
        last(std::max(first, last)),
        m_values(static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(this->last - first)) {}
  explicit Canvas(const Grid& grid) : Canvas(grid, 0, grid.height) {}

  const Grid& grid;
  int first, last;

  glm::vec3& at(int column, int row) { return m_values[index(column, row)]; }
  [[nodiscard]] const glm::vec3& at(int column, int row) const { return m_values[index(column, row)]; }
  [[nodiscard]] const std::vector<glm::vec3>& values() const { return m_values; }

  void add(const Canvas& other, const glm::dvec3& factor) {
    const glm::vec3 f(factor);
    for (int row = other.first; row < other.last; ++row)
      for (int column = 0; column < grid.width; ++column) at(column, row) += f * other.at(column, row);
  }

 private:
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row - first) * static_cast<std::size_t>(grid.width) +
           static_cast<std::size_t>(column);
  }
  std::vector<glm::vec3> m_values;
};

/// Calls work(row) for each of the rows, from several threads.
template <class Work>
void forRows(int first, int last, const Work& work) {
  forPieces(
      static_cast<std::size_t>(last - first), 8, {},
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) work(first + static_cast<int>(i));
      },
      [](float) {});
}

/// Σ L cos⁺ dΩ over rows of `texel(column, row)`.
template <class Texel>
glm::dvec3 irradiance(const Grid& grid, int first, int last, const Texel& texel, const glm::dvec3& normal) {
  std::vector<glm::dvec3> rows(static_cast<std::size_t>(last - first), glm::dvec3(0.0));
  forRows(first, last, [&](int row) {
    glm::dvec3 sum(0.0);
    for (int column = 0; column < grid.width; ++column)
      sum += glm::dvec3(texel(column, row)) * std::max(glm::dot(grid.middle(column, row), normal), 0.0);
    rows[static_cast<std::size_t>(row - first)] = sum * grid.solidAngle(row);
  });
  // In a fixed order, so that the sum is the same whatever the threads did.
  glm::dvec3 sum(0.0);
  for (const glm::dvec3& row : rows) sum += row;
  return sum;
}
glm::dvec3 irradiance(const Canvas& canvas, const glm::dvec3& normal) {
  return irradiance(
      canvas.grid, canvas.first, canvas.last, [&](int column, int row) { return canvas.at(column, row); }, normal);
}

/// What has no edges but the horizon, which lies between two rows.
void paintSmooth(Canvas& canvas, const std::function<glm::dvec3(const glm::dvec3&)>& radiance) {
  forRows(canvas.first, canvas.last, [&](int row) {
    for (int column = 0; column < canvas.grid.width; ++column)
      canvas.at(column, row) += glm::vec3(radiance(canvas.grid.middle(column, row)));
  });
}

/// The mean of a shape over one texel. Where an edge crosses it, over samples of equal solid angle that are fine
/// against the shape's narrowest part; they form a Fibonacci lattice, none level with another, because near a pole an
/// edge may run along a whole row.
float meanOver(const RigShape& shape, const Grid& grid, int column, int row) {
  const ShapeSample middle = shape.sample(glm::vec3(grid.middle(column, row)));
  const double texel = grid.texelAngle();
  constexpr double kHalfDiagonal = 0.75;
  if (middle.edge > kHalfDiagonal * texel) return middle.value;
  constexpr double kSamplesAcross = 48.0;
  const double across = std::clamp(kSamplesAcross * texel / std::max<double>(shape.finest, 1e-6), 12.0, 64.0);
  const int count = static_cast<int>(across * across);
  const double top = std::cos(grid.polar(row));
  const double bottom = std::cos(grid.polar(row + 1));
  double sum = 0.0;
  for (int i = 0; i < count; ++i) {
    const double u = (i + 0.5) * std::numbers::phi;
    const double cosine = glm::mix(top, bottom, (i + 0.5) / count);
    sum += static_cast<double>(
        shape.sample(glm::vec3(Grid::direction(cosine, grid.azimuth(column + u - std::floor(u))))).value);
  }
  return static_cast<float>(sum / count);
}

/// A shape on as many rows as it reaches.
Canvas shapePicture(const Grid& grid, const RigShape& shape) {
  const double cone = std::min(shape.coneAngle + grid.texelAngle(), kPi);
  const double cosine = std::cos(cone);
  const double polar = std::acos(std::clamp<double>(shape.axis.y, -1.0, 1.0));
  Canvas canvas(grid, std::max(0, static_cast<int>((polar - cone) / grid.texelAngle())),
                std::min(grid.height, static_cast<int>((polar + cone) / grid.texelAngle()) + 1));
  forRows(canvas.first, canvas.last, [&](int row) {
    for (int column = 0; column < grid.width; ++column)
      if (glm::dot(grid.middle(column, row), glm::dvec3(shape.axis)) >= cosine)
        canvas.at(column, row) = glm::vec3(meanOver(shape, grid, column, row));
  });
  return canvas;
}

glm::dvec3 colourOf(const RigElement& e) {
  if (e.temperatureK) return colourOfChromaticity(blackBodyChromaticity(*e.temperatureK));
  if (e.daylightK) return colourOfChromaticity(daylightChromaticity(*e.daylightK));
  return e.color.value_or(glm::vec3(1.0F));
}

void paintGlow(Canvas& canvas, const RigElement& e) {
  const glm::dvec3 axis(rigDirection(e.azimuthDegrees, e.elevationDegrees));
  const glm::dvec3 vertical = std::abs(axis.y) < 0.9999 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, -1);
  const glm::dvec3 right = glm::normalize(glm::cross(axis, vertical));
  const glm::dvec3 up = glm::cross(right, axis);
  const double roll = glm::radians(static_cast<double>(e.rollDegrees));
  const glm::dvec3 u = std::cos(roll) * right + std::sin(roll) * up;
  const glm::dvec3 v = std::cos(roll) * up - std::sin(roll) * right;
  const glm::dvec2 deviation = glm::radians(glm::dvec2(e.sizeDegrees.value_or(glm::vec2(30.0F)))) / 2.0;
  paintSmooth(canvas, [=](const glm::dvec3& d) {
    // Angles from the middle, kept in length and direction: nothing breaks off however wide the glow is.
    const glm::dvec2 across(glm::dot(d, u), glm::dot(d, v));
    const double sine = glm::length(across);
    const double angle = std::atan2(sine, glm::dot(d, axis));
    const glm::dvec2 q = (sine > 1e-9 ? across * (angle / sine) : glm::dvec2(angle, 0.0)) / deviation;
    return glm::dvec3(std::exp(-0.5 * glm::dot(q, q)));
  });
}

void paintDome(Canvas& canvas, const RigElement& e) {
  paintSmooth(canvas, [&e](const glm::dvec3& d) {
    const glm::dvec3 far(d.y >= 0.0 ? e.zenith : e.nadir);
    return glm::mix(glm::dvec3(e.horizon), far, std::pow(std::abs(d.y), static_cast<double>(e.exponent)));
  });
}

void paintOvercast(Canvas& canvas) {
  // CIE standard overcast sky (Moon & Spencer 1942; CIE S 011, type 16's forerunner): L = L_z (1 + 2 sin γ) / 3.
  paintSmooth(canvas, [](const glm::dvec3& d) { return glm::dvec3(d.y > 0.0 ? (1.0 + 2.0 * d.y) / 3.0 : 0.0); });
}

/// In cd/m²; the sun's disc holds its irradiance whatever its size.
void paintSky(Canvas& canvas, const RigElement& e) {
  const glm::dvec3 sun(rigDirection(e.azimuthDegrees, e.elevationDegrees));
  if (e.skyShare > 0.0F) {
    const SkyModel model(e.turbidity, sun);
    paintSmooth(canvas, [&](const glm::dvec3& d) {
      return d.y > 0.0 ? model.radiance(d) * static_cast<double>(e.skyShare) : glm::dvec3(0.0);
    });
  }
  if (!e.sun) return;
  const double radius = glm::radians(static_cast<double>(e.sunDiameterDegrees)) / 2.0;
  const glm::dvec3 illuminance = sunIlluminance(e.turbidity, glm::radians(static_cast<double>(e.elevationDegrees))) *
                                 static_cast<double>(e.sunShare);
  // Irradiance of a disc of radiance 1 that is faced: π sin² of its radius.
  const glm::dvec3 disc = illuminance / (kPi * std::sin(radius) * std::sin(radius));
  canvas.add(shapePicture(canvas.grid, discShape(glm::vec3(sun), static_cast<float>(radius))), disc);
}

/// What the element asks for as a factor on `own`, its picture, whose brightest place is 1 (a sky's: in cd/m²).
double amount(const RigElement& e, const Canvas& own, const glm::dvec3& facing, double white) {
  if (e.radiance) return *e.radiance;
  if (e.luminance) return *e.luminance / white;
  if (!e.irradiance && !e.illuminance) return e.type == RigElementType::Sky ? 1.0 / white : 1.0;
  const double found = luminance(irradiance(own, facing));
  return found > 0.0 ? (e.irradiance ? *e.irradiance : *e.illuminance / white) / found : 0.0;
}

void paintElement(Canvas& canvas, const RigElement& e, double white) {
  const auto add = [&](const Canvas& own, const glm::dvec3& facing) {
    canvas.add(own, amount(e, own, facing, white) * colourOf(e));
  };
  constexpr glm::dvec3 kUp(0.0, 1.0, 0.0);
  switch (e.type) {
    case RigElementType::Glow:
    case RigElementType::Dome:
    case RigElementType::Overcast:
    case RigElementType::Sky: {
      Canvas own(canvas.grid);
      if (e.type == RigElementType::Glow) paintGlow(own, e);
      if (e.type == RigElementType::Dome) paintDome(own, e);
      if (e.type == RigElementType::Overcast) paintOvercast(own);
      if (e.type == RigElementType::Sky) paintSky(own, e);
      const bool placed = e.type == RigElementType::Glow;
      return add(own, placed ? glm::dvec3(rigDirection(e.azimuthDegrees, e.elevationDegrees)) : kUp);
    }
    case RigElementType::Ground: {
      // A diffuse plane returns albedo · E / π.
      const glm::dvec3 radiance = glm::dvec3(e.albedo) * irradiance(canvas, kUp) / kPi;
      return paintSmooth(canvas, [=](const glm::dvec3& d) { return d.y < 0.0 ? radiance : glm::dvec3(0.0); });
    }
    default: {
      const RigShape shape = lampShape(e);
      return add(shapePicture(canvas.grid, shape), glm::dvec3(shape.axis));
    }
  }
}

}  // namespace

Result<std::shared_ptr<const Image>> rigPicture(const LightRig& rig, int width, const std::stop_token& stop) {
  if (width == 0) width = rig.width;
  const Grid grid(width, width / 2);
  Canvas canvas(grid);
  // The ground last: it returns what comes from all others.
  for (const bool ground : {false, true})
    for (const RigElement& element : rig.elements) {
      if (stop.stop_requested()) return cancelledError();
      if (element.enabled && (element.type == RigElementType::Ground) == ground)
        paintElement(canvas, element, rig.whiteLuminance);
    }
  auto image = std::make_shared<Image>();
  image->width = grid.width;
  image->height = grid.height;
  image->channels = 3;
  image->type = PixelType::Float;
  image->name = rig.name;
  image->pixels.resize(canvas.values().size() * sizeof(glm::vec3));
  std::memcpy(image->pixels.data(), canvas.values().data(), image->pixels.size());
  return image;
}

glm::dvec3 irradianceOf(const Image& latLong, const glm::dvec3& normal) {
  const auto texel = [&](int column, int row) {
    glm::vec3 value;
    const std::size_t index =
        static_cast<std::size_t>(row) * static_cast<std::size_t>(latLong.width) + static_cast<std::size_t>(column);
    std::memcpy(&value, latLong.pixels.data() + index * sizeof value, sizeof value);
    return value;
  };
  return irradiance(Grid(latLong.width, latLong.height), 0, latLong.height, texel, normal);
}

}  // namespace dermis
