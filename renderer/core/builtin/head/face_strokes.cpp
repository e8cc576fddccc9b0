#include "core/builtin/head/face_strokes.h"

#include "core/builtin/head/lids.h"

namespace dermis::sculpt {
namespace {

using enum DrawnFrom;

/// A stroke about the eye: points relative to its centre.
DrawnStroke roundEye(std::string_view name, float radius, const std::vector<glm::vec3>& points) {
  DrawnStroke stroke{name, Front, {}};
  for (const glm::vec3& p : points) stroke.points.push_back({kEyeCentre.x + p.x, kEyeCentre.y + p.y, radius, p.z});
  return stroke;
}

}  // namespace

std::vector<DrawnStroke> broadStrokes() {
  return {
      {"brow ridge",
       Front,
       {{9, 19, 12, 0.5F}, {20, 21, 13, 0.9F}, {32, 21.5F, 13, 0.6F}, {44, 18.5F, 12, 0.5F}, {52, 12, 10, 0.4F}}},
      {"inner orbit", Front, {{16, 6, 8, -0.4F}}},
      {"inner corner of the eye", Front, {{16, -1.0F, 10, -0.9F}, {20, -0.5F, 9, -0.9F}}},
      {"temple", Side, {{50, 24, 22, -1.2F}, {44, 6, 20, -0.6F}}},
      {"cheekbone", Front, {{38, -24, 18, 0.5F}, {50, -20, 18, 0.5F}, {60, -17, 16, 0.3F}}},
      {"under the cheekbone", Side, {{50, -46, 22, -0.1F}, {34, -56, 22, -0.05F}}},
      {"frontal eminence", Front, {{26, 56, 26, 0.8F}}},
      {"chin", Front, {{0, -101, 14, 1.2F}, {10, -102, 12, 1.0F}}},
      {"sternomastoid", Side, {{-22, -46, 14, 1.2F}, {-14, -80, 16, 2.6F}, {2, -112, 16, 3.0F}, {14, -135, 15, 3.0F}}},
  };
}

std::vector<DrawnStroke> fineStrokes() {
  return {
      {"sternomastoid to the sternum",
       Front,
       {{44, -132, 17, 1.6F}, {32, -155, 15, 2.4F}, {20, -178, 13, 2.6F}, {11, -195, 10, 1.8F}}},
      {"clavicle", Front, {{12, -199, 10, 1.8F}, {30, -197, 11, 2.6F}, {55, -193, 12, 3.0F}, {80, -190, 13, 2.6F}}},
      {"suprasternal notch", Front, {{0, -194, 16, -2.6F}}},
      {"supraclavicular hollow", Front, {{34, -186, 14, -3.0F}, {55, -180, 14, -3.0F}}},
      {"larynx", Front, {{0, -131, 15, 1.4F}, {0, -143, 15, 1.5F}, {0, -154, 12, 0.6F}}},
      {"nasolabial fold",
       Front,
       {{20.5F, -37, 8, -0.3F}, {25, -48, 11, -0.65F}, {30.5F, -60, 12, -0.5F}, {34, -71, 11, -0.1F}}},
      {"cheek over the fold", Front, {{33, -42, 18, 0.7F}, {39, -53, 18, 0.4F}}},
      {"groove over the wing",
       Front,
       {{9.5F, -31.0F, 5.5F, -0.05F},
        {13.3F, -33.0F, 5.5F, -0.15F},
        {16.2F, -36.5F, 4.8F, -0.4F},
        {17.6F, -42, 4.2F, -0.45F}}},
      {"cheek before the masseter", Front, {{47, -31, 17, 0.9F}, {52, -40, 17, 0.6F}}},
      {"tear trough", Front, {{18, -10, 9, -0.2F}, {23, -15.5F, 12, -0.55F}, {33, -20, 12, -0.4F}}},
      {"philtrum", Front, {{0, -50, 4.6F, -0.4F}, {0, -57.0F, 5.2F, -0.75F}}},
      {"column of the philtrum", Front, {{4.4F, -50, 4.2F, 0.2F}, {5.8F, -58.3F, 4.6F, 0.5F}}},
      {"mental crease", Front, {{0, -86, 8, -1.1F}, {12, -85, 8, -0.9F}, {20, -81, 7, -0.4F}}},
      {"corner of the mouth", Front, {{25.2F, -69.0F, 6.5F, -1.2F}}},
      {"beyond the corner", Front, {{27.2F, -71.0F, 8.0F, -0.3F}, {29, -77, 9.0F, -0.15F}}},
      {"roll beside the corner", Front, {{32.5F, -63, 11, 0.3F}, {35, -69, 12, 0.5F}, {34.5F, -76, 11, 0.2F}}},
      {"beside the corner", Front, {{35, -68, 12, 0.5F}}},
      roundEye("upper lid crease", 2.6F,
               {{-12, 3.6F, -0.5F},
                {-7, 7.4F, -1.2F},
                {0, 9.2F, -1.5F},
                {7, 8.2F, -1.5F},
                {12.5F, 5, -1.3F},
                {17, 1.2F, -0.5F}}),
      roundEye(
          "fold over the upper lid", 5.5F,
          {{-15, 8.5F, 0.1F}, {-8, 11.5F, 0.5F}, {0, 13.5F, 0.8F}, {8, 12, 1.2F}, {14, 8.2F, 0.9F}, {20, 3, 0.1F}}),
      roundEye("lower lid crease", 3.0F,
               {{-12, -5.5F, -0.4F}, {-5, -9.6F, -0.7F}, {3, -10.6F, -0.6F}, {10, -8.2F, -0.3F}}),
  };
}

}  // namespace dermis::sculpt
