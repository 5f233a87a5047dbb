// The entry points that libFuzzer calls.
//
// Usage: NAME_fuzz --write-seeds=FOLDER      writes the valid inputs and ends
//        NAME_fuzz [OPTION]... [FOLDER]...   as libFuzzer; -help=1 lists its options

#include <cstdlib>
#include <string>

#include "fuzz_target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  sfw::fuzz::feed({reinterpret_cast<const char*>(data), size});
  return 0;
}

extern "C" int LLVMFuzzerInitialize(const int* count, char*** arguments) {
  const std::string option = "--write-seeds=";
  for (int i = 1; i < *count; ++i) {
    const std::string argument = (*arguments)[i];
    if (argument.compare(0, option.size(), option) == 0) {
      int number = 0;
      for (const std::string& seed : sfw::fuzz::seeds()) {
        const std::string file =
            argument.substr(option.size()) + "/seed_" + std::to_string(++number);
        std::ofstream(file, std::ios::binary) << seed;
      }
      std::exit(0);
    }
  }
  return 0;
}
