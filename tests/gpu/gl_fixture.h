// A test with an OpenGL 4.5 context: one headless context for the whole program; a GL error fails the test that made
// it.
#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "gl/debug_output.h"
#include "gl/gl_objects.h"
#include "gl/headless_context.h"
#include "gl/shader_library.h"

namespace dermis::test {

/// The context all tests share, or null where there is none (the tests then fail with the reason).
inline gl::HeadlessContext* sharedContext() {
  static Result<std::unique_ptr<gl::HeadlessContext>> made = gl::HeadlessContext::create();
  EXPECT_TRUE(made.has_value()) << made.error().message;
  return made ? made->get() : nullptr;
}

class GlTest : public ::testing::Test {
 protected:
  void SetUp() override {
    gl::HeadlessContext* context = sharedContext();
    ASSERT_NE(context, nullptr);
    context->makeCurrent();
    m_debug = std::make_unique<gl::DebugOutput>(true);
  }
  void TearDown() override {
    if (m_debug == nullptr) return;
    for (const std::string& message : m_debug->take()) ADD_FAILURE() << "OpenGL: " << message;
    m_debug.reset();
  }

  std::unique_ptr<gl::DebugOutput> m_debug;
};

}  // namespace dermis::test
