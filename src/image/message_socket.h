// Sending and receiving whole messages over a socket, until a moment at the latest.
#pragma once
#include <chrono>
#include <cstddef>

namespace cg {

using Moment = std::chrono::steady_clock::time_point;

enum class Transfer { complete, closed, late };  // closed: the other side has gone

Transfer send_bytes(int socket, const void* bytes, std::size_t size, Moment latest);
Transfer receive_bytes(int socket, void* bytes, std::size_t size, Moment latest);

}  // namespace cg
