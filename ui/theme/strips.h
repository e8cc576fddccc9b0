// What panels and windows are stacked of.
#pragma once

class QFrame;
class QVBoxLayout;
class QWidget;

namespace dermis {

/// Lays out `owner` as a column without margins and gaps.
QVBoxLayout* flushColumn(QWidget* owner);
/// A bar of tools at the top of such a column; the layout inside is the caller's.
QFrame* toolStrip(QWidget* parent);

}  // namespace dermis
