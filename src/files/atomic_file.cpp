#include "files/atomic_file.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <memory>
#include <system_error>

namespace sfw {
namespace {

[[noreturn]] void fail(const std::string& file, int error) {
  throw std::system_error(error, std::generic_category(), file + ": cannot be written");
}

/// A file under a temporary name that disappears again unless it is kept.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& target) : target_(target), name_(target + ".XXXXXX") {
    if (std::error_code error; std::filesystem::is_directory(target, error)) {
      fail(target_, EISDIR);  // otherwise the error would come after others are replaced
    }
    descriptor_ = mkstemp(name_.data());
    if (descriptor_ < 0) {
      fail(target_, errno);
    }
    fchmod(descriptor_, usualPermissions(0666));
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (descriptor_ >= 0) {
      close(descriptor_);
    }
    if (!kept_) {
      unlink(name_.c_str());
    }
  }

  void write(const std::string& bytes) {
    for (std::size_t written = 0; written < bytes.size();) {
      const ssize_t n = ::write(descriptor_, bytes.data() + written, bytes.size() - written);
      if (n < 0 && errno != EINTR) {
        fail(target_, errno);
      }
      written += n > 0 ? static_cast<std::size_t>(n) : 0;
    }
  }

  /// Makes sure that all bytes are on the disk.
  void finish() {
    if (fsync(descriptor_) != 0) {
      fail(target_, errno);
    }
    const int closed = close(descriptor_);
    descriptor_ = -1;
    if (closed != 0) {
      fail(target_, errno);
    }
  }

  void keep() {
    if (rename(name_.c_str(), target_.c_str()) != 0) {
      fail(target_, errno);
    }
    kept_ = true;
  }

 private:
  std::string target_;
  std::string name_;
  int descriptor_ = -1;
  bool kept_ = false;
};

}  // namespace

void writeAtomically(const std::string& file, const std::string& bytes) {
  writeAtomically({{file, bytes}});
}

void writeAtomically(const std::vector<std::pair<std::string, std::string>>& files) {
  std::vector<std::unique_ptr<TemporaryFile>> temporaries;
  for (const auto& [file, bytes] : files) {
    temporaries.push_back(std::make_unique<TemporaryFile>(file));
    temporaries.back()->write(bytes);
    temporaries.back()->finish();
  }
  for (const auto& temporary : temporaries) {
    temporary->keep();
  }
}

mode_t usualPermissions(mode_t all) {
  const mode_t mask = umask(0);
  umask(mask);
  return all & ~mask;
}

void makeDirectories(const std::string& directory) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) {
    throw std::system_error(error, directory + ": cannot be made");
  }
}

}  // namespace sfw
