// A locale with a decimal comma, whatever the machine has installed: made by localedef, which is part of the C
// library's package.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <clocale>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace tribunal {

/// While it lives, the C library writes and reads numbers with a comma. `speaks()` says whether it does: a test asserts
/// it.
class CommaLocale {
 public:
  CommaLocale()
      : before_(std::setlocale(LC_ALL, nullptr)),
        folder_(::testing::TempDir() + "locales-" + std::to_string(getpid())) {
    std::filesystem::create_directories(folder_);
    std::ofstream(folder_ + "/comma.def")
        << "LC_NUMERIC\ndecimal_point \",\"\nthousands_sep \".\"\ngrouping 3\nEND LC_NUMERIC\n";
    // It warns of the categories that are not defined, and says so by its exit code.
    const std::string make = "localedef -c -i " + folder_ + "/comma.def " + folder_ + "/comma >/dev/null 2>&1";
    [[maybe_unused]] const int warned = std::system(make.c_str());
    setenv("LOCPATH", folder_.c_str(), 1);
    speaks_ = std::setlocale(LC_NUMERIC, "comma") != nullptr && *std::localeconv()->decimal_point == ',';
  }
  ~CommaLocale() {
    std::setlocale(LC_ALL, before_.c_str());
    unsetenv("LOCPATH");
    std::filesystem::remove_all(folder_);
  }
  CommaLocale(const CommaLocale&) = delete;
  CommaLocale& operator=(const CommaLocale&) = delete;

  bool speaks() const { return speaks_; }

 private:
  const std::string before_, folder_;
  bool speaks_ = false;
};

}  // namespace tribunal
