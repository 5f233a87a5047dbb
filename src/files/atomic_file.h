#pragma once

#include <string>
#include <utility>
#include <vector>

namespace sfw {

/// Writes a file so that a reader sees the old one or the new one whole, never a part, whatever
/// fails on the way: under a temporary name in the same directory, synced, then renamed.
/// @throw std::system_error naming the file and why; nothing is left behind.
void writeAtomically(const std::string& file, const std::string& bytes);

/// As above for several files, each a name and its bytes: no old one is replaced before all new
/// ones are written whole, so that a full disk leaves them all as they were.
void writeAtomically(const std::vector<std::pair<std::string, std::string>>& files);

/// Makes a directory and its parents. @throw std::system_error naming it and why.
void makeDirectories(const std::string& directory);

}  // namespace sfw
