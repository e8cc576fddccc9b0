// Mutated files: each format 500 times from a fixed seed, in a child process, so that a crash names its seed.
//
// DERMIS_MUTATIONS sets another number, DERMIS_MUTATION_SEED another first seed.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <random>

#include "fixtures.h"

namespace dermis {
namespace {

using namespace fixtures;

constexpr unsigned kSecondsAtMost = 10;
constexpr const char* kNoteVariable = "DERMIS_MUTATION_NOTE";

unsigned setting(const char* name, unsigned otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr ? otherwise : static_cast<unsigned>(std::strtoul(text, nullptr, 10));
}

/// Turns bits, overwrites with telling bytes, removes, repeats, swaps numbers: one to eight such changes.
std::string mutated(const std::string& whole, unsigned seed) {
  std::mt19937 random(seed);
  std::string out = whole;
  const auto below = [&](std::size_t n) { return n == 0 ? 0 : std::size_t{random()} % n; };
  for (std::size_t change = 0, changes = 1 + below(8); change < changes && !out.empty(); ++change) {
    const std::size_t at = below(out.size());
    const std::size_t length = std::min(out.size() - at, 1 + below(16));
    switch (below(7)) {
      case 0:
        out[at] = static_cast<char>(out[at] ^ (1 << below(8)));
        break;
      case 1:
        out[at] = static_cast<char>(below(256));
        break;
      case 2:
        out.replace(at, std::min<std::size_t>(4, out.size() - at),
                    below(2) != 0 ? "\xff\xff\xff\xff" : std::string(4, '\0'));
        break;
      case 3:
        out.erase(at, length);
        break;
      case 4:
        out.insert(at, out.substr(below(out.size()), length));
        break;
      case 5:
        out.resize(at);
        break;
      default: {
        static const char* const kNumbers[] = {"-1", "4294967295", "nan", "1e39", "0", "99999999999999999999",
                                               "-",  "\"",         "{",   "<"};
        out.replace(at, std::min<std::size_t>(1, out.size() - at), kNumbers[below(std::size(kNumbers))]);
      }
    }
  }
  return out;
}

/// What a load came to: a complaint about the module, or empty.
using Attempt = std::function<std::string(const std::filesystem::path& path, const std::string& name)>;

std::string attemptModel(const std::filesystem::path& path, const std::string& name) {
  const auto model = module().loadModel(path);
  if (model) return brokenPromise(*model);
  return isOneSentence(model.error().message, name) ? "" : "is refused by: " + model.error().message;
}

std::string attemptImage(const std::filesystem::path& path, const std::string& name) {
  Warnings warnings;
  const auto image = module().loadImage(path, {.maximumSize = 1024}, warnings);
  if (image) return brokenPromise(*image);
  return isOneSentence(image.error().message, name) ? "" : "is refused by: " + image.error().message;
}

/// In the child: loads mutation after mutation, noting each seed in a file first.
void attemptAll(const std::string& name, const std::string& whole, const Attempt& attempt, const char* noteFile) {
  const unsigned end = setting("DERMIS_MUTATION_END", 0);
  const Folder folder;
  for (unsigned seed = setting("DERMIS_MUTATION_SEED", 1); seed < end; ++seed) {
    std::ofstream(noteFile) << seed;
    alarm(kSecondsAtMost);
    const auto path = folder.put(name, mutated(whole, seed));
    if (const std::string complaint = attempt(path, name); !complaint.empty()) {
      fmt::print(stderr, "{} of seed {} {}\n", name, seed, complaint);
      std::filesystem::remove_all(path.parent_path());
      _exit(3);
    }
  }
}

/// This program again, on the running test alone, from `seed` on. Its exit status.
int runChild(unsigned seed, unsigned end, const std::filesystem::path& noteFile) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const std::string filter = fmt::format("--gtest_filter={}.{}", test->test_suite_name(), test->name());
  const pid_t child = fork();
  if (child == 0) {
    setenv(kNoteVariable, noteFile.c_str(), 1);
    setenv("DERMIS_MUTATION_SEED", fmt::format("{}", seed).c_str(), 1);
    setenv("DERMIS_MUTATION_END", fmt::format("{}", end).c_str(), 1);
    execl("/proc/self/exe", "dermis_import_tests", filter.c_str(), "--gtest_brief=1", static_cast<char*>(nullptr));
    _exit(127);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return status;
}

void survives(const std::string& name, const std::string& whole, const Attempt& attempt) {
  ASSERT_FALSE(whole.empty());
  if (const char* noteFile = std::getenv(kNoteVariable)) return attemptAll(name, whole, attempt, noteFile);
  // A dead child is followed by another for the seeds after the one it died of.
  const Folder folder;
  const auto note = folder.put("seed", "0");
  const unsigned first = setting("DERMIS_MUTATION_SEED", 1);
  const unsigned end = first + setting("DERMIS_MUTATIONS", 500);
  int deaths = 0;
  for (unsigned seed = first; seed < end && deaths < 20; ++deaths) {
    const int status = runChild(seed, end, note);
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) break;
    seed = static_cast<unsigned>(std::strtoul(bytesOf(note).c_str(), nullptr, 10));
    const std::string how =
        WIFSIGNALED(status) ? fmt::format("signal {}", WTERMSIG(status)) : fmt::format("exit {}", WEXITSTATUS(status));
    ADD_FAILURE() << name << ", seed " << seed << ": " << how
                  << (WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM ? " (too slow)" : "");
    ++seed;
  }
}

std::string written(const std::string& name, const Image& image) {
  const Folder folder;
  const auto done = module().writeImage(folder / name, {layerOf(image)}, {});
  return done ? bytesOf(folder / name) : std::string();
}

TEST(MutatedModel, Obj) { survives("m.obj", objCube(), attemptModel); }
TEST(MutatedModel, Glb) { survives("m.glb", gltfQuad().glb(), attemptModel); }
TEST(MutatedModel, GltfText) { survives("m.gltf", gltfQuad().text(), attemptModel); }
TEST(MutatedModel, PlyText) { survives("m.ply", plyTetrahedron(false), attemptModel); }
TEST(MutatedModel, PlyBinary) { survives("m.ply", plyTetrahedron(true), attemptModel); }
TEST(MutatedModel, StlText) { survives("m.stl", stlTetrahedron(false), attemptModel); }
TEST(MutatedModel, StlBinary) { survives("m.stl", stlTetrahedron(true), attemptModel); }
TEST(MutatedModel, Collada) { survives("m.dae", daeTriangle(0.01, "Z_UP"), attemptModel); }
TEST(MutatedModel, Fbx) { survives("m.fbx", fbxTriangle(1.0, true), attemptModel); }

TEST(MutatedImage, Png) { survives("m.png", written("m.png", makeImage(24, 20, 4, PixelType::U8)), attemptImage); }
TEST(MutatedImage, Png16) { survives("m.png", written("m.png", makeImage(24, 20, 3, PixelType::U16)), attemptImage); }
TEST(MutatedImage, Jpeg) { survives("m.jpg", written("m.jpg", makeImage(24, 20, 3, PixelType::U8)), attemptImage); }
TEST(MutatedImage, Tiff) { survives("m.tif", written("m.tif", makeImage(24, 20, 4, PixelType::U8)), attemptImage); }
TEST(MutatedImage, RadianceHdr) {
  std::string pixels;
  for (int i = 0; i < 80; ++i) pixels += std::string("\x80\x40\x20\x81", 4);
  survives("m.hdr", "#?RADIANCE\nGAMMA=1\nFORMAT=32-bit_rle_rgbe\n\n-Y 10 +X 8\n" + pixels, attemptImage);
}
TEST(MutatedImage, Exr) { survives("m.exr", written("m.exr", makeImage(24, 20, 4, PixelType::Half)), attemptImage); }

}  // namespace
}  // namespace dermis
