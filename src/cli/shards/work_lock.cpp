#include "cli/shards/work_lock.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "cli/warnings.h"
#include "files/atomic_file.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

/// The byte that every worker locks: shared while it works, alone while it cleans.
constexpr off_t kPresence = 0;

/// The byte that the worker of a shard locks. Nobody reads or writes it.
off_t byteOf(const Shard& shard) {
  return static_cast<off_t>(shard.count * (kMostShards + 1) + shard.index);
}

/// @param type     F_WRLCK or F_RDLCK
/// @param command  F_SETLK, or F_SETLKW to wait
/// @return 0, or the error
int lockByte(int descriptor, short type, off_t byte, int command) {
  struct flock range {};
  range.l_type = type;
  range.l_whence = SEEK_SET;
  range.l_start = byte;
  range.l_len = 1;
  while (fcntl(descriptor, command, &range) != 0) {
    if (errno != EINTR) {
      return errno;
    }
  }
  return 0;
}

bool isHeldByAnother(int error) { return error == EAGAIN || error == EACCES; }

}  // namespace

WorkLock::WorkLock(const std::string& directory, const Shard& shard,
                   const std::function<void()>& clean) {
  makeDirectories(directory);
  const std::string file = directory + "/.lock";
  descriptor_ = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor_ < 0) {
    throw std::system_error(errno, std::generic_category(), file + ": cannot be written");
  }
  const int error = lockByte(descriptor_, F_WRLCK, byteOf(shard), F_SETLK);
  if (isHeldByAnother(error)) {
    close(descriptor_);
    throw InputError(directory + ": another worker makes " +
                     (shard.count == 1 ? "this list" : "shard " + toText(shard)) +
                     " there; wait for it or end it");
  }
  if (error != 0) {
    warn(file + ": cannot be locked (" + std::generic_category().message(error) +
         "); start no shard twice at a time");
    return;
  }
  if (lockByte(descriptor_, F_WRLCK, kPresence, F_SETLK) == 0) {
    clean();
  }
  lockByte(descriptor_, F_RDLCK, kPresence, F_SETLKW);
}

WorkLock::~WorkLock() { close(descriptor_); }

}  // namespace sfw
