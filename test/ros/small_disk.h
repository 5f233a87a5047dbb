#pragma once

#include <sys/mount.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <utility>

namespace sfw {

/// A disk in memory that is full soon. It needs root.
class SmallDisk {
 public:
  SmallDisk(std::filesystem::path folder, std::size_t bytes) : folder_(std::move(folder)) {
    std::filesystem::create_directories(folder_);
    const std::string size = "size=" + std::to_string(bytes);
    mounted_ = mount("tmpfs", folder_.c_str(), "tmpfs", 0, size.c_str()) == 0;
  }
  ~SmallDisk() {
    if (mounted_) {
      umount2(folder_.c_str(), MNT_DETACH);
    }
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

  bool isMounted() const { return mounted_; }

  /// Leaves no byte free.
  void fill() const {
    std::ofstream file(folder_ / kFiller, std::ios::binary);
    const std::string block(4096, 'x');
    while (file.write(block.data(), static_cast<std::streamsize>(block.size())).flush()) {
    }
  }

  void clear() const { std::filesystem::remove(folder_ / kFiller); }

 private:
  static constexpr char kFiller[] = "filler";
  std::filesystem::path folder_;
  bool mounted_ = false;
};

/// All files below a folder, with their content.
inline std::map<std::filesystem::path, std::string> contentOf(const std::filesystem::path& folder) {
  std::map<std::filesystem::path, std::string> content;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    std::ifstream stream(entry.path(), std::ios::binary);
    content[entry.path()] = {std::istreambuf_iterator<char>(stream), {}};
  }
  return content;
}

}  // namespace sfw
