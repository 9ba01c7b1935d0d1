// Pixels to a file's bytes.
#pragma once
#include <memory>
#include <vector>

#include "image/images_program/plugin.h"

namespace cg::images_program {

class Encoder {
 public:
  // Throws Refused, as all of them.
  explicit Encoder(const EncodeOrder& order);
  // Rows from the top, one block after the other; `bytes` must be whole rows.
  void add_rows(int y, const void* rows, std::size_t bytes);
  // The file, after it was looked at as a reader would.
  const std::vector<unsigned char>& finish();

 private:
  EncodeOrder order_;
  std::vector<unsigned char> bytes_;
  OIIO::Filesystem::IOVecOutput proxy_{bytes_};
  std::unique_ptr<OIIO::ImageOutput> output_;
  int next_row_ = 0;
};

}  // namespace cg::images_program
