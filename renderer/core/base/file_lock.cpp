#include "core/base/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <utility>

namespace dermis {

FileLock::FileLock(std::filesystem::path path, int descriptor) : m_path(std::move(path)), m_descriptor(descriptor) {}

FileLock::~FileLock() {
  if (m_descriptor >= 0) ::close(m_descriptor);
}

FileLock::FileLock(FileLock&& other) noexcept
    : m_path(std::move(other.m_path)), m_descriptor(std::exchange(other.m_descriptor, -1)) {}

FileLock& FileLock::operator=(FileLock&& other) noexcept {
  std::swap(m_path, other.m_path);
  std::swap(m_descriptor, other.m_descriptor);
  return *this;
}

std::optional<FileLock> FileLock::tryLock(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (descriptor < 0) return std::nullopt;
  FileLock lock(path, descriptor);
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) return std::nullopt;
  // Its last owner may have removed the file between our open and our lock; then what we hold guards nothing.
  struct stat held {};
  struct stat there {};
  if (::fstat(descriptor, &held) != 0 || ::stat(path.c_str(), &there) != 0 || held.st_ino != there.st_ino)
    return std::nullopt;
  return lock;
}

void FileLock::removeFile() {
  if (m_descriptor < 0) return;
  ::unlink(m_path.c_str());
  ::close(std::exchange(m_descriptor, -1));
}

}  // namespace dermis
