// dermis render: one still.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "app/commands/commands.h"
#include "app/commands/picture.h"
#include "colour/false_colour.h"
#include "core/base/json_fields.h"
#include "core/base/lower_case.h"

namespace dermis::cli {
namespace {

struct RenderOptions {
  LookOptions look;
  std::string size = "1280x720";
  int samples = 64;
  ReferenceObjects references;
  std::vector<std::string> aovs;
  std::string output;
  bool noMetadata = false;
  bool glInfo = false;
};

void printGlInfo(const GlInfo& info) {
  fmt::print("platform  {}\nvendor    {}\nrenderer  {}\nversion   {}\nsoftware  {}\n", info.platform, info.vendor,
             info.renderer, info.version, info.software ? "yes" : "no");
}

std::vector<std::string> aovNames() {
  std::vector<std::string> names;
  for (const Aov aov : allAovs()) names.emplace_back(toString(aov));
  return names;
}

Outcome<Aov> aovNamed(const std::string& name) {
  for (const Aov aov : allAovs())
    if (lowerCase(name) == toString(aov)) return aov;
  return wrongUsage(fmt::format("--aov: there is no AOV \"{}\"; choose {}", name, listed(aovNames())));
}

Outcome<int> render(const RenderOptions& options) {
  // Everything that the command line alone can get wrong comes first, then the folder, then files, then the GPU.
  PictureRequest request;
  const Outcome<glm::ivec2> size = parseSize(options.size);
  if (!size) return tl::unexpected(size.error());
  request.size = *size;
  request.samples = options.samples;
  request.references = options.references;
  request.metadata = !options.noMetadata;
  for (const std::string& name : options.aovs) {
    const Outcome<Aov> aov = aovNamed(name);
    if (!aov) return tl::unexpected(aov.error());
    if (std::find(request.aovs.begin(), request.aovs.end(), *aov) == request.aovs.end()) request.aovs.push_back(*aov);
  }
  if (options.output.empty() && !options.glInfo)
    return wrongUsage("render needs -o and the name of a picture to write");
  if (!options.output.empty()) {
    request.output = options.output;
    if (const auto fine = checkOutputFile(request.output, kPictureExtensions); !fine)
      return tl::unexpected(fine.error());
    for (const Aov aov : request.aovs)
      if (extensionOf(request.output) != ".exr" && aov != Aov::Beauty)
        if (const auto fine = checkOutputFile(aovFile(request.output, toString(aov)), kPictureExtensions); !fine)
          return tl::unexpected(fine.error());
  }

  ProgressLine progress;
  Warnings warnings;
  if (options.output.empty()) {
    const auto headless = HeadlessRenderer::create();
    if (!headless) return tl::unexpected(headless.error());
    printGlInfo((*headless)->glInfo());
    return kDone;
  }
  const Outcome<Look> look = resolveLook(options.look, progress, warnings);
  printWarnings(warnings);
  if (!look) return tl::unexpected(look.error());
  if (extensionOf(request.output) == ".exr" && !look->viewGiven && look->resolved.scene.view.transform != "Raw")
    fmt::print(
        stderr,
        "warning: {} will hold values encoded for the display by the view {}; --view raw writes scene-linear ones\n",
        options.output, look->resolved.scene.view.transform);

  const auto headless = HeadlessRenderer::create();
  if (!headless) return tl::unexpected(headless.error());
  Renderer& renderer = **headless;
  if (options.glInfo) printGlInfo(renderer.glInfo());
  auto layers = renderLayers(renderer, *look, request, progress);
  warnings = renderer.takeMessages();
  printWarnings(warnings);
  if (!layers) return tl::unexpected(layers.error());
  const auto written = writePicture(renderer, *look, request, std::move(*layers));
  if (!written) return tl::unexpected(written.error());
  // What the colours of a picture of numbers mean: no picture here has a legend.
  if (extensionOf(request.output) != ".exr")
    for (const Aov aov : request.aovs)
      if (const auto range = valueRange(aov, look->resolved, look->resolved.camera)) {
        const float unit = range->inMillimetres > 0.0F ? range->inMillimetres : 1.0F;
        fmt::print("{}: {:g} to {:g}{}\n", aovFile(request.output, toString(aov)).string(), range->low * unit,
                   range->high * unit, range->inMillimetres > 0.0F ? " mm" : "");
      }
  return kDone;
}

}  // namespace

void addRender(CLI::App& root, Action& action) {
  auto options = std::make_shared<RenderOptions>();
  CLI::App* command = root.add_subcommand("render", "Render one still: PNG, JPEG, TIFF or EXR");
  addLookOptions(*command, options->look);
  command->add_option("--size", options->size, "Pixels, 1280x720 by default")->type_name("WxH");
  command->add_option("--samples", options->samples, "Samples a pixel, 64 by default; 1 shades at the pixel's centre")
      ->type_name("N")
      ->check(CLI::Range(1, 1 << 20));
  command
      ->add_option(
          "--aov", options->aovs,
          fmt::format("An image of the frame besides: {}; a layer of an EXR, a file of its own beside any other "
                      "picture; repeatable",
                      listed(aovNames())))
      ->type_name("NAME")
      ->allow_extra_args(false);
  command->add_option("-o,--output", options->output, "The picture to write; its ending chooses the format")
      ->type_name("OUT");
  command->add_flag("--balls", options->references.balls, "A grey and a chrome ball in the corner, lit by the scene");
  command->add_flag("--chart", options->references.chart, "A colour chart in the corner, lit by the scene");
  command->add_flag("--no-metadata", options->noMetadata,
                    "Leave scene, inputs, version and GL renderer out of the file");
  command->add_flag("--gl-info", options->glInfo, "Say which OpenGL draws; enough by itself");
  command->footer(R"(
Examples:
  dermis render -o look.png
  dermis render face.dermis --size 1920x1080 --samples 256 -o face.png
  dermis render --model head.glb --environment studio.hdr --camera three-quarter -o head.png
  dermis render --model head.glb --material builtin:skin_tone_iii --set specular.perceptual_roughness=0.35 -o skin.png
  dermis render face.dermis --set face/subsurface.radius_mm=4,1.5,0.7 --view raw --aov normal -o face.exr
  dermis render face.dermis --aov thickness --aov energy -o face.png     also face.thickness.png, face.energy.png

Without SCENE and MODEL the embedded look is drawn. PNG, JPEG and TIFF go through the view; EXR with
--view raw holds scene-linear Rec.709, alpha multiplied in. Layers of an EXR are the numbers themselves: thickness in
millimetres, depth in scene units. Beside other formats an AOV is drawn as the editor shows it, numbers as colours.
No display is needed.)");
  command->callback([options, &action] { action = [options] { return render(*options); }; });
}

}  // namespace dermis::cli
