// Reading files and asking about them. What is written goes through exact/base/output.h.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tribunal {

/// The bytes of a file, or of standard input for "-". Fails with Exit::bad_input if it is missing, a
/// directory, unreadable or larger than `limit` bytes.
std::string read_file(const std::string& path, std::size_t limit = std::size_t{1} << 32);

/// Whether there is something of that name. Fails with Exit::bad_input where the system refuses to say, as it does of
/// names that are too long and of folders that may not be searched.
bool exists(const std::string& path);
bool is_directory(const std::string& path);
bool is_regular_file(const std::string& path);

/// The paths of what a directory holds, in order of names. Fails with Exit::bad_input if it is none, or unreadable.
std::vector<std::string> files_in(const std::string& directory);

/// The same of regular files there and in all directories below. Links to directories are not followed.
std::vector<std::string> files_below(const std::string& directory);

/// The file that this process runs; empty where the system does not say.
std::string program_file();

/// The path without links and "..", of what is there and of what would be.
std::string canonical_path(const std::string& path);

/// Writes to standard output and checks that it arrived. Fails with Exit::output_failed.
void print(std::string_view text);

/// Fails with Exit::usage if the two paths name the same existing file.
void require_different(const std::string& input, const std::string& output);

/// A file that a command will write, and the option that asks for it.
struct Output {
  std::string option, file;
};

/// Fails with Exit::usage, naming both options, if two of them would write one file. Names are compared as the file
/// system would resolve them: "./b.png" is "b.png", whether it exists or not.
void require_distinct(const std::vector<Output>& outputs);

}  // namespace tribunal
