// What the allocator keeps of what was freed.
#pragma once

namespace dermis {

/// Gives pages that hold nothing any more back to the system; loading leaves tens of megabytes of them between what
/// stays. Takes milliseconds, on any thread. Does nothing where the C library has no such call.
void giveMemoryBack();

}  // namespace dermis
