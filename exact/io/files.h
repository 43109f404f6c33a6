// Reading whole files and writing them so that a reader never meets half of one.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tribunal {

/// The bytes of a file, or of standard input for "-". Fails with Exit::bad_input: missing, a directory, unreadable,
/// larger than `limit` bytes.
std::string read_file(const std::string& path, std::size_t limit = std::size_t{1} << 32);

/// Writes to a temporary name beside `path` and renames; "-" is standard output. Fails with Exit::output_failed.
void write_file(const std::string& path, std::string_view bytes);

/// Creates the directory and its parents. Fails with Exit::output_failed.
void make_directory(const std::string& path);

/// Writes to standard output and checks that it arrived. Fails with Exit::output_failed.
void print(std::string_view text);

/// Fails with Exit::usage if the two paths name the same existing file.
void require_different(const std::string& input, const std::string& output);

}  // namespace tribunal
