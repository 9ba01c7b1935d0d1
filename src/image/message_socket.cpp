#include "image/message_socket.h"

#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>

namespace cg {

namespace {

// Waits until the socket is ready for `event`. False when it is too late.
bool wait_for(int socket, short event, Moment latest) {
  using namespace std::chrono;
  for (;;) {
    int wait = -1;
    if (latest != Moment::max()) {
      const auto left = ceil<milliseconds>(latest - steady_clock::now()).count();
      if (left <= 0) return false;
      wait = int(std::min<long long>(left, 1'000'000));
    }
    pollfd p{socket, event, 0};
    const int ready = ::poll(&p, 1, wait);
    if (ready > 0 || (ready < 0 && errno != EINTR)) return true;  // a fault shows when it is used
  }
}

// `move` moves some of `size` bytes without waiting, as send and recv do.
template <class Move>
Transfer move_all(int socket, short event, std::size_t size, Moment latest, Move move) {
  std::size_t done = 0;
  while (done < size) {
    const ssize_t n = move(done, size - done);
    if (n > 0) {
      done += std::size_t(n);
    } else if (n < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) {
      if (!wait_for(socket, event, latest)) return Transfer::late;
    } else if (n == 0 || errno != EINTR) {
      return Transfer::closed;
    }
  }
  return Transfer::complete;
}

}  // namespace

Transfer send_bytes(int socket, const void* bytes, std::size_t size, Moment latest) {
  return move_all(socket, POLLOUT, size, latest, [&](std::size_t at, std::size_t n) {
    return ::send(socket, static_cast<const char*>(bytes) + at, n, MSG_NOSIGNAL | MSG_DONTWAIT);
  });
}

Transfer receive_bytes(int socket, void* bytes, std::size_t size, Moment latest) {
  return move_all(socket, POLLIN, size, latest, [&](std::size_t at, std::size_t n) {
    return ::recv(socket, static_cast<char*>(bytes) + at, n, MSG_DONTWAIT);
  });
}

}  // namespace cg
