#pragma once

#include <sys/types.h>

#include <string>
#include <utility>
#include <vector>

namespace sfw {

/// Writes a file atomically: a reader gets the whole old file or the whole new one.
///
/// The bytes go to a temporary file in the same directory, which is synced and then renamed.
/// @throw std::system_error naming the file and why; nothing is left behind.
void writeAtomically(const std::string& file, const std::string& bytes);

/// Writes several files, each a name and its bytes. Old files stay until all new ones are complete,
/// so a full disk changes none of them.
void writeAtomically(const std::vector<std::pair<std::string, std::string>>& files);

/// Permissions without those that the process gives nobody, its umask. Temporary files are private
/// at first, but maps must be as readable as other files.
mode_t usualPermissions(mode_t all);

/// Makes a directory and its parents. @throw std::system_error naming it and why.
void makeDirectories(const std::string& directory);

}  // namespace sfw
