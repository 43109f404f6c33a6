#include "exact/base/held_output.h"

#include <optional>

#include "exact/base/output.h"
#include "exact/base/spool.h"

namespace tribunal {

/// What can be renamed waits as the door's temporary file; all else in a spool.
class HeldOutput::Way {
 public:
  explicit Way(const std::string& path) : path_(path) {
    if (path != "-" && !is_special(path)) file_.emplace(path);
  }

  void write(std::string_view text) { file_ ? file_->write(text) : spool_.write(text); }

  void commit() {
    if (!file_) {
      file_.emplace(path_);
      spool_.for_each_piece([this](std::string_view piece) { file_->write(piece); });
    }
    file_->commit();
  }

 private:
  std::string path_;
  std::optional<OutputFile> file_{};
  Spool spool_{};
};

HeldOutput::HeldOutput(const std::string& path) : way_(std::make_unique<Way>(path)) {}
HeldOutput::~HeldOutput() = default;
void HeldOutput::write(std::string_view text) { way_->write(text); }
void HeldOutput::commit() { way_->commit(); }

}  // namespace tribunal
