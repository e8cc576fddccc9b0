#include "core/base/mapped_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace dermis {

MappedFile::MappedFile(const std::filesystem::path& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return;
  struct stat status {};
  if (::fstat(file, &status) == 0 && status.st_size > 0) {
    const auto size = static_cast<std::size_t>(status.st_size);
    // All at once: a fault for each few pages would cost more than the copy that this saves.
    void* data = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE | MAP_POPULATE, file, 0);
    if (data != MAP_FAILED) {
      m_data = data;
      m_size = size;
    }
  }
  ::close(file);
}

MappedFile::~MappedFile() {
  if (m_data != nullptr) ::munmap(m_data, m_size);
}

void MappedFile::giveBack() const {
  if (m_data != nullptr) ::madvise(m_data, m_size, MADV_DONTNEED);
}

}  // namespace dermis
