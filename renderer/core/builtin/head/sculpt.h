// The whole bust as one signed distance.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "core/builtin/head/base_form.h"
#include "core/builtin/head/ear.h"
#include "core/builtin/head/face_strokes.h"
#include "core/builtin/head/lids.h"
#include "core/builtin/head/lips.h"
#include "core/builtin/head/nose.h"
#include "core/builtin/head/stroke.h"

namespace dermis::sculpt {

/// Symmetrical, in millimetres, axes as the pins'. Built in this order: base form, broad strokes, lids' swelling, nose,
/// fine strokes, lips, ears, cuts of nostrils and lids, base.
class Sculpt {
 public:
  Sculpt();
  /// Signed distance to the skin, exact only near it.
  [[nodiscard]] float operator()(const glm::vec3& p) const;
  /// Its gradient by four values round p, and the mean of those.
  struct Slope {
    glm::vec3 gradient;
    float distance;
    /// p moved towards the skin by a step of Newton's method, no further than `most` mm.
    [[nodiscard]] glm::vec3 onSkin(const glm::vec3& p, float most) const;
  };
  [[nodiscard]] Slope slope(const glm::vec3& p, float delta) const;

  [[nodiscard]] const Ear& ear() const { return m_ear; }
  [[nodiscard]] const Lids& lids() const { return m_lids; }
  [[nodiscard]] const Lips& lips() const { return m_lips; }

 private:
  [[nodiscard]] float form(const glm::vec3& p) const;
  [[nodiscard]] std::vector<Stroke> dropped(const std::vector<DrawnStroke>& drawn) const;
  [[nodiscard]] glm::vec3 dropFrom(DrawnFrom from, float across, float y) const;

  BaseForm m_base;
  Lids m_lids;
  Nose m_nose;
  Lips m_lips;
  Ear m_ear;
  bool m_formed = false;  ///< false while the broad strokes are dropped on the bare base form
  std::vector<Stroke> m_broad, m_fine;
};

}  // namespace dermis::sculpt
