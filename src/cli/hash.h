#pragma once

#include <cstdint>
#include <string>

namespace sfw {

/// The FNV-1a hash of 64 bits. `seed` continues an earlier hash. It finds damage and differences,
/// not forgeries.
std::uint64_t hashOf(const std::string& bytes, std::uint64_t seed = 0xcbf29ce484222325ULL);

/// The hash of a file's bytes; the file may be larger than the memory.
/// @throw InputError naming it if it cannot be read.
std::uint64_t hashOfFile(const std::string& file);

/// The hash of the running program, which contains the whole mapper. Another build may give other
/// results.
std::uint64_t hashOfProgram();

/// A hash as 16 hexadecimal digits.
std::string hexText(std::uint64_t hash);

}  // namespace sfw
