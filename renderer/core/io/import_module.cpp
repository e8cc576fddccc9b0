#include <dlfcn.h>

#include <array>
#include <atomic>
#include <mutex>

#include "core/io/importer.h"
#include "core/io/program_folder.h"

namespace dermis {
namespace {

std::mutex g_mutex;
std::atomic<const Importer*> g_importer = nullptr;

}  // namespace

Result<const Importer*> importer() {
  if (const Importer* loaded = g_importer.load()) return loaded;
  const std::lock_guard lock(g_mutex);
  if (const Importer* loaded = g_importer.load()) return loaded;

  const std::filesystem::path folder = programFolder();
  const std::array candidates = {folder / "dermis_import.so", folder / "../bin/dermis_import.so",
                                 folder / "../lib/dermis/dermis_import.so"};
  for (const auto& candidate : candidates) {
    std::error_code error;
    if (!std::filesystem::exists(candidate, error)) continue;
    void* handle = dlopen(candidate.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (handle == nullptr) return runtimeError(std::string("the import module does not load: ") + dlerror());
    using Entry = const Importer* (*)();
    const auto entry = reinterpret_cast<Entry>(dlsym(handle, kImporterSymbol));
    if (entry == nullptr)
      return runtimeError("the import module " + candidate.string() + " has no entry; reinstall Dermis");
    g_importer = entry();
    return g_importer.load();
  }
  return runtimeError("the import module dermis_import.so is not beside the program (" + folder.string() +
                      ") nor in ../lib/dermis; reinstall Dermis");
}

bool importerLoaded() { return g_importer.load() != nullptr; }

}  // namespace dermis
