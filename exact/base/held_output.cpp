#include "exact/base/held_output.h"

#include "exact/base/files.h"

namespace tribunal {

class HeldOutput::Way {
 public:
  explicit Way(const std::string& path) : path_(path) {}
  void write(std::string_view text) { all_ += text; }
  void commit() { write_file(path_, all_); }

 private:
  std::string path_, all_{};
};

HeldOutput::HeldOutput(const std::string& path) : way_(std::make_unique<Way>(path)) {}
HeldOutput::~HeldOutput() = default;
void HeldOutput::write(std::string_view text) { way_->write(text); }
void HeldOutput::commit() { way_->commit(); }

}  // namespace tribunal
