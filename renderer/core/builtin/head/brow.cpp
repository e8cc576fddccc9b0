#include "core/builtin/head/brow.h"

namespace dermis::sculpt {

Brow::Brow()
    : m_height({{8, 17.5F}, {20, 20.5F}, {34, 22}, {46, 19.5F}, {56, 13}}),
      m_halfWidth({{7, 1}, {10, 4.2F}, {24, 3.9F}, {40, 2.6F}, {55, 0.8F}}) {}

}  // namespace dermis::sculpt
