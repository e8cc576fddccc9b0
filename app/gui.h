// Starts the editor.
#pragma once

#include <filesystem>
#include <vector>

namespace dermis {

/// Opens the window on the files given and returns the exit code. With no reachable display: one sentence on stderr
/// and 1. `argc` and `argv` outlive the call; Qt takes its own options out of them.
int runEditor(int& argc, char** argv, const std::vector<std::filesystem::path>& files);

}  // namespace dermis
