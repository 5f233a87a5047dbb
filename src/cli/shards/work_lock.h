#pragma once

#include <functional>
#include <string>

#include "cli/shards/shard.h"

namespace sfw {

/// Keeps two workers from making one shard in one directory. The kernel releases the lock when the
/// process ends, however it ends.
///
/// Works over NFS. Where files cannot be locked, a warning says so. Workers are safe there too,
/// since they write under names of their own and rename, but a doubled shard wastes its time.
class WorkLock {
 public:
  /// @param directory  of the output; made if it is missing
  /// @param clean      removes what killed workers left; called if no other worker is at work
  /// @throw InputError if another worker makes the shard; std::system_error if the directory or
  /// the lock's file cannot be made
  WorkLock(const std::string& directory, const Shard& shard, const std::function<void()>& clean);
  WorkLock(const WorkLock&) = delete;
  WorkLock& operator=(const WorkLock&) = delete;
  ~WorkLock();

 private:
  int descriptor_ = -1;
};

}  // namespace sfw
