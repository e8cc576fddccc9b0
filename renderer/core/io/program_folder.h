// Where the program lies, and so what came with it.
#pragma once

#include <filesystem>

namespace dermis {

/// The folder of the running executable; the current one where the system doesn't say.
[[nodiscard]] std::filesystem::path programFolder();

}  // namespace dermis
