#pragma once

#include <string>

namespace sfw {

/// Writes a file so that a reader sees the old one or the new one whole, never a part, whatever
/// fails on the way: under a temporary name in the same directory, synced, then renamed.
/// @throw std::system_error naming the file and why; nothing is left behind.
void writeAtomically(const std::string& file, const std::string& bytes);

/// Makes a directory and its parents. @throw std::system_error naming it and why.
void makeDirectories(const std::string& directory);

}  // namespace sfw
