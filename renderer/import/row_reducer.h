// Makes an image smaller by area averaging while its rows arrive, so that only the small one is ever in memory.
#pragma once

#include <functional>
#include <span>
#include <vector>

namespace dermis::import {

/// Each output pixel is the mean of the input pixels below it, weighted by the area it covers of each.
/// Values are averaged as they are stored (sRGB-encoded ones too: what a map means isn't known here).
class RowReducer {
 public:
  /// `finished(y, row)` gets each output row once, top to bottom. Output sides must not exceed the input's.
  RowReducer(int inputWidth, int inputHeight, int outputWidth, int outputHeight, int channels,
             std::function<void(int y, std::span<const float> row)> finished);
  /// Input rows in order from the top, inputWidth · channels values each.
  void add(std::span<const float> row);

 private:
  void accumulate(std::span<const float> row, float weight);
  void finish();

  int m_inputWidth, m_outputWidth, m_outputHeight, m_channels;
  double m_rowsAnOutput;
  int m_inputRow = 0;
  int m_outputRow = 0;
  double m_weight = 0.0;
  std::vector<float> m_narrow;  ///< the arriving row, already averaged across
  std::vector<float> m_sum;
  std::function<void(int, std::span<const float>)> m_finished;
};

}  // namespace dermis::import
