#include "exact/base/held_output.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "exact/base/failure.h"
#include "exact/base/files.h"
#include "exact/base/spool.h"

namespace tribunal {

/// All goes to a spool; commit() copies it.
class HeldOutput::Way {
 public:
  explicit Way(const std::string& path) : path_(path) {}

  void write(std::string_view text) { spool_.write(text); }

  void commit() {
    if (path_ == "-") return spool_.for_each_piece([](std::string_view piece) { print(piece); });
    if (is_special(path_)) return copy_to(path_);
    const std::string temporary = path_ + ".tmp" + std::to_string(getpid());
    try {
      copy_to(temporary);
      std::error_code error;
      std::filesystem::rename(temporary, path_, error);
      if (error) throw failed(error.value());
    } catch (...) {
      std::remove(temporary.c_str());
      throw;
    }
  }

 private:
  Failure failed(int error) const {
    return Failure(Exit::output_failed, path_ + ": cannot write: " + std::strerror(error));
  }

  void copy_to(const std::string& name) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> out(std::fopen(name.c_str(), "wb"), std::fclose);
    if (!out) throw failed(errno);
    spool_.for_each_piece([&](std::string_view piece) {
      if (std::fwrite(piece.data(), 1, piece.size(), out.get()) != piece.size()) throw failed(errno);
    });
    if (std::fflush(out.get()) != 0) throw failed(errno);
  }

  std::string path_;
  Spool spool_{};
};

HeldOutput::HeldOutput(const std::string& path) : way_(std::make_unique<Way>(path)) {}
HeldOutput::~HeldOutput() = default;
void HeldOutput::write(std::string_view text) { way_->write(text); }
void HeldOutput::commit() { way_->commit(); }

}  // namespace tribunal
