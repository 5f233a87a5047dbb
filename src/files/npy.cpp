#include "files/npy.h"

#include <stdexcept>

namespace sfw {

static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "the header says little endian");

std::string npyOf(const std::array<std::size_t, 3>& shape, const std::vector<float>& values) {
  if (shape[0] * shape[1] * shape[2] != values.size()) {
    throw std::invalid_argument("an array must have as many values as its shape says");
  }
  constexpr std::size_t kAlignment = 64;  // of the values, as NumPy has it
  constexpr std::size_t kPrefix = 10;     // magic string, version and length of the header
  std::string header = "{'descr': '<f4', 'fortran_order': False, 'shape': (" +
                       std::to_string(shape[0]) + ", " + std::to_string(shape[1]) + ", " +
                       std::to_string(shape[2]) + "), }";
  while ((kPrefix + header.size() + 1) % kAlignment != 0) {
    header += ' ';
  }
  header += '\n';
  std::string bytes("\x93NUMPY\x01\x00", 8);
  bytes += static_cast<char>(header.size() & 0xff);
  bytes += static_cast<char>(header.size() >> 8);
  bytes += header;
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float));
  return bytes;
}

}  // namespace sfw
