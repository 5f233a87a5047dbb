#include "cli/hash.h"

#include <filesystem>
#include <fstream>

#include "files/text.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {

std::uint64_t hashOf(const std::string& bytes, std::uint64_t seed) {
  constexpr std::uint64_t kPrime = 0x100000001b3ULL;
  for (const char byte : bytes) {
    seed = (seed ^ static_cast<unsigned char>(byte)) * kPrime;
  }
  return seed;
}

std::uint64_t hashOfFile(const std::string& file) {
  constexpr std::size_t kBlock = 1U << 20U;
  std::ifstream input(file, std::ios::binary);
  std::string block(kBlock, '\0');
  std::uint64_t hash = hashOf("");
  while (input.read(block.data(), kBlock) || input.gcount() > 0) {
    hash = hashOf(block.substr(0, static_cast<std::size_t>(input.gcount())), hash);
  }
  if (!input.eof() || std::filesystem::is_directory(file)) {
    throw InputError(file + ": cannot be read");
  }
  return hash;
}

std::uint64_t hashOfProgram() { return hashOf(readFile("/proc/self/exe")); }

std::string hexText(std::uint64_t hash) {
  return formatted("%016llx", static_cast<unsigned long long>(hash));
}

}  // namespace sfw
