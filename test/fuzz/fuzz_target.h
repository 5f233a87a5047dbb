#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "structure_from_wifi/input_error.h"

namespace sfw::fuzz {

/// Valid small inputs, from which the mutations start. Each target defines them.
std::vector<std::string> seeds();

/// Gives one input to the code under test. Each target defines it. Whatever ends the process,
/// leaves this function as an exception or breaks a `require` is a fault.
void feed(std::string_view input);

/// Ends the process, as a sanitizer would, if a property does not hold.
inline void require(bool holds) {
  if (!holds) {
    std::abort();
  }
}

/// Calls code that may refuse its input.
/// @return whether it took the input
template <class Code>
bool takes(Code&& code) {
  try {
    code();
    return true;
  } catch (const InputError& error) {
    require(!std::string_view(error.what()).empty());
    return false;
  }
}

/// The parts of an input that stands for several files; missing ones are empty.
inline std::vector<std::string> parts(std::string_view input, std::size_t count) {
  constexpr std::string_view kBetween = "\n=====\n";
  std::vector<std::string> parts(count);
  for (std::string& part : parts) {
    const std::size_t end = input.find(kBetween);
    part = input.substr(0, end);
    if (end == std::string_view::npos) {
      break;
    }
    part += '\n';
    input.remove_prefix(end + kBetween.size());
  }
  return parts;
}

/// Files of one input, in memory where the system has a folder for that.
class InputFolder {
 public:
  InputFolder() {
    std::error_code error;
    const std::filesystem::path memory = "/dev/shm";
    std::string name =
        ((std::filesystem::is_directory(memory, error) ? memory
                                                       : std::filesystem::temp_directory_path()) /
         "sfw_fuzz_XXXXXX")
            .string();
    require(mkdtemp(name.data()) != nullptr);
    folder_ = name;
  }
  ~InputFolder() {
    std::error_code error;
    std::filesystem::remove_all(folder_, error);
  }
  InputFolder(const InputFolder&) = delete;
  InputFolder& operator=(const InputFolder&) = delete;

  std::string path() const { return folder_.string(); }

  /// @return the path of the file
  std::string write(const std::string& name, std::string_view bytes) const {
    const std::string file = (folder_ / name).string();
    std::ofstream(file, std::ios::binary) << bytes;
    return file;
  }

 private:
  std::filesystem::path folder_;
};

}  // namespace sfw::fuzz
