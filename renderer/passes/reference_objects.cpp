#include "passes/reference_objects.h"

#include <algorithm>
#include <cmath>

namespace dermis {
namespace {

constexpr int kColumns = 6, kRows = 4;
/// Share of a cell that is patch; the rest is the chart's black frame.
constexpr float kPatchShare = 0.86F;

struct Lab {
  double l, a, b;
};
// X-Rite, "New color specifications for ColorChecker SG and Classic charts" (2014): row by row, dark skin to black.
constexpr std::array<Lab, 24> kPublished = {
    {{37.54, 14.37, 14.92},  {64.66, 19.27, 17.50},   {49.32, -3.82, -22.54}, {43.46, -12.74, 22.72},
     {54.94, 9.61, -24.79},  {70.48, -32.26, -0.37},  {62.73, 35.83, 56.50},  {39.43, 10.75, -45.17},
     {50.57, 48.64, 16.67},  {30.10, 22.54, -20.87},  {71.77, -24.13, 58.19}, {71.51, 18.24, 67.37},
     {28.37, 15.42, -49.80}, {54.38, -39.72, 32.27},  {42.43, 51.05, 28.62},  {81.80, 2.67, 80.41},
     {50.63, 51.28, -14.12}, {49.57, -29.71, -28.32}, {95.19, -1.03, 2.93},   {81.29, -0.57, 0.44},
     {66.89, -0.75, -0.06},  {50.76, -0.13, 0.14},    {35.63, -0.46, -0.48},  {20.64, 0.07, -0.46}}};

/// CIE 15:2004, section 8.2.1, backwards; then Bradford's adaptation from D50 to D65 and the primaries of Rec.709, as
/// one matrix (Lindbloom, "RGB/XYZ matrices", sRGB with reference white D50).
glm::vec3 linearRec709(const Lab& lab) {
  const auto inverse = [](double f) {
    constexpr double kDelta = 6.0 / 29.0;
    return f > kDelta ? f * f * f : 3.0 * kDelta * kDelta * (f - 4.0 / 29.0);
  };
  const double fy = (lab.l + 16.0) / 116.0;
  const glm::dvec3 xyz(0.96422 * inverse(fy + lab.a / 500.0), inverse(fy), 0.82521 * inverse(fy - lab.b / 200.0));
  const glm::dvec3 rgb(3.1338561 * xyz.x - 1.6168667 * xyz.y - 0.4906146 * xyz.z,
                       -0.9787684 * xyz.x + 1.9161415 * xyz.y + 0.0334540 * xyz.z,
                       0.0719453 * xyz.x - 0.2289914 * xyz.y + 1.4052427 * xyz.z);
  return glm::max(glm::vec3(rgb), glm::vec3(0.0F));
}

}  // namespace

glm::vec2 ReferenceLayout::patch(int index) const {
  const auto column = static_cast<float>(index % kColumns);
  const int line = index / kColumns;
  const auto row = static_cast<float>(kRows - 1 - line);
  return chart + cell * (glm::vec2(column, row) + 0.5F);
}

ReferenceLayout referenceLayout(const ReferenceObjects& objects, glm::ivec2 size) {
  const auto shorter = static_cast<float>(std::min(size.x, size.y));
  ReferenceLayout layout;
  layout.radius = 0.055F * shorter;
  layout.cell = 0.033F * shorter;
  const float edge = 0.02F * shorter;
  const float bottom = 0.075F * shorter;
  layout.grey = {edge + layout.radius, bottom + layout.radius};
  layout.chrome = layout.grey + glm::vec2(2.2F * layout.radius, 0.0F);
  layout.chart = {edge, bottom + (objects.balls ? 2.35F * layout.radius : 0.0F)};
  return layout;
}

const std::array<glm::vec3, 24>& chartPatches() {
  static const std::array<glm::vec3, 24> kPatches = [] {
    std::array<glm::vec3, 24> patches{};
    for (std::size_t i = 0; i < patches.size(); ++i) patches.at(i) = linearRec709(kPublished.at(i));
    return patches;
  }();
  return kPatches;
}

gl::ProgramSources referenceProgram() {
  gl::ProgramSources sources;
  sources.vertex = "full_screen.vert";
  sources.fragment = "references.frag";
  return sources;
}

void referencePass(const FrameContext& frame, glm::vec2 jitter) {
  const ReferenceObjects& objects = frame.request.references;
  const ReferenceLayout layout = referenceLayout(objects, frame.request.size);
  const gl::Program* program = frame.useProgram(referenceProgram());
  if (program == nullptr) return;
  const glm::vec3 place = frame.resources.bounds().centre();
  const float ball = objects.balls ? layout.radius : 0.0F;
  glUniform3f(program->uniform("u_place"), place.x, place.y, place.z);
  glUniform3f(program->uniform("u_grey"), layout.grey.x, layout.grey.y, ball);
  glUniform3f(program->uniform("u_chrome"), layout.chrome.x, layout.chrome.y, ball);
  glUniform4f(program->uniform("u_chart"), layout.chart.x, layout.chart.y, objects.chart ? layout.cell : 0.0F,
              kPatchShare);
  glUniform3fv(program->uniform("u_patches"), static_cast<GLsizei>(chartPatches().size()), &chartPatches()[0][0]);
  glUniform1f(program->uniform("u_grey_albedo"), kGreyBallAlbedo);
  glUniform2f(program->uniform("u_jitter"), jitter.x, jitter.y);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  glEnable(GL_SCISSOR_TEST);
  const glm::vec2 end(std::max(layout.chrome.x + layout.radius, layout.chart.x + kColumns * layout.cell),
                      std::max(layout.chrome.y + layout.radius, layout.chart.y + kRows * layout.cell));
  glScissor(0, 0, static_cast<GLsizei>(end.x) + 2, static_cast<GLsizei>(end.y) + 2);
  gl::drawFullScreen();
  glDisable(GL_SCISSOR_TEST);
  glEnable(GL_DEPTH_TEST);
}

}  // namespace dermis
