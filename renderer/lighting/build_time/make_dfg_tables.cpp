// Run by the build: writes the two DFG tables, one after the other, as 32-bit floats. A second here instead of at every
// start.
#include <cstdio>
#include <initializer_list>
#include <vector>

#include "lighting/dfg_layout.h"
#include "lighting/dfg_quadrature.h"

int main(int count, char** arguments) {
  if (count != 2) return std::fputs("usage: make_dfg_tables OUT\n", stderr), 2;
  std::vector<float> texels;
  for (const auto geometry : {dermis::DfgGeometry::Smith, dermis::DfgGeometry::SchlickIbl})
    for (int row = 0; row < dermis::kDfgEdge; ++row)
      for (int column = 0; column < dermis::kDfgEdge; ++column) {
        const double root = static_cast<double>(column) / (dermis::kDfgEdge - 1);
        const dermis::DfgValue value =
            dermis::dfgQuadrature(geometry, root * root, static_cast<double>(row) / (dermis::kDfgEdge - 1));
        texels.push_back(static_cast<float>(value.scale));
        texels.push_back(static_cast<float>(value.bias));
      }
  std::FILE* file = std::fopen(arguments[1], "wb");
  if (file == nullptr) return std::perror(arguments[1]), 1;
  const bool written = std::fwrite(texels.data(), sizeof(float), texels.size(), file) == texels.size();
  return std::fclose(file) == 0 && written ? 0 : 1;
}
