#include "core/io/asset_loader.h"

#include <algorithm>
#include <atomic>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "core/base/file_reference.h"
#include "core/base/lower_case.h"
#include "core/builtin/default_look.h"
#include "core/builtin/environments.h"
#include "core/builtin/maps.h"
#include "core/io/content_hash.h"
#include "core/io/environment_image.h"
#include "core/io/importer.h"
#include "core/io/udim.h"
#include "core/light_rig/rig_io.h"
#include "core/scene/cameras.h"
#include "core/scene/primitives.h"

namespace dermis {
namespace {

namespace fs = std::filesystem;

/// A lat-long of 8192×4096 RGB floats is 400 MB; nothing finer survives the prefiltering.
constexpr int kLargestEnvironment = 8192;

/// Progress from several threads, one call at a time.
class Progress {
 public:
  Progress(const ResolveOptions& options, std::size_t steps)
      : m_options(options), m_steps(std::max<std::size_t>(steps, 1)) {}
  void done(std::string_view what) {
    if (!m_options.progress) return;
    const std::lock_guard lock(m_mutex);
    ++m_done;
    m_options.progress(what, std::min(1.0, static_cast<double>(m_done) / static_cast<double>(m_steps)));
  }
  void add(std::size_t steps) {
    const std::lock_guard lock(m_mutex);
    m_steps += steps;
  }

 private:
  const ResolveOptions& m_options;
  std::mutex m_mutex;
  std::size_t m_steps, m_done = 0;
};

template <class T>
std::shared_ptr<const T> cached(const ResolveOptions& options, const std::string& key) {
  return options.cache && !key.empty() ? options.cache->find<T>(key) : nullptr;
}
template <class T>
void remember(const ResolveOptions& options, const std::string& key, const std::shared_ptr<const T>& value) {
  if (options.cache && !key.empty()) options.cache->put(key, value);
}

void append(Warnings& warnings, const Warnings& more) { warnings.insert(warnings.end(), more.begin(), more.end()); }

/// An image to decode: a file, or one of the model's own.
struct TextureTask {
  std::string path;     ///< absolute, or `embedded:N`
  std::string purpose;  ///< "the albedo map of slot face", for messages
  bool fromModelFile = false;
  std::shared_ptr<const Image> image;
  std::optional<Error> error;
  Warnings warnings;
};

void decodeEmbedded(TextureTask& task, const std::shared_ptr<const Model>& model, const ResolveOptions& options) {
  const auto index = embeddedIndex(task.path);
  if (!index || *index >= model->embedded.size()) {
    task.error = Error{Error::Kind::Input, "the model holds no image " + task.path};
    return;
  }
  const Result<const Importer*> module = importer();
  if (!module) {
    task.error = module.error();
    return;
  }
  const EmbeddedImage& embedded = model->embedded[*index];
  // The bytes name the image, whichever file they came in.
  const std::string key =
      "embedded|" + hexadecimal(contentHash(embedded.bytes)) + "|" + std::to_string(embedded.bytes.size());
  if ((task.image = cached<Image>(options, key))) return;
  Result<Image> image = (*module)->loadImage(embedded.bytes, embedded.name, {}, task.warnings);
  if (!image) {
    task.error = image.error();
    return;
  }
  task.image = std::make_shared<const Image>(std::move(*image));
  remember(options, key, task.image);
}

void decode(TextureTask& task, const std::shared_ptr<const Model>& model, const ResolveOptions& options) {
  if (embeddedIndex(task.path)) return decodeEmbedded(task, model, options);
  Result<std::shared_ptr<const Image>> image = resolveTexture(task.path, options, task.warnings);
  if (image)
    task.image = std::move(*image);
  else
    task.error = image.error();
}

/// Runs the tasks on as many threads as the machine has cores, at most one a task.
void decodeAll(std::vector<TextureTask>& tasks, const std::shared_ptr<const Model>& model,
               const ResolveOptions& options, Progress& progress) {
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < tasks.size() && !options.stop.stop_requested(); i = next++) {
      decode(tasks[i], model, options);
      progress.done("reading " + fs::path(tasks[i].path).filename().string());
    }
  };
  const std::size_t threads = std::min<std::size_t>(tasks.size(), std::max(1U, std::thread::hardware_concurrency()));
  std::vector<std::jthread> workers;
  for (std::size_t i = 1; i < threads; ++i) workers.emplace_back(work);
  work();
}

/// What each slot wears: the scene's binding, else the file's own material or `skin` with its defaults.
std::vector<ResolvedMaterial> chooseMaterials(const Scene& scene, const Model& model, const fs::path& baseFolder,
                                              bool imported, std::vector<bool>& fromModelFile) {
  std::vector<ResolvedMaterial> slots(model.slots.size());
  fromModelFile.assign(model.slots.size(), false);
  for (std::size_t i = 0; i < slots.size(); ++i) {
    if (const MaterialBinding* binding = scene.bindingFor(model.slots[i].name)) {
      slots[i].material = binding->material;
      for (TextureBinding& texture : slots[i].material.textures)
        if (texture.present()) texture.path = absoluteReference(texture.path, baseFolder);
    } else if (imported) {
      slots[i].material = model.slots[i].imported;
      fromModelFile[i] = true;
    }
  }
  return slots;
}

}  // namespace

std::string AssetCache::fileKey(const fs::path& path) {
  std::error_code error;
  const fs::path absolute = fs::weakly_canonical(path, error);
  if (error) return {};
  const auto size = fs::file_size(absolute, error);
  if (error) return {};
  const auto time = fs::last_write_time(absolute, error);
  if (error) return {};
  return absolute.string() + "|" + std::to_string(time.time_since_epoch().count()) + "|" + std::to_string(size);
}

std::string AssetCache::mapKey(const fs::path& path) {
  const std::vector<UdimTile> tiles = udimTiles(path);
  if (tiles.empty()) return fileKey(path);
  std::string key;
  for (const UdimTile& tile : tiles) key += fileKey(tile.file) + '|';
  return key;
}

void AssetCache::put(const std::string& key, const std::shared_ptr<const void>& value) {
  const std::lock_guard lock(m_mutex);
  std::erase_if(m_entries, [](const auto& entry) { return entry.second.expired(); });
  m_entries[key] = value;
}

std::shared_ptr<const void> AssetCache::findAny(const std::string& key) const {
  const std::lock_guard lock(m_mutex);
  const auto it = m_entries.find(key);
  return it == m_entries.end() ? nullptr : it->second.lock();
}

Result<std::shared_ptr<const Image>> resolveTexture(const fs::path& path, const ResolveOptions& options,
                                                    Warnings& warnings) {
  if (const std::string name = path.string(); namesNoFile(name)) {
    const auto id = builtinMapId(name);
    if (!id) return inputError(name + " " + id.error().message + "; there are " + builtinMapNames());
    if (auto known = cached<Image>(options, name)) return known;
    auto made = builtinMap(*id);
    remember(options, name, made);
    return made;
  }
  std::string key = AssetCache::mapKey(path);
  if (!key.empty()) key = "texture|" + key;
  if (auto image = cached<Image>(options, key)) return image;
  const Result<const Importer*> module = importer();
  if (!module) return tl::unexpected(module.error());
  const bool isSet = hasUdimToken(path) || udimSetOf(path);
  Result<Image> image = isSet ? readUdimSet(path, **module, kMostUdimBytes, warnings, options.stop)
                              : (*module)->loadImage(path, {}, warnings, options.stop);
  if (!image) return tl::unexpected(image.error());
  auto shared = std::make_shared<const Image>(std::move(*image));
  remember(options, key, shared);
  return shared;
}

namespace {

Result<std::shared_ptr<const Model>> loadModelFile(const fs::path& path, const ResolveOptions& options,
                                                   Warnings& warnings) {
  std::string key = AssetCache::fileKey(path);
  if (!key.empty()) key = "model|" + key;
  if (auto model = cached<Model>(options, key)) return model;
  const Result<const Importer*> module = importer();
  if (!module) return tl::unexpected(module.error());
  Result<Model> model = (*module)->loadModel(path, options.stop);
  if (!model) return tl::unexpected(model.error());
  append(warnings, model->warnings);
  auto shared = std::make_shared<const Model>(std::move(*model));
  remember(options, key, shared);
  return shared;
}

}  // namespace

Result<std::shared_ptr<const Model>> resolveModel(const ModelSource& source, const fs::path& baseFolder,
                                                  const ResolveOptions& options, Warnings& warnings) {
  if (!source.parts.empty()) {
    Model merged;
    std::vector<std::shared_ptr<const Model>> parts;
    std::string key = "parts";
    for (const ModelFilePart& part : source.parts) {
      const fs::path path = absoluteReference(part.path, baseFolder);
      auto model = loadModelFile(path, options, warnings);
      if (!model) return model;
      parts.push_back(*model);
      key += "|" + AssetCache::fileKey(path);
      for (const glm::vec3& v : {part.translate, part.rotateDegrees, part.scale})
        for (int i = 0; i < 3; ++i) key += "," + std::to_string(v[i]);
    }
    if (auto model = cached<Model>(options, key)) return model;
    for (std::size_t i = 0; i < parts.size(); ++i)
      appendModel(merged, *parts[i], {source.parts[i].scale, source.parts[i].rotateDegrees, source.parts[i].translate});
    auto shared = std::make_shared<const Model>(std::move(merged));
    remember(options, key, shared);
    return shared;
  }
  if (!source.path.empty()) return loadModelFile(absoluteReference(source.path, baseFolder), options, warnings);
  const std::string key = "builtin model|" + source.builtin;
  if (auto model = cached<Model>(options, key)) return model;
  Result<Model> model = builtinModel(source.builtin);
  if (!model) return tl::unexpected(model.error());
  append(warnings, model->warnings);
  auto shared = std::make_shared<const Model>(std::move(*model));
  remember(options, key, shared);
  return shared;
}

namespace {

Result<std::shared_ptr<const Image>> loadRadiance(const fs::path& path, const ResolveOptions& options,
                                                  Warnings& warnings) {
  const Result<const Importer*> module = importer();
  if (!module) return tl::unexpected(module.error());
  ImageReadOptions read;
  read.maximumSize = kLargestEnvironment;
  Result<Image> image = (*module)->loadImage(path, read, warnings, options.stop);
  if (!image) return tl::unexpected(image.error());
  return std::make_shared<const Image>(toLinearRadiance(*image));
}

Result<std::shared_ptr<const EnvironmentImages>> loadLatLong(const fs::path& path, const ResolveOptions& options,
                                                             Warnings& warnings) {
  if (lowerCase(path.extension().string()) == ".json") {
    const auto rig = loadRig(path, warnings);
    if (!rig) return tl::unexpected(rig.error());
    return environmentOfRig(*rig, path.filename().string(), 0, options.stop);
  }
  auto environment = std::make_shared<EnvironmentImages>();
  auto image = loadRadiance(path, options, warnings);
  if (!image) return tl::unexpected(image.error());
  const Result<std::uint64_t> hash = contentHashOfFile(path);
  if (!hash) return tl::unexpected(hash.error());
  if ((*image)->width != 2 * (*image)->height)
    warnings.push_back(path.string() + " is " + std::to_string((*image)->width) + "×" +
                       std::to_string((*image)->height) +
                       ", not twice as wide as high; it is stretched over the sphere");
  environment->latLong = std::move(*image);
  environment->contentHash = *hash;
  environment->name = path.filename().string();
  return environment;
}

Result<std::shared_ptr<const EnvironmentImages>> loadFaces(const std::array<std::string, 6>& faces,
                                                           const fs::path& baseFolder, const ResolveOptions& options,
                                                           Warnings& warnings) {
  auto environment = std::make_shared<EnvironmentImages>();
  std::uint64_t combined = 0;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const fs::path path = absoluteReference(faces.at(i), baseFolder);
    auto image = loadRadiance(path, options, warnings);
    if (!image) return tl::unexpected(image.error());
    const Result<std::uint64_t> hash = contentHashOfFile(path);
    if (!hash) return tl::unexpected(hash.error());
    const Image& face = **image;
    if (face.width != face.height)
      return inputError(path.string() + " is " + std::to_string(face.width) + "×" + std::to_string(face.height) +
                        "; a cube face must be square");
    if (i > 0 && face.width != environment->faces[0]->width)
      return inputError(path.string() + " is " + std::to_string(face.width) + " pixels wide, but the first face is " +
                        std::to_string(environment->faces[0]->width) + "; all six faces must have one size");
    environment->faces.at(i) = std::move(*image);
    // The seed makes the order of the faces count.
    combined = contentHash(std::as_bytes(std::span(&*hash, 1)), combined);
  }
  environment->contentHash = combined;
  environment->name = fs::path(faces[0]).filename().string();
  return environment;
}

}  // namespace

Result<std::shared_ptr<const EnvironmentImages>> resolveEnvironment(const EnvironmentSource& source,
                                                                    const fs::path& baseFolder,
                                                                    const ResolveOptions& options, Warnings& warnings) {
  if (source.constant) {
    auto environment = std::make_shared<EnvironmentImages>();
    environment->constant = *source.constant;
    environment->contentHash = contentHash(std::as_bytes(std::span(&*source.constant, 1)), 1);
    environment->name = "constant";
    return environment;
  }
  if (source.rig) {
    const std::string text = writeRig(*source.rig);
    const std::string key = "rig|" + hexadecimal(contentHash(std::as_bytes(std::span(text))));
    if (auto known = cached<EnvironmentImages>(options, key)) return known;
    auto made = environmentOfRig(*source.rig, source.rig->name, 0, options.stop);
    if (made) remember(options, key, *made);
    return made;
  }
  if (source.hasFaces()) {
    std::string key = "faces";
    for (const std::string& face : source.faces) key += "|" + AssetCache::fileKey(absoluteReference(face, baseFolder));
    if (auto known = cached<EnvironmentImages>(options, key)) return known;
    auto loaded = loadFaces(source.faces, baseFolder, options, warnings);
    if (loaded) remember(options, key, *loaded);
    return loaded;
  }
  if (!source.path.empty()) {
    const fs::path path = absoluteReference(source.path, baseFolder);
    std::string key = AssetCache::fileKey(path);
    if (!key.empty()) key = "environment|" + key;
    if (auto known = cached<EnvironmentImages>(options, key)) return known;
    auto loaded = loadLatLong(path, options, warnings);
    if (loaded) remember(options, key, *loaded);
    return loaded;
  }
  const std::string key = "builtin environment|" + source.builtin;
  if (auto known = cached<EnvironmentImages>(options, key)) return known;
  auto made = builtinEnvironment(source.builtin);
  if (!made) {
    std::string names;
    for (const BuiltinEnvironmentRow& row : builtinEnvironments())
      names += (names.empty() ? "" : ", ") + std::string(row.id);
    return inputError("there is no built-in environment \"" + source.builtin + "\"; choose one of " + names);
  }
  remember(options, key, made);
  return made;
}

Result<ResolvedScene> resolveScene(const Scene& scene, const fs::path& baseFolder, const ResolveOptions& options,
                                   Warnings& warnings) {
  Progress progress(options, 2);
  ResolvedScene resolved;
  resolved.scene = scene;

  // The environment is read beside the model and its maps; what is built in takes no thread.
  std::optional<Result<std::shared_ptr<const EnvironmentImages>>> environment;
  Warnings environmentWarnings;
  const auto readEnvironment = [&] {
    environment.emplace(resolveEnvironment(scene.environment, baseFolder, options, environmentWarnings));
    progress.done("reading the environment");
  };
  const bool environmentFromFile =
      !scene.environment.constant && (scene.environment.hasFaces() || !scene.environment.path.empty());
  std::jthread environmentThread;
  if (environmentFromFile)
    environmentThread = std::jthread(readEnvironment);
  else
    readEnvironment();

  auto model = resolveModel(scene.model, baseFolder, options, warnings);
  if (!model) return tl::unexpected(model.error());
  progress.done("reading the model");
  resolved.model = *model;
  resolved.millimetresPerUnit = scene.model.millimetresPerUnit.value_or(resolved.model->millimetresPerUnit);
  resolved.camera = scene.camera.value_or(framingCamera(resolved.model->bounds));

  // Each file is decoded once, however many slots it serves.
  std::vector<bool> fromModelFile;
  // A model that is made here comes with its materials; a file's are asked for.
  const bool isBuiltin = scene.model.path.empty() && scene.model.parts.empty();
  resolved.slots =
      chooseMaterials(scene, *resolved.model, baseFolder, options.importedMaterials || isBuiltin, fromModelFile);
  std::vector<TextureTask> tasks;
  std::map<std::string, std::size_t> taskOf;
  for (std::size_t s = 0; s < resolved.slots.size(); ++s)
    for (const TextureSlotRow& row : textureSlots()) {
      const TextureBinding& binding = resolved.slots[s].material.texture(row.slot);
      if (!binding.present()) continue;
      const auto [it, added] = taskOf.try_emplace(binding.path, tasks.size());
      if (added)
        tasks.push_back({binding.path,
                         "the " + std::string(row.id) + " map of slot " + resolved.model->slots[s].name,
                         fromModelFile[s],
                         {},
                         {},
                         {}});
      else
        tasks[it->second].fromModelFile = tasks[it->second].fromModelFile && fromModelFile[s];
    }
  progress.add(tasks.size());
  decodeAll(tasks, resolved.model, options, progress);
  if (environmentThread.joinable()) environmentThread.join();
  if (options.stop.stop_requested()) return cancelledError();

  for (TextureTask& task : tasks) {
    append(warnings, task.warnings);
    if (!task.error) continue;
    if (task.error->kind == Error::Kind::Input && options.keepMissingMaps)
      warnings.push_back(task.purpose + " is missing: " + task.error->message);
    else if (task.error->kind == Error::Kind::Input && task.fromModelFile)
      warnings.push_back("left out " + task.purpose + ": " + task.error->message);
    else if (task.error->kind == Error::Kind::Input)
      return inputError(task.purpose + ": " + task.error->message);
    else
      return tl::unexpected(*task.error);
  }
  append(warnings, environmentWarnings);
  if (!*environment) return tl::unexpected(environment->error());
  resolved.environment = **environment;

  for (ResolvedMaterial& slot : resolved.slots)
    for (const TextureSlotRow& row : textureSlots()) {
      TextureBinding& binding = slot.material.texture(row.slot);
      if (!binding.present()) continue;
      std::shared_ptr<const Image> image = tasks[taskOf[binding.path]].image;
      if (image == nullptr && !options.keepMissingMaps) binding = {};
      slot.images.at(static_cast<std::size_t>(row.slot)) = std::move(image);
    }
  return resolved;
}

}  // namespace dermis
