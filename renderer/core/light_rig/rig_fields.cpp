#include "core/light_rig/rig_fields.h"

#include <array>
#include <initializer_list>

namespace dermis {
namespace {

using enum RigElementType;

constexpr std::uint32_t of(std::initializer_list<RigElementType> types) {
  std::uint32_t bits = 0;
  for (const RigElementType type : types) bits |= 1U << static_cast<unsigned>(type);
  return bits;
}
constexpr std::uint32_t kRectangles = of({Softbox, Strip, Window});
constexpr std::uint32_t kRound = of({Disc, Ring});
constexpr std::uint32_t kFaces = kRectangles | kRound;
constexpr std::uint32_t kAround = of({Dome, Overcast});
constexpr std::uint32_t kPainted = kFaces | kAround | of({Glow});

constexpr float kMax = std::numeric_limits<float>::max();
constexpr Range kNotNegative{0.0F, kMax};
constexpr Range kShare{0.0F, 1.0F};
constexpr Range kTurns{-36000.0F, 36000.0F};
constexpr Range kMetres{0.001F, 10000.0F};
constexpr Range kExtent{0.01F, 179.0F};
constexpr Range kKelvinOfLamps{1000.0F, 15000.0F};
constexpr Range kKelvinOfDaylight{4000.0F, 25000.0F};

constexpr std::array kFields = {
    RigField{"azimuth_degrees", &RigElement::azimuthDegrees, kTurns, kFaces | of({Glow, Sky}), RigGroup::None,
             "Where the element (of a sky: the sun) is, about the vertical: 0 is the camera's side, 90 the camera's "
             "right"},
    RigField{"elevation_degrees",
             &RigElement::elevationDegrees,
             {-90.0F, 90.0F},
             kFaces | of({Glow, Sky}),
             RigGroup::None,
             "Height above the horizon as an angle; 90 is overhead"},
    RigField{"distance_m", &RigElement::distanceM, kMetres, kFaces, RigGroup::None,
             "From the subject to the element's centre"},
    RigField{"aim_m",
             &RigElement::aimM,
             {-10000.0F, 10000.0F},
             kFaces,
             RigGroup::None,
             "The point that the element faces: x, y, z in metres from the subject"},
    RigField{"roll_degrees", &RigElement::rollDegrees, kTurns, kRectangles | of({Glow}), RigGroup::None,
             "Turned in its own plane, anticlockwise as the subject sees it"},
    RigField{"size_m", &RigElement::sizeM, kMetres, kRectangles, RigGroup::Size, "Width and height in metres"},
    RigField{"size_degrees", &RigElement::sizeDegrees, kExtent, kRectangles | of({Glow}), RigGroup::Size,
             "Width and height as angles seen from the subject; of a glow, two standard deviations"},
    RigField{"diameter_m", &RigElement::diameterM, kMetres, kRound, RigGroup::Size, "Outer diameter in metres"},
    RigField{"diameter_degrees", &RigElement::diameterDegrees, kExtent, kRound, RigGroup::Size,
             "Outer diameter as an angle seen from the subject"},
    RigField{"inner_share",
             &RigElement::innerShare,
             {0.0F, 0.99F},
             of({Ring}),
             RigGroup::None,
             "Inner diameter as a share of the outer one"},
    RigField{"edge_share", &RigElement::edgeShare, kShare, of({Softbox, Strip, Disc, Ring}), RigGroup::None,
             "Radiance at the border as a share of that in the middle"},
    RigField{"soft_share", &RigElement::softShare, kShare, kFaces, RigGroup::None,
             "How much of the way from the border to the middle the light needs to rise from 0"},
    RigField{"corner_share", &RigElement::cornerShare, kShare, of({Softbox, Strip}), RigGroup::None,
             "Rounding of the corners; 1 makes the short ends half circles"},
    RigField{"grid_degrees",
             &RigElement::gridDegrees,
             {1.0F, 89.0F},
             of({Softbox, Strip, Disc}),
             RigGroup::None,
             "A grid of square cells in front: past this angle to the face no light leaves"},
    RigField{"panes",
             &RigElement::panes,
             {1.0F, 64.0F},
             of({Window}),
             RigGroup::None,
             "Panes across and upright, whole numbers"},
    RigField{"bar_share",
             &RigElement::barShare,
             {0.0F, 0.9F},
             of({Window}),
             RigGroup::None,
             "Width of the bars as a share of a pane's shorter side"},
    RigField{"lower_share", &RigElement::lowerShare, kNotNegative, of({Window}), RigGroup::None,
             "Radiance at the sill as a share of that at the top"},
    RigField{"zenith", &RigElement::zenith, kNotNegative, of({Dome}), RigGroup::None,
             "Factor overhead, linear Rec.709"},
    RigField{"horizon", &RigElement::horizon, kNotNegative, of({Dome}), RigGroup::None, "Factor at the horizon"},
    RigField{"nadir", &RigElement::nadir, kNotNegative, of({Dome}), RigGroup::None, "Factor straight down"},
    RigField{"exponent",
             &RigElement::exponent,
             {0.05F, 50.0F},
             of({Dome}),
             RigGroup::None,
             "The way from the horizon goes as this power of the sine of the elevation"},
    RigField{"turbidity",
             &RigElement::turbidity,
             {1.8F, 10.0F},
             of({Sky}),
             RigGroup::None,
             "Haze: 2 very clear, 3 clear, 6 hazy, 10 near fog"},
    RigField{"sun", &RigElement::sun, {}, of({Sky}), RigGroup::None, "Whether the sun's disc is there"},
    RigField{"sun_diameter_degrees",
             &RigElement::sunDiameterDegrees,
             {0.1F, 40.0F},
             of({Sky}),
             RigGroup::None,
             "A wider disc has the same irradiance: a sun behind thin cloud"},
    RigField{"sun_share", &RigElement::sunShare, kNotNegative, of({Sky}), RigGroup::None,
             "Factor of the sun, 1 is the model's"},
    RigField{"sky_share", &RigElement::skyShare, kNotNegative, of({Sky}), RigGroup::None,
             "Factor of the sky, 1 is the model's"},
    RigField{"albedo", &RigElement::albedo, kShare, of({Ground}), RigGroup::None,
             "Share of the light from all other elements that the ground returns, linear Rec.709"},
    RigField{"radiance", &RigElement::radiance, kNotNegative, kPainted, RigGroup::Amount,
             "Radiance of the brightest place, scene-linear; 1 when nothing says how bright"},
    RigField{"luminance_cd_m2", &RigElement::luminance, kNotNegative, kPainted, RigGroup::Amount,
             "The same in cd/m², divided by the rig's white_luminance_cd_m2"},
    RigField{"irradiance", &RigElement::irradiance, kNotNegative, kPainted | of({Sky}), RigGroup::Amount,
             "What arrives at the subject on a surface that faces the element's centre (domes and skies: upwards)"},
    RigField{"illuminance_lux", &RigElement::illuminance, kNotNegative, kPainted | of({Sky}), RigGroup::Amount,
             "The same in lux, divided by the rig's white_luminance_cd_m2"},
    RigField{"color", &RigElement::color, kNotNegative, kPainted | of({Sky}), RigGroup::Colour,
             "Factor in linear Rec.709, three numbers or one"},
    RigField{"temperature_k", &RigElement::temperatureK, kKelvinOfLamps, kPainted, RigGroup::Colour,
             "A glowing body of this temperature, luminance kept; 3200 tungsten, 5600 flash"},
    RigField{"daylight_k", &RigElement::daylightK, kKelvinOfDaylight, kPainted, RigGroup::Colour,
             "Daylight of this correlated colour temperature, luminance kept; 6504 is white"},
};

constexpr std::array<RigTypeRow, 10> kTypes = {{
    {"softbox", "A rectangle that glows"},
    {"strip", "A softbox that is narrow"},
    {"disc", "A round one: a beauty dish, a lamp, a lantern"},
    {"ring", "A ring flash; its hole is `inner_share` wide"},
    {"window", "Panes between bars; `aim_m` at its own height makes it upright"},
    {"glow", "A soft round or oval pool of light on a far wall, a Gaussian"},
    {"dome", "All round: a colour overhead, one at the horizon, one below"},
    {"overcast", "The CIE standard overcast sky, three times as bright overhead as at the horizon; nothing below"},
    {"sky", "A clear sky with its sun, by turbidity; nothing below the horizon"},
    {"ground", "The lower half, lit by all other elements"},
}};

}  // namespace

std::span<const RigField> rigFields() { return kFields; }
std::span<const RigTypeRow> rigTypes() { return kTypes; }

}  // namespace dermis
