#include "files/npy.h"

#include <gtest/gtest.h>

#include <cstring>
#include <stdexcept>

namespace sfw::test {
namespace {

TEST(Npy, HasTheHeaderOfNumPyAndTheValuesBehindIt) {
  const std::vector<float> values{1.0F, -2.0F, 0.5F, 4.0F, 5.0F, 6.0F};
  const std::string bytes = npyOf({1, 2, 3}, values);
  EXPECT_EQ(bytes.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
  const std::size_t header =
      static_cast<unsigned char>(bytes[8]) + 256U * static_cast<unsigned char>(bytes[9]);
  EXPECT_EQ((10 + header) % 64, 0U) << "NumPy aligns the values";
  EXPECT_EQ(bytes[10 + header - 1], '\n');
  EXPECT_NE(bytes.find("{'descr': '<f4', 'fortran_order': False, 'shape': (1, 2, 3), }"),
            std::string::npos);
  ASSERT_EQ(bytes.size(), 10 + header + values.size() * sizeof(float));
  std::vector<float> read(values.size());
  std::memcpy(read.data(), bytes.data() + 10 + header, values.size() * sizeof(float));
  EXPECT_EQ(read, values);
}

TEST(Npy, RefusesAShapeThatDoesNotFit) {
  EXPECT_THROW(npyOf({1, 2, 2}, {1.0F, 2.0F}), std::invalid_argument);
}

}  // namespace
}  // namespace sfw::test
