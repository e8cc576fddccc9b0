// A little window that files are dragged out of, for drops from another process: what a file manager is to the editor.
#pragma once

namespace dermis {

/// `--drag-source FILE…`
inline constexpr const char* kDragSource = "--drag-source";
/// Stays above other windows, in the lower right of the screen, until it is killed.
int dragSource(int argc, char** argv);

}  // namespace dermis
