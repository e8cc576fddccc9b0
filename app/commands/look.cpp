#include "app/commands/look.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <set>

#include "core/base/file_reference.h"
#include "core/base/lower_case.h"
#include "core/base/number_format.h"
#include "core/builtin/default_look.h"
#include "core/builtin/environments.h"
#include "core/io/asset_loader.h"
#include "core/io/udim.h"
#include "core/material/parameter_table.h"
#include "core/material/preset_io.h"
#include "core/material/value_json.h"
#include "core/scene/cameras.h"
#include "core/scene/scene_io.h"
#include "renderer.h"

namespace dermis::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kConstant = "constant:";

std::string absolute(const std::string& path) { return absoluteReference(path, fs::current_path()); }

template <class Rows>
std::string names(const Rows& rows) {
  std::vector<std::string> list;
  for (const auto& row : rows) list.emplace_back(row.id);
  return listed(list);
}

Outcome<void> setModel(const std::string& text, Scene& scene) {
  scene.model = ModelSource{};
  const auto name = builtinName(text);
  if (!name) {
    scene.model.path = absolute(text);
    scene.model.builtin.clear();
    return {};
  }
  scene.model.builtin = *name;
  const auto known = builtinModels();
  if (std::find(known.begin(), known.end(), scene.model.builtin) == known.end())
    return wrongUsage(
        fmt::format("--model: there is no built-in model \"{}\"; choose {}", scene.model.builtin, listed(known)));
  return {};
}

/// Keeps rotation, exposure and background: what changes is where the light comes from.
Outcome<void> setEnvironment(const std::string& text, EnvironmentSource& environment) {
  EnvironmentSource next;
  next.rotationDegrees = environment.rotationDegrees;
  next.exposureStops = environment.exposureStops;
  next.background = environment.background;
  next.builtin.clear();
  if (text.starts_with(kConstant)) {
    const auto numbers = parseFloatList(std::string_view(text).substr(kConstant.size()));
    if (!numbers || (numbers->size() != 3 && numbers->size() != 1))
      return wrongUsage(fmt::format("--environment: \"{}\" is not constant:r,g,b with three numbers", text));
    const auto at = [&](std::size_t i) { return numbers->at(numbers->size() == 1 ? 0 : i); };
    next.constant = glm::vec3(at(0), at(1), at(2));
  } else if (const auto name = builtinName(text)) {
    next.builtin = *name;
    const auto rows = builtinEnvironments();
    if (std::none_of(rows.begin(), rows.end(), [&](const auto& row) { return row.id == next.builtin; }))
      return wrongUsage(
          fmt::format("--environment: there is no built-in environment \"{}\"; choose {}", next.builtin, names(rows)));
  } else {
    next.path = absolute(text);
  }
  environment = next;
  return {};
}

/// "[SLOT=]PRESET": without a slot the preset goes on every one.
Outcome<void> addMaterial(const std::string& text, Scene& scene, std::set<std::string>& slotsNamed,
                          Warnings& warnings) {
  std::string slot;
  std::string path = text;
  std::error_code error;
  if (const std::size_t equals = text.find('='); equals != std::string::npos && !fs::exists(text, error)) {
    slot = text.substr(0, equals);
    path = text.substr(equals + 1);
  }
  if (path.empty()) return wrongUsage(fmt::format("--material: \"{}\" names no preset", text));
  Result<Material> material = loadPreset(absolute(path), warnings);
  if (!material) return failure(material.error());
  MaterialBinding binding;
  binding.material = std::move(*material);
  binding.presetPath = absolute(path);
  if (slot.empty()) {
    scene.materials.clear();
    scene.materials["*"] = std::move(binding);
  } else {
    if (slot != "*") slotsNamed.insert(slot);
    scene.materials[slot] = std::move(binding);
  }
  return {};
}

/// One --set, its id and value checked before anything is loaded.
struct Assignment {
  std::string text, slot;
  const ParameterRow* row = nullptr;
  ParameterValue value;
};

Outcome<Assignment> parseAssignment(const std::string& text, Warnings& warnings) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0)
    return wrongUsage(
        fmt::format("--set: \"{}\" is not [SLOT/]ID=VALUE, such as specular.perceptual_roughness=0.3", text));
  const std::string left = text.substr(0, equals);
  const std::size_t slash = left.rfind('/');
  Assignment assignment;
  assignment.text = text;
  if (slash != std::string::npos) assignment.slot = left.substr(0, slash);
  const std::string id = slash == std::string::npos ? left : left.substr(slash + 1);
  assignment.row = findParameter(id);
  if (assignment.row == nullptr)
    return wrongUsage(fmt::format("--set: there is no parameter \"{}\"; dermis parameters lists them", id));
  const Result<ParameterValue> value = parseParameterText(*assignment.row, std::string_view(text).substr(equals + 1));
  if (!value) return wrongUsage("--set: " + value.error().message);
  assignment.value = clampWithWarning(*assignment.row, *value, "--set " + id, warnings);
  return assignment;
}

/// Writes the value into the slots it is for, in the resolved materials and in the scene that goes into the metadata.
Outcome<void> apply(const Assignment& assignment, ResolvedScene& resolved) {
  bool found = false;
  for (std::size_t i = 0; i < resolved.slots.size(); ++i) {
    const std::string& name = resolved.model->slots[i].name;
    if (!assignment.slot.empty() && assignment.slot != "*" && assignment.slot != name) continue;
    Material& material = resolved.slots[i].material;
    if (!assignment.row->usedBy(material.model)) {
      if (assignment.slot == name)
        return wrongUsage(fmt::format("--set: the shading model of slot {}, {}, has no parameter {}", name,
                                      shadingModelRow(material.model).id, assignment.row->id));
      continue;
    }
    found = true;
    setParameter(material.parameters, *assignment.row, assignment.value);
    const MaterialBinding* bound = resolved.scene.bindingFor(name);
    MaterialBinding binding = bound != nullptr ? *bound : MaterialBinding{};
    binding.material = material;
    binding.edited = true;
    resolved.scene.materials[name] = std::move(binding);
  }
  if (found) return {};
  if (assignment.slot.empty() || assignment.slot == "*")
    return wrongUsage(
        fmt::format("--set: no slot of this model wears a shading model with the parameter {}", assignment.row->id));
  std::vector<std::string> slots;
  for (const ModelSlot& slot : resolved.model->slots) slots.push_back(slot.name);
  return wrongUsage(fmt::format("--set: the model has no slot \"{}\"; it has {}", assignment.slot, listed(slots)));
}

Outcome<void> checkSlots(const std::set<std::string>& named, const Model& model) {
  for (const std::string& slot : named)
    if (std::none_of(model.slots.begin(), model.slots.end(), [&](const ModelSlot& s) { return s.name == slot; })) {
      std::vector<std::string> slots;
      for (const ModelSlot& s : model.slots) slots.push_back(s.name);
      return wrongUsage(fmt::format("--material: the model has no slot \"{}\"; it has {}", slot, listed(slots)));
    }
  return {};
}

Outcome<std::string> findView(const std::string& wanted) {
  if (lowerCase(wanted) == "raw") return std::string("Raw");
  const Result<DisplayViews> views = displayViews();
  if (!views) return failure(views.error());
  for (const std::string& view : views->views)
    if (lowerCase(view) == lowerCase(wanted)) return view;
  return wrongUsage(fmt::format("--view: there is no view \"{}\"; choose {}", wanted, listed(views->views)));
}

Outcome<Camera> parseCamera(const std::string& text, const ResolvedScene& resolved) {
  if (text.find_first_not_of(" \t\n") != std::string::npos && text[text.find_first_not_of(" \t\n")] == '{') {
    const Result<Json> json = parseJson(text, "--camera");
    if (!json) return wrongUsage(json.error().message);
    const Result<Camera> camera = cameraFromJson(*json, "", resolved.camera);
    if (!camera) return wrongUsage("--camera: " + camera.error().message);
    return *camera;
  }
  if (const auto camera = namedCamera(text, resolved.model->bounds)) return *camera;
  return wrongUsage(
      fmt::format("--camera: there is no camera \"{}\"; choose {}, or give JSON", text, names(namedCameras())));
}

void addInput(std::vector<fs::path>& inputs, const std::string& path) {
  if (path.empty() || namesNoFile(path)) return;
  if (std::find(inputs.begin(), inputs.end(), path) == inputs.end()) inputs.emplace_back(path);
}

std::vector<fs::path> collectInputs(const ResolvedScene& resolved, const std::string& sceneFile) {
  std::vector<fs::path> inputs;
  addInput(inputs, sceneFile);
  addInput(inputs, resolved.scene.model.path);
  for (const ModelFilePart& part : resolved.scene.model.parts) addInput(inputs, part.path);
  addInput(inputs, resolved.scene.environment.path);
  for (const std::string& face : resolved.scene.environment.faces) addInput(inputs, face);
  for (const auto& [slot, binding] : resolved.scene.materials) addInput(inputs, binding.presetPath);
  for (const ResolvedMaterial& slot : resolved.slots)
    for (const TextureBinding& texture : slot.material.textures) {
      const std::vector<UdimTile> tiles = udimTiles(texture.path);
      if (tiles.empty()) addInput(inputs, texture.path);
      for (const UdimTile& tile : tiles) addInput(inputs, tile.file.string());
    }
  return inputs;
}

}  // namespace

void addLookOptions(CLI::App& command, LookOptions& options) {
  command.add_option("SCENE", options.scene, "A scene file (.dermis); without one, the embedded look");
  command
      .add_option("--model", options.model,
                  "Model file, or builtin:head, builtin:default, builtin:sphere, builtin:plane")
      ->type_name("MODEL");
  command
      .add_option("--material", options.materials,
                  "Preset for a slot, or without SLOT= for every slot: a file or builtin:NAME; repeatable")
      ->type_name("[SLOT=]PRESET")
      ->allow_extra_args(false);
  command
      .add_option("--environment", options.environment,
                  "Lat-long image, or builtin:studio, builtin:overcast, builtin:rim, or constant:r,g,b")
      ->type_name("ENVIRONMENT");
  command
      .add_option("--set", options.values,
                  "A parameter (see `dermis parameters`): number, list a,b,c, word, true, false or null; repeatable")
      ->type_name("[SLOT/]ID=VALUE")
      ->allow_extra_args(false);
  command
      .add_option(
          "--camera", options.camera,
          "front, three-quarter, profile, ear, top-right, top-left, bottom-right, bottom-left, or JSON as in a scene")
      ->type_name("NAME|JSON");
  command
      .add_option("--view", options.view,
                  "View transform, e.g. ACES, sRGB, Thesis, \"Gamma 2.2\", raw (values as they are)")
      ->type_name("NAME");
}

Outcome<Look> resolveLook(const LookOptions& options, ProgressLine& progress, Warnings& warnings) {
  // 1. What the command line says by itself is checked before any file is opened.
  std::vector<Assignment> assignments;
  for (const std::string& text : options.values) {
    Outcome<Assignment> assignment = parseAssignment(text, warnings);
    if (!assignment) return tl::unexpected(assignment.error());
    assignments.push_back(std::move(*assignment));
  }
  Look look;
  std::string view;
  if (!options.view.empty()) {
    const Outcome<std::string> found = findView(options.view);
    if (!found) return tl::unexpected(found.error());
    view = *found;
    look.viewGiven = true;
  }

  // A colour configuration that cannot be read spoils every picture: say so before the work.
  if (const char* config = std::getenv("OCIO"); config != nullptr && *config != '\0')
    if (const Result<DisplayViews> views = displayViews(); !views) return failure(views.error());

  // 2. The scene: a file, or the embedded look, or a bare model under the built-in studio.
  Scene scene = defaultLook();
  std::string sceneFile;
  if (!options.scene.empty()) {
    sceneFile = absolute(options.scene);
    Result<Scene> loaded = loadScene(options.scene, warnings);
    if (!loaded) return failure(loaded.error());
    scene = std::move(*loaded);
    look.folder = fs::path(sceneFile).parent_path();
  } else if (!options.model.empty()) {
    scene = Scene{};
  }
  if (!options.model.empty())
    if (const auto done = setModel(options.model, scene); !done) return tl::unexpected(done.error());
  if (!options.environment.empty())
    if (const auto done = setEnvironment(options.environment, scene.environment); !done)
      return tl::unexpected(done.error());
  std::set<std::string> slotsNamed;
  for (const std::string& text : options.materials)
    if (const auto done = addMaterial(text, scene, slotsNamed, warnings); !done) return tl::unexpected(done.error());

  // 3. Everything it points to.
  ResolveOptions resolve;
  resolve.importedMaterials = options.scene.empty();
  resolve.progress = [&](std::string_view what, double fraction) { progress.show(what, fraction); };
  Result<ResolvedScene> resolved = resolveScene(scene, fs::current_path(), resolve, warnings);
  progress.clear();
  if (!resolved) return failure(resolved.error());
  if (const auto done = checkSlots(slotsNamed, *resolved->model); !done) return tl::unexpected(done.error());

  // 4. What needs to know the model: parameters of its slots, cameras round its bounds.
  for (const Assignment& assignment : assignments)
    if (const auto done = apply(assignment, *resolved); !done) return tl::unexpected(done.error());
  if (!options.camera.empty()) {
    const Outcome<Camera> camera = parseCamera(options.camera, *resolved);
    if (!camera) return tl::unexpected(camera.error());
    resolved->camera = *camera;
  }
  resolved->scene.camera = resolved->camera;
  if (look.viewGiven) {
    resolved->scene.view.transform = view;
  } else if (options.scene.empty()) {
    takeViewOfShaders(*resolved);
  }
  look.inputs = collectInputs(*resolved, sceneFile);
  look.resolved = std::move(*resolved);
  return look;
}

void takeViewOfShaders(ResolvedScene& resolved) {
  if (std::all_of(resolved.slots.begin(), resolved.slots.end(),
                  [](const ResolvedMaterial& slot) { return shadingModelRow(slot.material.model).displayReferred; }))
    resolved.scene.view.transform = "Raw";
}

Outcome<std::shared_ptr<const Model>> readModel(const std::string& reference) {
  ModelSource source;
  source.builtin.clear();
  if (const auto name = builtinName(reference))
    source.builtin = *name;
  else
    source.path = reference;
  Warnings warnings;
  auto model = resolveModel(source, std::filesystem::current_path(), {}, warnings);
  printWarnings(warnings);
  if (!model) return failure(model.error());
  return std::move(*model);
}

}  // namespace dermis::cli
