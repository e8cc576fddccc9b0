// Which threads come first where pictures are drawn while others load and bake.
#pragma once

namespace dermis {

/// Said once by a program with a window, before it starts threads: work beside the pictures gives way to them. A
/// command that waits for its work doesn't say it.
void putPicturesFirst();
/// To be called by a thread at the beginning of such work: from then on it, and threads that it starts, run when those
/// that draw leave the processor to them (Linux: nice 10). Does nothing where pictures don't come first.
void giveWay();

}  // namespace dermis
