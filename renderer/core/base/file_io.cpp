#include "core/base/file_io.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <system_error>

namespace dermis {
namespace {

namespace fs = std::filesystem;

/// An open file descriptor, closed at the end of the scope.
class Descriptor {
 public:
  explicit Descriptor(int fd) : m_fd(fd) {}
  ~Descriptor() {
    if (m_fd >= 0) ::close(m_fd);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  [[nodiscard]] int get() const { return m_fd; }
  [[nodiscard]] bool valid() const { return m_fd >= 0; }
  /// Some file systems report a full disk only here. False with errno set where closing fails.
  bool close() {
    const int fd = m_fd;
    m_fd = -1;
    return ::close(fd) == 0;
  }

 private:
  int m_fd;
};

/// A phrase for people that ends "cannot be read: …" or "cannot be written: …".
std::string reason(int error) {
  switch (error) {
    case ENOENT:
      return "there is no such file";
    case EACCES:
    case EPERM:
      return "permission is denied; check who owns it";
    case EROFS:
      return "it is on a read-only file system";
    case ENOSPC:
      return "the disk is full";
    case EDQUOT:
      return "the disk quota is used up";
    case ENAMETOOLONG:
      return "its name is too long";
    case EISDIR:
      return "it is a folder";
    case ENOTDIR:
      return "part of its path is not a folder";
    default:
      return std::generic_category().message(error);
  }
}

tl::unexpected<Error> unreadable(const fs::path& path, const std::string& why) {
  return inputError(path.string() + " cannot be read: " + why);
}
tl::unexpected<Error> unwritable(const fs::path& path, const std::string& why) {
  return runtimeError(path.string() + " cannot be written: " + why);
}

bool writeAll(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(fd, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

/// Where the bytes go: the file a symbolic link points to, else the path itself.
fs::path throughLinks(const fs::path& path) {
  std::error_code error;
  if (!fs::is_symlink(path, error)) return path;
  fs::path target = fs::weakly_canonical(path, error);
  return error ? path : target;
}

/// A file of a new name in the target's folder, removed unless renamed to the target.
class TemporaryFile {
 public:
  /// Creates the file; `valid()` says whether that worked, else errno says why not.
  explicit TemporaryFile(const fs::path& target) : m_target(target) {
    static std::atomic<unsigned> counter = 0;
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    for (int attempt = 0; attempt < 1000; ++attempt) {
      m_path = folder / (".dermis-" + std::to_string(::getpid()) + "-" + std::to_string(counter++) +
                         target.extension().string());
      m_fd = ::open(m_path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (m_fd >= 0) return;
      if (errno != EEXIST) break;
    }
    m_path.clear();
  }
  ~TemporaryFile() {
    if (m_fd >= 0) ::close(m_fd);
    if (!m_path.empty()) ::unlink(m_path.c_str());
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  [[nodiscard]] bool valid() const { return m_fd >= 0; }
  [[nodiscard]] const fs::path& path() const { return m_path; }

  /// Takes over mode and owner of the file that is replaced.
  void copyPermissions(const struct stat& replaced) const {
    // Only root may give a file away; that others cannot is no reason to refuse.
    if (::fchown(m_fd, replaced.st_uid, replaced.st_gid) != 0) errno = 0;
    if (::fchmod(m_fd, replaced.st_mode & 07777) != 0) errno = 0;
  }

  /// Flushes to the disk and puts the file in the target's place. False with errno set where that fails.
  bool commit() {
    if (::fsync(m_fd) != 0 && errno != EINVAL) return false;
    const int fd = m_fd;
    m_fd = -1;
    if (::close(fd) != 0) return false;
    if (::rename(m_path.c_str(), m_target.c_str()) != 0) return false;
    // The rename itself is on the disk once the folder is; a file system that cannot do this still has the file.
    const fs::path folder = m_path.parent_path();
    const Descriptor parent(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (parent.valid()) ::fsync(parent.get());
    m_path.clear();
    return true;
  }

 private:
  fs::path m_target;
  fs::path m_path;
  int m_fd = -1;
};

/// Writes into an existing file; a sentence about it names `shown`, the file that was asked for.
Result<void> writeInto(const fs::path& file, const fs::path& shown, std::string_view bytes) {
  Descriptor open(::open(file.c_str(), O_WRONLY | O_CLOEXEC));
  if (!open.valid() || !writeAll(open.get(), bytes) || !open.close()) return unwritable(shown, reason(errno));
  return {};
}

}  // namespace

Result<std::string> readFile(const fs::path& path, std::size_t maxBytes) {
  // Without O_NONBLOCK, opening a pipe that nobody writes to would wait forever.
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  if (!file.valid()) return unreadable(path, reason(errno));
  struct stat status {};
  if (::fstat(file.get(), &status) != 0) return unreadable(path, reason(errno));
  if (S_ISDIR(status.st_mode)) return unreadable(path, "it is a folder, not a file");
  ::fcntl(file.get(), F_SETFL, ::fcntl(file.get(), F_GETFL) & ~O_NONBLOCK);

  std::string bytes;
  std::string block(std::size_t{64} * 1024, '\0');
  if (S_ISREG(status.st_mode) && static_cast<std::size_t>(status.st_size) <= maxBytes)
    bytes.reserve(static_cast<std::size_t>(status.st_size));
  for (;;) {
    const ssize_t count = ::read(file.get(), block.data(), block.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return unreadable(path, reason(errno));
    if (count == 0) return bytes;
    if (bytes.size() + static_cast<std::size_t>(count) > maxBytes)
      return unreadable(path, "it is larger than the " + std::to_string(maxBytes) + " bytes allowed for such a file");
    bytes.append(block.data(), static_cast<std::size_t>(count));
  }
}

Result<void> replaceFileAtomically(const fs::path& path,
                                   const std::function<Result<void>(const fs::path& temporary)>& produce) {
  const fs::path target = throughLinks(path);
  struct stat replaced {};
  const bool replaces = ::stat(target.c_str(), &replaced) == 0;
  if (replaces && S_ISDIR(replaced.st_mode)) return unwritable(path, reason(EISDIR));
  if (replaces && !S_ISREG(replaced.st_mode)) return produce(target);
  if (replaces && ::access(target.c_str(), W_OK) != 0) return unwritable(path, "it is read-only");

  TemporaryFile temporary(target);
  if (!temporary.valid()) {
    const int error = errno;
    const std::string folder = target.has_parent_path() ? target.parent_path().string() : std::string("the folder");
    if (error == ENOENT) return unwritable(path, "the folder " + folder + " does not exist; make it first");
    if (error == EACCES || error == EROFS) return unwritable(path, folder + " is read-only");
    return unwritable(path, reason(error));
  }
  if (replaces) temporary.copyPermissions(replaced);
  if (auto produced = produce(temporary.path()); !produced) return produced;
  if (!temporary.commit()) return unwritable(path, reason(errno));
  return {};
}

Result<void> writeFileAtomically(const fs::path& path, std::string_view bytes) {
  return replaceFileAtomically(path, [&](const fs::path& file) { return writeInto(file, path, bytes); });
}

}  // namespace dermis
