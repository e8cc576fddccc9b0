#include "import/row_reducer.h"

#include <algorithm>
#include <cmath>

namespace dermis::import {

RowReducer::RowReducer(int inputWidth, int inputHeight, int outputWidth, int outputHeight, int channels,
                       std::function<void(int, std::span<const float>)> finished)
    : m_inputWidth(inputWidth),
      m_outputWidth(outputWidth),
      m_outputHeight(outputHeight),
      m_channels(channels),
      m_rowsAnOutput(static_cast<double>(inputHeight) / outputHeight),
      m_narrow(static_cast<std::size_t>(outputWidth) * static_cast<std::size_t>(channels)),
      m_sum(m_narrow.size(), 0.0F),
      m_finished(std::move(finished)) {}

void RowReducer::add(std::span<const float> row) {
  // Average across: from x·s to (x+1)·s, with the first and last pixel by the share that is covered.
  const double step = static_cast<double>(m_inputWidth) / m_outputWidth;
  const auto channels = static_cast<std::size_t>(m_channels);
  for (int x = 0; x < m_outputWidth; ++x) {
    const double begin = x * step;
    const double end = std::min((x + 1) * step, static_cast<double>(m_inputWidth));
    for (std::size_t c = 0; c < channels; ++c) {
      double sum = 0.0;
      for (int i = static_cast<int>(begin); i < m_inputWidth && i < end; ++i) {
        const double share = std::min(end, i + 1.0) - std::max(begin, static_cast<double>(i));
        sum += share * static_cast<double>(row[static_cast<std::size_t>(i) * channels + c]);
      }
      m_narrow[static_cast<std::size_t>(x) * channels + c] = static_cast<float>(sum / (end - begin));
    }
  }

  // Average down: an input row may end one output row and begin the next.
  double top = m_inputRow;
  const double bottom = ++m_inputRow;
  while (top < bottom && m_outputRow < m_outputHeight) {
    const double edge = (m_outputRow + 1) * m_rowsAnOutput;
    const double until = std::min(bottom, edge);
    accumulate(m_narrow, static_cast<float>(until - top));
    m_weight += until - top;
    top = until;
    constexpr double kRounding = 1e-9;
    if (until >= edge - kRounding * edge) finish();
  }
}

void RowReducer::accumulate(std::span<const float> row, float weight) {
  for (std::size_t i = 0; i < row.size(); ++i) m_sum[i] += weight * row[i];
}

void RowReducer::finish() {
  const auto scale = static_cast<float>(m_weight > 0.0 ? 1.0 / m_weight : 0.0);
  for (float& value : m_sum) value *= scale;
  m_finished(m_outputRow++, m_sum);
  std::fill(m_sum.begin(), m_sum.end(), 0.0F);
  m_weight = 0.0;
}

}  // namespace dermis::import
