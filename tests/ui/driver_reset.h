// A graphics driver that was reset, as OpenGL tells of it (glGetGraphicsResetStatus): once, and contexts made later
// work.
#pragma once

namespace dermis::test {

/// The context that is asked next is lost.
void resetDriver();
/// Every context is lost, those made later as well, until it is mended.
void breakDriver();
void mendDriver();
/// How often a context was told that it is lost.
int contextsTold();

}  // namespace dermis::test
