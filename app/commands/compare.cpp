// dermis compare: how far apart two pictures are.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cmath>

#include "app/commands/commands.h"
#include "core/base/json_text.h"
#include "core/image/comparison.h"
#include "core/io/importer.h"
#include "core/io/png_writer.h"

namespace dermis::cli {
namespace {

constexpr std::array<std::string_view, 1> kHeatMapExtensions = {".png"};

struct CompareOptions {
  std::string a, b, heatMap;
  double tolerance = -1.0;
  bool json = false;
};

Outcome<int> compare(const CompareOptions& options) {
  if (!options.heatMap.empty())
    if (const auto fine = checkOutputFile(options.heatMap, kHeatMapExtensions); !fine)
      return tl::unexpected(fine.error());
  const Result<const Importer*> module = importer();
  if (!module) return failure(module.error());
  Warnings warnings;
  const Result<Image> a = (*module)->loadImage(options.a, {}, warnings);
  const Result<Image> b = a ? (*module)->loadImage(options.b, {}, warnings) : a;
  printWarnings(warnings);
  if (!b) return failure(b.error());
  const bool judged = options.tolerance >= 0.0;
  const Result<Comparison> result = compareImages(*a, *b, judged ? options.tolerance : 0.0);
  if (!result) return failure(result.error());

  if (options.json) {
    Json json;
    json["mean"] = result->mean;
    json["maximum"] = std::isfinite(result->maximum) ? Json(result->maximum) : Json(nullptr);
    json["failing_share"] = result->failing;
    json["flip"] = result->flip;
    if (judged) json["tolerance"] = options.tolerance;
    fmt::print("{}\n", json.dump(2));
  } else {
    fmt::print("mean     {:.6g}\nmaximum  {:.6g}\nfailing  {:.4f} % of the pixels {}\nFLIP     {:.6g}\n", result->mean,
               result->maximum, 100.0 * result->failing,
               judged ? fmt::format("past {:g}", options.tolerance) : "differ", result->flip);
  }
  if (!options.heatMap.empty()) {
    const Result<void> written = writePng(options.heatMap, heatMap(result->flipMap, result->width, result->height), {});
    if (!written) return failure(written.error());
  }
  return judged && result->maximum > options.tolerance ? kDifferent : kDone;
}

}  // namespace

void addCompare(CLI::App& root, Action& action) {
  auto options = std::make_shared<CompareOptions>();
  CLI::App* command =
      root.add_subcommand("compare", "Compare two images of one size: mean, largest, failing share, FLIP");
  command->add_option("A", options->a, "An image")->required();
  command->add_option("B", options->b, "Another one")->required();
  command->add_option("--tolerance", options->tolerance, "Largest channel difference allowed; exit code 4 past it")
      ->type_name("T")
      ->check(CLI::NonNegativeNumber);
  command->add_option("-o,--output", options->heatMap, "Heat map of FLIP, a PNG")->type_name("HEAT.png");
  command->add_flag("--json", options->json, "As JSON");
  command->footer(R"(
Examples:
  dermis compare before.png after.png -o where.png
  dermis compare reference.exr new.exr --tolerance 0.002

Values are compared as stored: 8 and 16 bits as 0..1, floats as they are. FLIP (Andersson et al. 2020) looks
at them as pictures on a screen, 67 pixels a degree; floats are clamped and encoded as sRGB for it.)");
  command->callback([options, &action] { action = [options] { return compare(*options); }; });
}

}  // namespace dermis::cli
