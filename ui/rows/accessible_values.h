// What a screen reader is told about our own controls: real numbers instead of a slider's steps.
#pragma once

namespace dermis {

/// Once, before the first such control is made; later calls do nothing.
void installAccessibleValues();

}  // namespace dermis
