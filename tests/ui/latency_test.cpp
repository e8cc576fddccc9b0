// How long the window doesn't answer while much is loaded. Not part of the tests, because it takes minutes and says as
// much of the machine as of the program:
//   dermis_ui_tests --gtest_also_run_disabled_tests --gtest_filter='Latency.*'
#include <QElapsedTimer>
#include <QFile>
#include <QTimer>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <numbers>

#include "core/io/png_writer.h"
#include "ui/editor_fixture.h"

namespace dermis {
namespace {

/// Ticks whenever the event loop is free; the longest pause is how long nobody was answered.
class Heartbeat {
 public:
  Heartbeat() {
    m_timer.setTimerType(Qt::PreciseTimer);
    m_timer.setInterval(1);
    QObject::connect(&m_timer, &QTimer::timeout, [this] { beat(); });
    m_clock.start();
    m_timer.start();
  }
  double longestMs() {
    beat();
    return m_longest;
  }
  void forget() {
    m_clock.restart();
    m_longest = 0.0;
  }

 private:
  void beat() {
    m_longest = std::max(m_longest, static_cast<double>(m_clock.nsecsElapsed()) * 1e-6);
    m_clock.restart();
  }
  QTimer m_timer;
  QElapsedTimer m_clock;
  double m_longest = 0.0;
};

template <class T>
void put(std::string& bytes, const T& value) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  bytes.append(raw, sizeof value);
}

/// A bumpy sphere of n × n squares with texture coordinates, as binary PLY: two triangles a square.
std::string bumpySphere(int n) {
  const int side = n + 1;
  std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(side * side) +
                      "\nproperty float x\nproperty float y\nproperty float z\nproperty float s\nproperty float t\n"
                      "element face " +
                      std::to_string(2 * n * n) + "\nproperty list uchar int vertex_indices\nend_header\n";
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i) {
      const float u = static_cast<float>(i) / static_cast<float>(n), v = static_cast<float>(j) / static_cast<float>(n);
      const float phi = 2.0F * std::numbers::pi_v<float> * u, theta = std::numbers::pi_v<float> * v;
      const float r = 0.1F * (1.0F + 0.01F * std::sin(60.0F * phi) * std::sin(60.0F * theta));
      for (const float value :
           {r * std::sin(theta) * std::sin(phi), r * std::cos(theta), r * std::sin(theta) * std::cos(phi), u, v})
        put(bytes, value);
    }
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = j * side + i, b = a + 1, c = a + side, d = c + 1;
      for (const auto& triangle : {std::array<int, 3>{a, c, b}, std::array<int, 3>{b, c, d}}) {
        bytes.push_back(3);
        for (const int index : triangle) put(bytes, index);
      }
    }
  return bytes;
}

std::string gradientHdr(int width, int height) {
  std::string bytes =
      "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(height) + " +X " + std::to_string(width) + "\n";
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const bool sun = std::hypot(x - width / 3, y - height / 3) < 30.0;
      bytes.push_back(static_cast<char>(60 + 120 * y / height));
      bytes.push_back(static_cast<char>(80 + 100 * x / width));
      bytes.push_back(static_cast<char>(140));
      bytes.push_back(static_cast<char>(sun ? 140 : 128));
    }
  return bytes;
}

/// What is loaded, made at some size.
struct Load {
  std::string model, sky;
  std::vector<std::string> maps;
};

class Latency : public Editor {
 protected:
  static Load makeLoad(const QTemporaryDir& folder, const std::string& name, int squares, int skyHeight, int mapSide) {
    Load load{write(folder, (name + ".ply").c_str(), bumpySphere(squares)),
              write(folder, (name + ".hdr").c_str(), gradientHdr(2 * skyHeight, skyHeight)),
              {}};
    Image map;
    map.width = map.height = mapSide;
    map.channels = 3;
    map.pixels.resize(map.rowBytes() * static_cast<std::size_t>(mapSide));
    for (std::size_t i = 0; i < map.pixels.size(); ++i)
      map.pixels[i] = static_cast<std::byte>((i / 3 / 64 + i / 786432) % 200 + 40);
    for (int i = 0; i < 8; ++i) {
      load.maps.push_back(
          folder.filePath(QString::fromStdString(name) + QStringLiteral("%1.png").arg(i)).toStdString());
      if (i == 0)
        EXPECT_TRUE(writePng(load.maps.front(), map, {}).has_value());
      else
        EXPECT_TRUE(QFile::copy(QString::fromStdString(load.maps.front()), QString::fromStdString(load.maps.back())));
    }
    return load;
  }
};

TEST_F(Latency, DISABLED_LongestBlockWhileMuchIsLoaded) {
  const QTemporaryDir folder;
  Heartbeat heart;
  bool printing = false;
  const auto phase = [&](const char* name, auto start) {
    picture();
    heart.forget();
    QElapsedTimer clock;
    clock.start();
    start();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !window->tasks().busy() && window->viewport()->isSettled(); }, 600000));
    if (printing)
      std::printf("%-28s %8.0f ms in all, longest block %6.0f ms\n", name, static_cast<double>(clock.elapsed()),
                  heart.longestMs());
    // One still picture of what is there now.
    heart.forget();
    window->viewport()->setTargetSamples(1);
    Camera camera = document().camera();
    camera.position *= 1.0001F;
    document().setCamera(camera);
    picture();
    if (printing) std::printf("%-28s %31.0f ms\n", "  a frame of it", heart.longestMs());
    std::fflush(stdout);
  };
  const auto loadAll = [&](const Load& load) {
    phase("model, 1,002,528 triangles", [&] {
      ModelSource source;
      source.builtin.clear();
      source.path = load.model;
      window->loading().openModel(source);
    });
    phase("environment, 4096 x 2048", [&] {
      EnvironmentSource source;
      source.builtin.clear();
      source.path = load.sky;
      window->loading().setEnvironment(source);
    });
    const TextureSlot slots[] = {TextureSlot::Albedo,   TextureSlot::Normal,    TextureSlot::Roughness,
                                 TextureSlot::Specular, TextureSlot::Occlusion, TextureSlot::Metallic,
                                 TextureSlot::Emissive, TextureSlot::Thickness};
    phase("eight maps of 4096 x 4096", [&] {
      for (std::size_t i = 0; i < load.maps.size(); ++i)
        window->loading().assignTexture({document().currentSlot()}, slots[i], load.maps[i]);
    });
  };
  // What each needs is compiled once in a program's life, and counted apart: something small of each kind comes first.
  loadAll(makeLoad(folder, "small", 90, 32, 64));
  printing = true;
  loadAll(makeLoad(folder, "large", 708, 2048, 4096));
}

/// A picture that converges is drawn in between whatever else the window has to do.
TEST_F(Latency, DISABLED_LongestBlockWhileAPictureConverges) {
  window->resize(1600, 1000);
  picture();
  for (int round = 0; round < 3; ++round) {
    Heartbeat heart;
    QElapsedTimer clock;
    window->viewport()->setTargetSamples(12);
    Camera camera = document().camera();
    camera.position *= 1.0001F;
    document().setCamera(camera);
    clock.start();
    ASSERT_TRUE(QTest::qWaitFor([&] { return window->viewport()->isSettled(); }, 600000));
    std::printf("12 samples of the built-in look    %8.0f ms in all, longest block %6.0f ms\n",
                static_cast<double>(clock.elapsed()), heart.longestMs());
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace dermis
