// shadebench-images: reads and writes image files for Shadebench, which starts it (image/image_program.h) and talks to
// it over the socket that is its standard input and output (image/image_protocol.h). It opens no file: bytes come and
// go over the socket, so a file that breaks a reader breaks this program and nothing else.
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <new>
#include <optional>
#include <vector>

#include "image/images_program/decode.h"
#include "image/images_program/encode.h"
#include "image/message_socket.h"

namespace {

using namespace cg;
using namespace cg::images_program;

constexpr rlim_t max_memory = rlim_t(2) << 30;  // of address space
constexpr unsigned orphan_seconds = 60;         // the application gives up much earlier, unless it has gone

// The address sanitizer reserves more address space than any limit.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool limited = false;
#elif defined(__has_feature)
constexpr bool limited = !__has_feature(address_sanitizer);
#else
constexpr bool limited = true;
#endif

void limit_memory() {
  const rlimit memory{max_memory, max_memory};
  if (limited) ::setrlimit(RLIMIT_AS, &memory);
}

[[noreturn]] void leave() { ::_exit(0); }  // without OpenImageIO's exit handlers, which have been seen to hang

// The conversation. The application's end is this program's end.
class Socket {
 public:
  explicit Socket(int fd) : fd_(fd) {}
  void receive(void* bytes, std::size_t size) {
    if (receive_bytes(fd_, bytes, size, Moment::max()) != Transfer::complete) leave();
  }
  Header receive_header() {
    Header header{};
    receive(&header, sizeof header);
    return header;
  }
  // Takes what follows a header and forgets it.
  void skip(std::uint64_t size) {
    char bytes[4096];
    for (; size > 0; size -= std::min<std::uint64_t>(size, sizeof bytes))
      receive(bytes, std::size_t(std::min<std::uint64_t>(size, sizeof bytes)));
  }
  void send(Kind kind, std::uint32_t value, const void* body, std::size_t size) {
    const Header header{kind, value, size};
    if (send_bytes(fd_, &header, sizeof header, Moment::max()) != Transfer::complete) leave();
    if (send_bytes(fd_, body, size, Moment::max()) != Transfer::complete) leave();
  }
  void fail(const Refused& refused) {
    const std::string_view detail = refused.what();
    send(Kind::failed, std::uint32_t(refused.failure), detail.data(), std::min(detail.size(), max_detail));
  }

 private:
  int fd_;
};

// What goes wrong in f, if anything.
template <class F>
std::optional<Refused> fault_of(Failure otherwise, F f) {
  try {
    f();
    return {};
  } catch (const Refused& refused) {
    return refused;
  } catch (const std::bad_alloc&) {
    return Refused(Failure::memory, "");
  } catch (const std::exception& e) {
    return Refused(otherwise, e.what());
  }
}

void serve_decode(Socket& socket, const Header& request) {
  if (request.size > max_file) leave();
  ::alarm(orphan_seconds);
  std::vector<char> bytes;
  const auto fault = fault_of(Failure::pixels, [&] {
    bytes.resize(std::size_t(request.size));
    socket.receive(bytes.data(), bytes.size());
    const DecodeSink sink{
        [&](const PictureHeader& p) { socket.send(Kind::picture, 0, &p, sizeof p); },
        [&](int y, const float* rows, std::size_t size) { socket.send(Kind::rows, std::uint32_t(y), rows, size); }};
    const bool with_pixels = request.kind == Kind::decode;
    const DoneTail tail{decode(ImageFormat(request.value), {bytes.data(), bytes.size()}, with_pixels, sink)};
    socket.send(Kind::done, 0, &tail, sizeof tail);
  });
  if (bytes.empty() && request.size > 0) socket.skip(request.size);  // there was no room for them
  if (fault) socket.fail(*fault);
  ::alarm(0);
}

// All rows are taken even where something failed: the answer comes when the application has finished speaking.
void serve_encode(Socket& socket, const Header& request) {
  EncodeOrder order{};
  if (request.size != sizeof order) leave();
  socket.receive(&order, sizeof order);
  std::optional<Encoder> encoder;
  std::optional<Refused> fault;
  const auto attempt = [&](auto step) {
    if (!fault) fault = fault_of(Failure::encoding, step);
  };
  attempt([&] { encoder.emplace(order); });
  std::vector<char> rows;
  for (Header header = socket.receive_header(); header.kind != Kind::end; header = socket.receive_header()) {
    if (header.kind != Kind::rows) leave();
    attempt([&] { rows.resize(std::size_t(header.size)); });
    if (fault) {
      socket.skip(header.size);
      continue;
    }
    socket.receive(rows.data(), rows.size());
    attempt([&] { encoder->add_rows(int(header.value), rows.data(), rows.size()); });
  }
  attempt([&] {
    const std::vector<unsigned char>& file = encoder->finish();
    socket.send(Kind::encoded, 0, file.data(), file.size());
  });
  if (fault) socket.fail(*fault);
}

}  // namespace

int main() {
  // The conversation gets a descriptor of its own: what a library prints must not end up in it.
  const int conversation = ::fcntl(0, F_DUPFD_CLOEXEC, 3);
  const int nowhere = ::open("/dev/null", O_RDWR | O_CLOEXEC);
  if (conversation < 0 || nowhere < 0 || ::dup2(nowhere, 0) < 0) return 1;
  int type = 0;
  socklen_t size = sizeof type;
  if (::getsockopt(conversation, SOL_SOCKET, SO_TYPE, &type, &size) != 0) {
    std::fputs("shadebench-images is started by shadebench, which reads and writes images through it.\n", stderr);
    return 2;
  }
  ::dup2(nowhere, 1);
  ::signal(SIGPIPE, SIG_IGN);
  limit_memory();
  const rlimit no_core{0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
  configure();

  Socket socket(conversation);
  socket.send(Kind::ready, 0, nullptr, 0);
  for (;;) {
    const Header request = socket.receive_header();
    switch (request.kind) {
      case Kind::decode:
      case Kind::inspect:
        serve_decode(socket, request);
        break;
      case Kind::encode:
        serve_encode(socket, request);
        break;
      default:
        leave();
    }
  }
}
