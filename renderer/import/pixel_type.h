// PixelType as OpenImageIO says it.
#pragma once

#include <OpenImageIO/typedesc.h>

#include "core/image/image.h"

namespace dermis::import {

[[nodiscard]] inline OIIO::TypeDesc typeDesc(PixelType type) {
  switch (type) {
    case PixelType::U8:
      return OIIO::TypeUInt8;
    case PixelType::U16:
      return OIIO::TypeUInt16;
    case PixelType::Half:
      return OIIO::TypeHalf;
    case PixelType::Float:
      break;
  }
  return OIIO::TypeFloat;
}

}  // namespace dermis::import
