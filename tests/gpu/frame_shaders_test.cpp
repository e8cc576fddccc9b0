// The shader library: includes, places in messages, reloading.
#include <gmock/gmock.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "gpu/gl_fixture.h"

namespace dermis::test {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

class FrameShaders : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    std::string pattern = (std::filesystem::temp_directory_path() / "dermis-shaders-XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    m_folder = pattern;
    write("t.vert", "void main() { gl_Position = vec4(0.0); }\n");
  }
  void TearDown() override {
    std::filesystem::remove_all(m_folder);
    GlTest::TearDown();
  }
  void write(const std::string& name, const std::string& text) {
    std::filesystem::create_directories((m_folder / name).parent_path());
    std::ofstream(m_folder / name) << text;
    // Times of files may be as coarse as the clock's tick: each edit is later than the last by more than that.
    m_time += std::chrono::seconds(2);
    std::filesystem::last_write_time(m_folder / name, m_time);
  }
  std::filesystem::path m_folder;
  std::filesystem::file_time_type m_time = std::filesystem::file_time_type::clock::now();
  gl::ProgramSources m_sources{.vertex = "t.vert", .fragment = "t.frag", .compute = {}, .defines = {}, .generated = {}};
};

TEST_F(FrameShaders, IncludesAreResolvedOnceAndErrorsNameFileAndLine) {
  write("t.frag",
        "// one\n#include \"sub/a.glsl\"\n#include \"sub/a.glsl\"\nout vec4 o;\nvoid main() { o = a() + oops; }\n");
  write("sub/a.glsl", "vec4 a() { return vec4(1.0); }\n");
  gl::ShaderLibrary shaders(m_folder);
  auto program = shaders.program(m_sources);
  ASSERT_FALSE(program.has_value());
  EXPECT_THAT(program.error().message, StartsWith("t.frag:5:"));
  EXPECT_THAT(program.error().message, HasSubstr("oops"));

  write("sub/a.glsl", "\n\nvec4 a() { return vec4(nope); }\n");
  write("t.frag", "#include \"sub/a.glsl\"\nout vec4 o;\nvoid main() { o = a(); }\n");
  Warnings messages;
  EXPECT_FALSE(shaders.reloadChanged(messages));
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_THAT(messages[0], StartsWith("sub/a.glsl:3:"));
}

TEST_F(FrameShaders, ABrokenEditKeepsTheLastGoodProgram) {
  write("t.frag", "out vec4 o;\nvoid main() { o = vec4(1.0); }\n");
  gl::ShaderLibrary shaders(m_folder);
  const auto program = shaders.program(m_sources);
  ASSERT_TRUE(program.has_value()) << program.error().message;
  const GLuint good = (*program)->id();

  write("t.frag", "out vec4 o;\nvoid main() {\n  o = vec4(1.0;\n}\n");
  Warnings messages;
  EXPECT_FALSE(shaders.reloadChanged(messages));
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_THAT(messages[0], StartsWith("t.frag:3:"));
  EXPECT_THAT(messages[0], HasSubstr("last good program stays"));
  EXPECT_EQ((*program)->id(), good);
  EXPECT_EQ(*shaders.program(m_sources), *program);

  write("t.frag", "out vec4 o;\nvoid main() { o = vec4(0.5); }\n");
  messages.clear();
  EXPECT_TRUE(shaders.reloadChanged(messages));
  EXPECT_TRUE(messages.empty());
  EXPECT_NE((*program)->id(), 0U);
  EXPECT_EQ(shaders.compileCount(), 3U);
  EXPECT_FALSE(shaders.reloadChanged(messages)) << "nothing changed since";
  EXPECT_EQ(shaders.compileCount(), 3U);
}

TEST_F(FrameShaders, AProgramThatFailedIsTriedAgainOnlyAfterAnEdit) {
  write("t.frag", "broken\n");
  gl::ShaderLibrary shaders(m_folder);
  EXPECT_FALSE(shaders.program(m_sources).has_value());
  EXPECT_FALSE(shaders.program(m_sources).has_value());
  EXPECT_EQ(shaders.compileCount(), 1U);
  write("t.frag", "out vec4 o;\nvoid main() { o = vec4(1.0); }\n");
  Warnings messages;
  EXPECT_TRUE(shaders.reloadChanged(messages));
  EXPECT_TRUE(shaders.program(m_sources).has_value());
}

TEST_F(FrameShaders, DefinesChooseFilesAndGeneratedTextIsIncluded) {
  write("t.frag",
        "#include CHOSEN\n#include \"generated/g.glsl\"\nout vec4 o;\nvoid main() { o = vec4(b() + g() + VALUE); }\n");
  write("b.glsl", "float b() { return 1.0; }\n");
  m_sources.defines = {"CHOSEN \"b.glsl\"", "VALUE 2.0"};
  m_sources.generated["generated/g.glsl"] = "float g() { return 3.0; }\n";
  gl::ShaderLibrary shaders(m_folder);
  const auto program = shaders.program(m_sources);
  EXPECT_TRUE(program.has_value()) << program.error().message;
}

TEST_F(FrameShaders, AMissingIncludeNamesItsPlace) {
  write("t.frag", "\n#include \"nowhere.glsl\"\nvoid main() {}\n");
  gl::ShaderLibrary shaders(m_folder);
  const auto program = shaders.program(m_sources);
  ASSERT_FALSE(program.has_value());
  EXPECT_THAT(program.error().message, StartsWith("t.frag:2: no shader file \"nowhere.glsl\""));
}

TEST(FrameShaderLog, BothWaysOfWritingAPlaceAreUnderstood) {
  gl::ShaderLibrary::Expanded source;
  source.files = {"a.frag", "b.glsl"};
  source.lines = {{0, 0}, {0, 1}, {1, 1}, {1, 2}, {0, 3}};
  EXPECT_EQ(gl::nameFilesInLog("0:4(5): error: no\n", source), "b.glsl:2: error: no\n");
  EXPECT_EQ(gl::nameFilesInLog("0(5) : error C1008: no\n", source), "a.frag:3: error C1008: no\n");
  EXPECT_EQ(gl::nameFilesInLog("ERROR: 0:3: no\n", source), "b.glsl:1: no\n");
  EXPECT_EQ(gl::nameFilesInLog("0:1(1): error: no\n", source), "0:1(1): error: no\n") << "a line of ours";
  EXPECT_EQ(gl::nameFilesInLog("0:9(1): error: no\n", source), "0:9(1): error: no\n");
}

}  // namespace
}  // namespace dermis::test
