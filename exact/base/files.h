// Reading whole files, and writing them so that no reader sees a file half written.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tribunal {

/// The bytes of a file, or of standard input for "-". Fails with Exit::bad_input if it is missing, a
/// directory, unreadable or larger than `limit` bytes.
std::string read_file(const std::string& path, std::size_t limit = std::size_t{1} << 32);

/// Whether the path names a device or a pipe, which is written in place and has no contents to lose.
bool is_special(const std::string& path);

/// Writes to a temporary name beside `path` and renames; "-" is standard output. Fails with Exit::output_failed; the
/// message names `path`, not the temporary name. Like print, fails first where the floating-point environment has
/// changed (fp_environment.h).
void write_file(const std::string& path, std::string_view bytes);

/// Creates the directory and its parents. Fails with Exit::output_failed.
void make_directory(const std::string& path);

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
