// The program shadebench-images, which reads and writes image files for the application: started at the first request,
// kept, killed when it takes too long, and started again when it has ended. Its libraries need half a second to load
// and can be crashed by a file; this way neither reaches the application.
#pragma once
#include <sys/types.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <mutex>
#include <string>

#include "image/image_protocol.h"
#include "image/message_socket.h"

namespace cg {

class ImageProgram {
 public:
  // `program`: where it lies; empty: in SHADEBENCH_IMAGES, beside the running program or in the folder above it.
  // `limit`: how long a file may take; the program's start, whose libraries may come from a cold disk, has six times
  // as long and does not count. Starts nothing yet.
  explicit ImageProgram(std::filesystem::path program = {}, std::chrono::milliseconds limit = std::chrono::seconds(10));
  ~ImageProgram();
  ImageProgram(const ImageProgram&) = delete;
  ImageProgram& operator=(const ImageProgram&) = delete;

  // The one that the application uses.
  static ImageProgram& shared();

  // Of the running program, -1 where none runs.
  pid_t pid() const { return pid_; }

 private:
  friend class ImageConversation;
  void start(const std::string& file);
  void stop();

  std::filesystem::path program_;
  std::chrono::milliseconds limit_;
  std::mutex one_at_a_time_;
  std::atomic<pid_t> pid_{-1};
  int socket_ = -1;
  bool ready_ = false;  // its libraries are loaded
};

// One request and its answer; others wait until it is over. Unless finish() was called the program is stopped at the
// end, as it may be in the middle of something. Every function throws InputError that names `file`.
class ImageConversation {
 public:
  // `pixels_to_write` lengthens the limit for large pictures of our own.
  ImageConversation(ImageProgram& program, std::string file, std::int64_t pixels_to_write = 0);
  ~ImageConversation();
  ImageConversation(const ImageConversation&) = delete;
  ImageConversation& operator=(const ImageConversation&) = delete;

  void send(image_protocol::Kind kind, std::uint32_t value, const void* body, std::size_t size);
  image_protocol::Header receive();  // throws also for `failed`, with its reason
  void receive_body(void* body, std::size_t size);
  void finish() { finished_ = true; }

  // What is thrown when the answer makes no sense.
  [[noreturn]] void misunderstood();

 private:
  void check(Transfer transfer);
  void begin_limit(std::chrono::milliseconds limit);
  image_protocol::Header receive_header();
  [[noreturn]] void throw_failure(const image_protocol::Header& header);

  ImageProgram& program_;
  std::unique_lock<std::mutex> lock_;
  std::string file_;
  std::chrono::milliseconds own_limit_;  // of the file
  std::chrono::milliseconds limit_;      // of what is awaited now
  Moment latest_;
  bool finished_ = false;
};

}  // namespace cg
