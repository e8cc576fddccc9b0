// A process that edits, saves and autosaves until somebody ends it.
#pragma once

namespace dermis {

/// The first argument that asks for it; then folder for unsaved work, file to save to, autosave interval in ms.
inline constexpr const char* kEditUntilKilled = "--edit-until-killed";

/// Prints "edit N TIME" before each edit (the scene's one lamp is then called N) and "saved N" after each save.
int editUntilKilled(int argc, char** argv);

}  // namespace dermis
