// A scene as a file (NAME.dermis, format "dermis.scene").
//
// In memory paths of files are absolute; in the file they are relative to its folder where they can be. Presets that a
// scene names are loaded from disk with it and are never written with it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/scene/scene.h"

namespace dermis {

inline constexpr std::string_view kSceneFormat = "dermis.scene";
inline constexpr int kSceneVersion = 1;

/// What becomes of a scene whose presets cannot be read. An editor keeps their paths, with a warning each, and shows
/// the default material: the rest of the work is worth opening. A picture that is drawn unseen must not show another
/// look.
enum class MissingPresets { Refuse, Keep };

/// Reads a scene. `name` is the file's name for messages; paths are relative to `baseFolder`. Unknown keys are kept and
/// reported. Errors: Input with the JSON pointer of the place: not JSON, wrong types, versions from the future, more
/// than kMaxLights lights, directions and cameras without a direction, presets that are missing or unusable; but see
/// MissingPresets.
[[nodiscard]] Result<Scene> readScene(std::string_view text, const std::string& name,
                                      const std::filesystem::path& baseFolder, Warnings& warnings,
                                      MissingPresets missing = MissingPresets::Refuse);
[[nodiscard]] Result<Scene> loadScene(const std::filesystem::path& path, Warnings& warnings,
                                      MissingPresets missing = MissingPresets::Refuse);

[[nodiscard]] std::string writeScene(const Scene& scene, const std::filesystem::path& sceneFolder);
/// Writes beside the target and renames. Errors: Runtime, as writeFileAtomically.
[[nodiscard]] Result<void> saveScene(const std::filesystem::path& path, const Scene& scene);

/// "environment", "irradiance", "prefiltered:0.4", "color:r,g,b", "none"; nothing where the text is none of these.
[[nodiscard]] std::optional<Background> backgroundFromText(std::string_view text);
[[nodiscard]] std::string toString(const Background& background);

/// The words of the file: "point", "directional", …
[[nodiscard]] std::string_view toString(LightType type);
/// "none", "orbit", "sway".
[[nodiscard]] std::string_view toString(AnimationKind kind);

}  // namespace dermis
