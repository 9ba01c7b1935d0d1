#include "image/image_program.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/auxv.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>

#include "params/file.h"
#include "params/input_error.h"

extern char** environ;

namespace cg {

using namespace image_protocol;

namespace {

namespace fs = std::filesystem;

fs::path running_program() {
  std::error_code none;
  const fs::path path = fs::read_symlink("/proc/self/exe", none);
  if (!none) return path;
  const char* name = reinterpret_cast<const char*>(::getauxval(AT_EXECFN));
  return name ? fs::absolute(name, none) : fs::path();
}

fs::path find_program() {
  if (const char* named = std::getenv("SHADEBENCH_IMAGES"); named && *named) return named;
  const fs::path folder = running_program().parent_path();
  for (const fs::path& candidate : {folder / "shadebench-images", folder.parent_path() / "shadebench-images"})
    if (::access(candidate.c_str(), X_OK) == 0) return candidate;
  return folder / "shadebench-images";
}

// Runs `program` with its standard input and output being `socket`, and says nothing on standard error: the libraries
// print there what reaches the user as one line anyway. An errno, or 0.
int spawn(const fs::path& program, int socket, pid_t& pid) {
  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawnattr_init(&attributes);
  ::posix_spawn_file_actions_adddup2(&actions, socket, 0);
  ::posix_spawn_file_actions_adddup2(&actions, socket, 1);
  ::posix_spawn_file_actions_addopen(&actions, 2, "/dev/null", O_WRONLY, 0);
  // A group of its own: Ctrl-C at the terminal is for the application, whose end it notices.
  sigset_t none, all;
  ::sigemptyset(&none);
  ::sigfillset(&all);
  ::posix_spawnattr_setsigmask(&attributes, &none);
  ::posix_spawnattr_setsigdefault(&attributes, &all);
  ::posix_spawnattr_setpgroup(&attributes, 0);
  ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
  std::string name = program.string();
  char* arguments[] = {name.data(), nullptr};
  const int error = ::posix_spawn(&pid, name.c_str(), &actions, &attributes, arguments, environ);
  ::posix_spawnattr_destroy(&attributes);
  ::posix_spawn_file_actions_destroy(&actions);
  return error;
}

struct Reason {
  Failure failure;
  Words found, accepted;
};
constexpr Words damaged{"the file is damaged or cut short", "ファイルが壊れているか途中で切れています"};
constexpr Reason reasons[] = {
    {Failure::header, {"its header is not valid", "ヘッダーが正しくありません"}, damaged},
    {Failure::too_large,
     {"the picture is too large", "画像が大きすぎます"},
     {"at most 256 megapixels, 1048576 pixels a side, 16 channels and 512 MB are read",
      "256 メガピクセル・一辺 1048576・16 チャンネル・512 MB まで読めます"}},
    {Failure::variant,
     {"this variant of the format is not read", "この形式の変種は読めません"},
     {"save it as RGB in scanlines", "走査線形式の RGB で保存してください"}},
    {Failure::pixels, {"its pixels cannot be decoded", "画素を復号できません"}, damaged},
    {Failure::memory, {"it needs more memory than an image may", "画像に許されるメモリでは足りません"}, {}},
    {Failure::encoding, {"not saved: the picture could not be encoded", "保存できません：画像を符号化できません"}, {}},
};

}  // namespace

ImageProgram::ImageProgram(fs::path program, std::chrono::milliseconds limit)
    : program_(std::move(program)), limit_(limit) {}

ImageProgram::~ImageProgram() { stop(); }

ImageProgram& ImageProgram::shared() {
  static ImageProgram program;
  return program;
}

void ImageProgram::start(const std::string& file) {
  if (pid_ > 0 && ::waitpid(pid_, nullptr, WNOHANG) == 0) return;
  stop();
  if (program_.empty()) program_ = find_program();
  const auto cannot = [&](int error) {
    const Text why = system_text(error);
    const std::string name = program_.string();
    return InputError(file, {name + " does not start: " + why.en, name + " が起動しません：" + why.ja},
                      {"it is built with the program; SHADEBENCH_IMAGES can name it",
                       "本体と共にビルドされます。環境変数 SHADEBENCH_IMAGES でも指定できます"});
  };
  int ends[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) throw cannot(errno);
  pid_t pid = -1;
  const int error = spawn(program_, ends[1], pid);
  ::close(ends[1]);
  if (error) {
    ::close(ends[0]);
    throw cannot(error);
  }
  socket_ = ends[0];
  ready_ = false;
  pid_ = pid;
}

void ImageProgram::stop() {
  if (socket_ >= 0) ::close(socket_);
  socket_ = -1;
  const pid_t pid = pid_.exchange(-1);
  if (pid <= 0) return;
  ::kill(pid, SIGKILL);  // also one that was stopped; it holds nothing that could be lost
  while (::waitpid(pid, nullptr, 0) < 0 && errno == EINTR) {
  }
}

ImageConversation::ImageConversation(ImageProgram& program, std::string file, std::int64_t pixels_to_write)
    : program_(program), lock_(program.one_at_a_time_), file_(std::move(file)) {
  program.start(file_);
  const auto limit = program.limit_ * (1 + pixels_to_write / (std::int64_t(16) << 20));
  begin_limit(program.ready_ ? limit : limit + 6 * program.limit_);
  own_limit_ = limit;
}

void ImageConversation::begin_limit(std::chrono::milliseconds limit) {
  limit_ = limit;
  latest_ = std::chrono::steady_clock::now() + limit;
}

ImageConversation::~ImageConversation() {
  if (!finished_) program_.stop();
}

void ImageConversation::check(Transfer transfer) {
  if (transfer == Transfer::late) {
    const std::string seconds = std::to_string(std::max<long long>(1, limit_.count() / 1000));
    throw InputError(file_, {"the image took longer than " + seconds + " s and was given up",
                             "画像の処理が " + seconds + " 秒を超えたため中止しました"});
  }
  if (transfer == Transfer::closed)
    throw InputError(file_, {"the program for images ended over it", "画像用のプログラムが途中で終了しました"},
                     {"it starts again with the next image", "次の画像で再び起動します"});
}

void ImageConversation::send(Kind kind, std::uint32_t value, const void* body, std::size_t size) {
  const Header header{kind, value, size};
  check(send_bytes(program_.socket_, &header, sizeof header, latest_));
  check(send_bytes(program_.socket_, body, size, latest_));
}

Header ImageConversation::receive_header() {
  Header header{};
  if (std::chrono::steady_clock::now() > latest_) check(Transfer::late);
  check(receive_bytes(program_.socket_, &header, sizeof header, latest_));
  return header;
}

Header ImageConversation::receive() {
  if (!program_.ready_) {
    if (receive_header().kind != Kind::ready) misunderstood();
    program_.ready_ = true;
    begin_limit(own_limit_);
  }
  const Header header = receive_header();
  if (header.kind == Kind::failed) throw_failure(header);
  return header;
}

void ImageConversation::receive_body(void* body, std::size_t size) {
  check(receive_bytes(program_.socket_, body, size, latest_));
}

void ImageConversation::misunderstood() { check(Transfer::closed), std::abort(); }

void ImageConversation::throw_failure(const Header& header) {
  if (header.size > max_detail) misunderstood();
  std::string detail(std::size_t(header.size), '\0');
  receive_body(detail.data(), detail.size());
  for (const Reason& reason : reasons) {
    if (std::uint32_t(reason.failure) != header.value) continue;
    finish();
    const std::string bracket = detail.empty() ? "" : " (" + detail + ")";
    throw InputError(file_, {std::string(reason.found.en) + bracket, std::string(reason.found.ja) + bracket},
                     reason.accepted);
  }
  misunderstood();
}

}  // namespace cg
