#include "passes/display_pass.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dermis {

namespace {

constexpr GLuint kImageUnit = 0;
constexpr GLuint kFirstViewUnit = 1;  // of the LUT, or of an exact program's textures

/// The program of full_screen.vert and a fragment shader without variants, in use; null with a message.
const gl::Program* useFullScreen(gl::ShaderLibrary& shaders, MessageLog& messages, const char* fragment) {
  gl::ProgramSources sources;
  sources.vertex = "full_screen.vert";
  sources.fragment = fragment;
  auto found = shaders.program(sources);
  if (!found) {
    messages.say(found.error().message);
    return nullptr;
  }
  (*found)->use();
  return *found;
}

/// With nothing but the program between the image and the framebuffer that is bound.
void drawInto(glm::ivec2 size, const PixelArea& shown) {
  glViewport(0, 0, size.x, size.y);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  glEnable(GL_SCISSOR_TEST);
  glScissor(shown.lower.x, shown.lower.y, std::max(shown.upper.x - shown.lower.x, 0),
            std::max(shown.upper.y - shown.lower.y, 0));
  gl::drawFullScreen();
  glDisable(GL_SCISSOR_TEST);
}

}  // namespace

DisplayPass::View* DisplayPass::viewFor(const ViewSettings& settings, MessageLog& messages) {
  const auto key = std::pair(settings.display, settings.transform);
  if (const auto it = m_views.find(key); it != m_views.end()) return it->second.transform ? &it->second : nullptr;
  Warnings warnings;
  auto made = DisplayTransform::create(settings.display, settings.transform, warnings);
  for (const std::string& warning : warnings) messages.say(warning);
  View& view = m_views[key];  // a view that fails is remembered too: it is not tried every frame
  if (!made) {
    messages.say(made.error().message);
    return nullptr;
  }
  view.transform = *made;
  ++m_built;
  return &view;
}

void DisplayPass::prepareExact(View& view) {
  if (view.exactReady) return;
  for (const DisplayTexture& source : view.transform->exactProgram().textures) {
    const GLenum target = source.dimensions == 3   ? GL_TEXTURE_3D
                          : source.dimensions == 2 ? GL_TEXTURE_2D
                                                   : GL_TEXTURE_1D;
    gl::Texture texture = gl::Texture::create({.target = target,
                                               .format = source.channels == 1 ? GLenum{GL_R32F} : GLenum{GL_RGB32F},
                                               .width = source.width,
                                               .height = source.height,
                                               .depth = source.depth,
                                               .label = source.samplerName});
    const GLenum format = source.channels == 1 ? GL_RED : GL_RGB;
    if (source.dimensions == 3)
      texture.uploadAll(0, format, GL_FLOAT, source.values.data());
    else
      texture.upload(0, format, GL_FLOAT, source.values.data());
    if (source.nearest) texture.setFilter(GL_NEAREST, GL_NEAREST);
    view.textures.push_back(std::move(texture));
  }
  view.exactReady = true;
}

void DisplayPass::prepareLut(View& view) {
  if (view.lut) return;
  const DisplayLut& lut = view.transform->lut();
  view.lut = gl::Texture::create({.target = GL_TEXTURE_3D,
                                  .format = GL_RGBA16F,
                                  .width = lut.edge,
                                  .height = lut.edge,
                                  .depth = lut.edge,
                                  .label = "display LUT"});
  view.lut.uploadAll(0, GL_RGB, GL_FLOAT, lut.rgb.data());
}

bool DisplayPass::draw(gl::ShaderLibrary& shaders, MessageLog& messages, const ViewSettings& settings,
                       const DisplayInput& input) {
  View* view = viewFor(settings, messages);
  if (view == nullptr) return false;
  const glm::ivec2 size(input.image->width(), input.image->height());
  glViewport(0, 0, size.x, size.y);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  const PixelArea whole{glm::ivec2(0), size};
  if (!input.edgeFilter) return drawAreas(shaders, messages, *view, settings, input, false, {&whole, 1});

  // Only the model has edges: what surrounds its rectangle is shown as it is.
  const PixelArea& inside = *input.edgeFilter;
  const glm::ivec2 lower = inside.lower, upper = inside.upper;
  const std::array<PixelArea, 4> around = {PixelArea{{0, 0}, {size.x, lower.y}}, PixelArea{{0, upper.y}, size},
                                           PixelArea{{0, lower.y}, {lower.x, upper.y}},
                                           PixelArea{{upper.x, lower.y}, {size.x, upper.y}}};
  return drawAreas(shaders, messages, *view, settings, input, true, {&inside, 1}) &&
         drawAreas(shaders, messages, *view, settings, input, false, around);
}

bool DisplayPass::drawAreas(gl::ShaderLibrary& shaders, MessageLog& messages, View& view, const ViewSettings& settings,
                            const DisplayInput& input, bool edgeFilter, std::span<const PixelArea> areas) {
  const bool exact = input.exact || view.transform->isSimple();

  gl::ProgramSources sources;
  sources.vertex = "full_screen.vert";
  sources.fragment = "display.frag";
  if (exact) {
    sources.defines.emplace_back("DERMIS_EXACT");
    sources.generated["generated/display.glsl"] = view.transform->exactProgram().glsl;
    prepareExact(view);
  } else {
    sources.generated["generated/display.glsl"] = displayBakedGlsl(kFirstViewUnit);
    prepareLut(view);
  }
  if (edgeFilter) sources.defines.emplace_back("DERMIS_EDGE_FILTER");
  auto found = shaders.program(sources);
  if (!found) {
    messages.say(found.error().message);
    return false;
  }
  const gl::Program& program = **found;
  program.use();
  input.image->bind(kImageUnit);
  if (exact) {
    GLuint unit = kFirstViewUnit;
    for (std::size_t i = 0; i < view.textures.size(); ++i, ++unit) {
      glUniform1i(program.uniform(view.transform->exactProgram().textures[i].samplerName), static_cast<GLint>(unit));
      view.textures[i].bind(unit);
    }
  } else {
    view.lut.bind(kFirstViewUnit);
  }
  const bool raw = view.transform->isRaw();
  glUniform1f(program.uniform("u_weight"), input.weight);
  glUniform1f(program.uniform("u_exposure"), raw ? 1.0F : std::exp2(settings.exposureStops));
  glUniform1f(program.uniform("u_dither"), input.dither && !raw ? 1.0F / 255.0F : 0.0F);
  glUniform1i(program.uniform("u_alpha_mode"), input.straightAlpha ? 1 : 0);
  glEnable(GL_SCISSOR_TEST);
  for (const PixelArea& area : areas) {
    const PixelArea shown = input.shown.value_or(area);
    const glm::ivec2 lower = glm::max(area.lower, shown.lower);
    const glm::ivec2 extent = glm::min(area.upper, shown.upper) - lower;
    if (extent.x <= 0 || extent.y <= 0) continue;
    glScissor(lower.x, lower.y, extent.x, extent.y);
    gl::drawFullScreen();
  }
  glDisable(GL_SCISSOR_TEST);
  return true;
}

void DisplayPass::drawData(gl::ShaderLibrary& shaders, MessageLog& messages, Aov aov,
                           const std::optional<ValueRange>& range, const gl::Texture& image, float weight,
                           glm::ivec2 size, const PixelArea& shown) {
  const gl::Program* program = useFullScreen(shaders, messages, "aov.frag");
  if (program == nullptr) return;
  image.bind(kImageUnit);
  const glm::vec2 scale = glm::vec2(image.width(), image.height()) / glm::vec2(size);
  const ValueRange ends = range.value_or(ValueRange{});
  glUniform1i(program->uniform("u_aov"), static_cast<int>(aov));
  glUniform1f(program->uniform("u_weight"), weight);
  glUniform2f(program->uniform("u_range"), ends.low, ends.high);
  glUniform2f(program->uniform("u_scale"), scale.x, scale.y);
  drawInto(size, shown);
}

void DisplayPass::enlarge(gl::ShaderLibrary& shaders, MessageLog& messages, const gl::Texture& encoded, glm::ivec2 size,
                          const PixelArea& shown) {
  const gl::Program* program = useFullScreen(shaders, messages, "enlarge.frag");
  if (program == nullptr) return;
  encoded.bind(kImageUnit);
  glUniform2f(program->uniform("u_scale"), 1.0F / static_cast<float>(size.x), 1.0F / static_cast<float>(size.y));
  drawInto(size, shown);
}

glm::vec3 DisplayPass::encoded(const glm::vec4& scene, const ViewSettings& settings, MessageLog& messages) {
  const View* view = viewFor(settings, messages);
  if (view == nullptr) return glm::vec3(0.0F);
  const glm::vec3 straight = scene.a > 0.0F ? glm::vec3(scene) / scene.a : glm::vec3(scene);
  glm::vec4 value(straight * (view->transform->isRaw() ? 1.0F : std::exp2(settings.exposureStops)), 1.0F);
  view->transform->apply(&value[0], 1);
  return glm::clamp(glm::vec3(value), glm::vec3(0.0F), glm::vec3(1.0F));
}

}  // namespace dermis
