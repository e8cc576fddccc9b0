// The queue of sliced jobs.
#include <gmock/gmock.h>

#include "gl/job_queue.h"
#include "gpu/gl_fixture.h"

namespace dermis::test {
namespace {

class FrameJobs : public GlTest {
 protected:
  /// A job of `slices` that writes its name at each one.
  std::unique_ptr<gl::Job> job(const std::string& name, int slices) {
    return gl::makeJob(
        name,
        [this, name, left = slices]() mutable -> Result<bool> {
          m_log += name;
          return --left == 0;
        },
        [] { return 0.5; });
  }
  std::string m_log;
  gl::JobQueue m_queue;
  Warnings m_messages;
};

TEST_F(FrameJobs, RunInOrderOneSliceAtLeast) {
  m_queue.add("a", job("a", 2));
  m_queue.add("b", job("b", 1));
  EXPECT_TRUE(m_queue.run(0.0, m_messages));
  EXPECT_EQ(m_log, "a");
  EXPECT_EQ(m_queue.progress(), (std::pair<std::string, double>("a", 0.5)));
  EXPECT_TRUE(m_queue.run(0.0, m_messages));
  EXPECT_FALSE(m_queue.run(0.0, m_messages));
  EXPECT_EQ(m_log, "aab");
  EXPECT_TRUE(m_queue.idle());
  EXPECT_EQ(m_queue.progress().first, "");
}

TEST_F(FrameJobs, TheLastOfAKindCounts) {
  m_queue.add("environment", job("a", 5));
  EXPECT_TRUE(m_queue.run(0.0, m_messages));
  m_queue.add("environment", job("b", 1));
  EXPECT_TRUE(m_queue.finish().has_value());
  EXPECT_EQ(m_log, "ab");
}

TEST_F(FrameJobs, CancelDropsAll) {
  m_queue.add("a", job("a", 2));
  m_queue.cancel();
  EXPECT_FALSE(m_queue.run(100.0, m_messages));
  EXPECT_EQ(m_log, "");
}

TEST_F(FrameJobs, AnErrorEndsItsJobOnly) {
  m_queue.add("bad", gl::makeJob("bad", []() -> Result<bool> { return runtimeError("broke"); }));
  m_queue.add("good", job("g", 1));
  EXPECT_FALSE(m_queue.run(1000.0, m_messages));
  EXPECT_THAT(m_messages, ::testing::ElementsAre("broke"));
  EXPECT_EQ(m_log, "g");
}

TEST_F(FrameJobs, AJobMayAddAnother) {
  m_queue.add("first", gl::makeJob("first", [this]() -> Result<bool> {
                m_queue.add("second", job("s", 1));
                return true;
              }));
  EXPECT_TRUE(m_queue.finish().has_value());
  EXPECT_EQ(m_log, "s");
}

}  // namespace
}  // namespace dermis::test
