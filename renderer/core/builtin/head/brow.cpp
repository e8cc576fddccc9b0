#include "core/builtin/head/brow.h"

namespace dermis::sculpt {

Brow::Brow()
    : m_height({{8, 17.5F}, {20, 20.5F}, {34, 22}, {46, 19.5F}, {56, 13}}),
      m_halfWidth({{7, 1.2F}, {10, 4.9F}, {24, 4.7F}, {40, 3.2F}, {55, 1.0F}}) {}

}  // namespace dermis::sculpt
