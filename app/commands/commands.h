// The subcommands: each adds itself to the program's options and, when chosen, puts what it does into `action`.
#pragma once

#include "app/commands/support.h"

namespace CLI {
class App;
}

namespace dermis::cli {

void addRender(CLI::App& root, Action& action);
void addBake(CLI::App& root, Action& action);
void addExport(CLI::App& root, Action& action);
void addInspect(CLI::App& root, Action& action);
void addCompare(CLI::App& root, Action& action);
void addVerify(CLI::App& root, Action& action);
void addThumbnails(CLI::App& root, Action& action);
void addParameters(CLI::App& root, Action& action);
void addBenchmark(CLI::App& root, Action& action);

}  // namespace dermis::cli
