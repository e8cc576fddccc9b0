// The spacing grid: every margin, gap and column of the panels comes from here.
#pragma once

namespace dermis::metrics {

inline constexpr int kGap = 6;
inline constexpr int kMargin = 12;
inline constexpr int kRowSpacing = 4;
inline constexpr int kLabelWidth = 124;
inline constexpr int kPrefixWidth = 10;
inline constexpr int kNumberWidth = 66;
inline constexpr int kUnitWidth = 26;
inline constexpr int kControlHeight = 24;
inline constexpr int kDotWidth = 10;

}  // namespace dermis::metrics
