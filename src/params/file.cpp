#include "params/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <new>
#include <system_error>

#include "params/input_error.h"

namespace cg {

namespace {

namespace fs = std::filesystem;

// A descriptor that is closed when it goes.
struct Descriptor {
  int fd = -1;
  explicit Descriptor(int f) : fd(f) {}
  ~Descriptor() {
    if (fd >= 0) ::close(fd);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
};

InputError not_read(const fs::path& file, int error) {
  const Text why = system_text(error);
  return InputError(file.string(), {"cannot be read: " + why.en, "読めません：" + why.ja});
}

InputError not_saved(const fs::path& file, int error) {
  const Text why = system_text(error);
  return InputError(file.string(), {"not saved: " + why.en, "保存できません：" + why.ja},
                    {"a file that was there is unchanged", "元のファイルは変わっていません"});
}

// A link's target, so that the rename replaces the file and not the link.
fs::path behind_links(const fs::path& file) {
  std::error_code none;
  const fs::path target = fs::canonical(file, none);
  return none ? file : target;
}

// A new file in the folder of `target`; `name` becomes its path. The name is short, so that a target whose name has the
// greatest length can be saved too.
int open_beside(const fs::path& target, std::string& name) {
  static std::atomic<unsigned> count{0};
  for (int attempt = 0; attempt < 100; ++attempt) {
    const std::string own = ".shadebench-" + std::to_string(::getpid()) + "-" + std::to_string(count++);
    name = (target.parent_path() / own).string();
    const int fd = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (fd >= 0 || errno != EEXIST) return fd;
  }
  return -1;
}

int write_all(int fd, std::string_view bytes) {
  constexpr std::size_t most = std::size_t(1) << 30;  // of one write()
  while (!bytes.empty()) {
    const ssize_t n = ::write(fd, bytes.data(), std::min(bytes.size(), most));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return errno;
    if (n == 0) return ENOSPC;
    bytes.remove_prefix(std::size_t(n));
  }
  return 0;
}

// Makes a rename durable; a file system that cannot is no reason to fail.
void flush_folder(const fs::path& file) {
  const fs::path folder = file.parent_path();
  const Descriptor d(::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (d.fd >= 0) ::fsync(d.fd);
}

}  // namespace

Text system_text(int error) {
  switch (error) {
    case ENOENT:
      return {"no such file or folder", "ファイルまたはフォルダがありません"};
    case ENOTDIR:
      return {"a part of the path is not a folder", "パスの途中がフォルダではありません"};
    case EACCES:
    case EPERM:
      return {"permission denied", "許可がありません"};
    case EISDIR:
      return {"it is a folder", "フォルダです"};
    case ENOSPC:
      return {"the disk is full", "ディスクがいっぱいです"};
    case EDQUOT:
      return {"the disk quota is used up", "ディスクの割り当てを使い切りました"};
    case EFBIG:
      return {"larger than a file may be here", "ファイルの大きさの上限を超えます"};
    case EROFS:
      return {"the disk is read-only", "読み取り専用のディスクです"};
    case ENAMETOOLONG:
      return {"the name is too long", "名前が長すぎます"};
    case ELOOP:
      return {"too many symbolic links", "シンボリックリンクが多すぎます"};
    case ENOMEM:
      return {"not enough memory", "メモリが足りません"};
    case EIO:
      return {"the disk reports an error", "ディスクにエラーがあります"};
    default: {
      const std::string text = std::generic_category().message(error);
      return {text, text};
    }
  }
}

std::string read_file(const fs::path& file, std::size_t max_bytes) {
  // O_NONBLOCK: opening a pipe must not wait for a writer.
  const Descriptor d(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (d.fd < 0) throw not_read(file, errno);
  struct stat status {};
  if (::fstat(d.fd, &status) != 0) throw not_read(file, errno);
  if (S_ISDIR(status.st_mode)) throw not_read(file, EISDIR);
  if (!S_ISREG(status.st_mode))
    throw InputError(file.string(), {"is a pipe or a device", "パイプかデバイスです"},
                     {"an ordinary file is needed", "通常のファイルが必要です"});
  const auto too_large = [&] {
    const std::string limit = std::to_string(max_bytes >> 20) + " MiB";
    return InputError(file.string(), {"is larger than " + limit, limit + " を超えています"});
  };
  if (std::size_t(status.st_size) > max_bytes) throw too_large();
  try {
    std::string bytes(std::size_t(status.st_size), '\0');
    std::size_t size = 0;
    for (;;) {  // to its end, even where it grows or shrinks meanwhile
      if (size == bytes.size()) bytes.resize(size + 4096);
      const ssize_t n = ::read(d.fd, bytes.data() + size, bytes.size() - size);
      if (n < 0 && errno == EINTR) continue;
      if (n < 0) throw not_read(file, errno);
      if (n == 0) break;
      size += std::size_t(n);
      if (size > max_bytes) throw too_large();
    }
    bytes.resize(size);
    return bytes;
  } catch (const std::bad_alloc&) {
    throw not_read(file, ENOMEM);
  }
}

void save_file(const fs::path& file, std::string_view bytes) {
  const fs::path target = behind_links(file);
  struct stat old {};
  const bool exists = ::stat(target.c_str(), &old) == 0;
  if (exists && S_ISDIR(old.st_mode)) throw not_saved(file, EISDIR);
  if (exists && !S_ISREG(old.st_mode))
    throw InputError(file.string(), {"not saved: it is a pipe or a device", "保存できません：パイプかデバイスです"},
                     {"name an ordinary file", "通常のファイルを指定してください"});
  if (exists && ::access(target.c_str(), W_OK) != 0) throw not_saved(file, errno);

  std::string beside;
  const Descriptor d(open_beside(target, beside));
  if (d.fd < 0) throw not_saved(file, errno);
  int error = exists && ::fchmod(d.fd, old.st_mode & 0777) != 0 ? errno : 0;
  if (!error) error = write_all(d.fd, bytes);
  if (!error && ::fsync(d.fd) != 0) error = errno;
  if (!error && ::rename(beside.c_str(), target.c_str()) != 0) error = errno;
  if (error) {
    ::unlink(beside.c_str());
    throw not_saved(file, error);
  }
  flush_folder(target);
}

}  // namespace cg
