// The one program: a subcommand, or the editor on the files given.
#include <cstdio>

int main() {
  std::puts("dermis " DERMIS_VERSION);
  return 0;
}
