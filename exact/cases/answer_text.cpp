#include "exact/cases/answer_text.h"

#include <algorithm>
#include <string_view>

#include "exact/classes/class_table.h"

namespace tribunal {
namespace {

/// The text in quotes, as JSON has it.
void append_quoted(std::string& text, std::string_view value) {
  const auto is_plain = [](char c) { return c >= ' ' && c <= '~' && c != '"' && c != '\\'; };
  if (!std::ranges::all_of(value, is_plain)) {
    text += Json(value).dump();
    return;
  }
  text += '"';
  text += value;
  text += '"';
}

/// An object as one line of text, without white space.
class AnswerLine {
 public:
  explicit AnswerLine(std::string& text) : text_(text) { text_ += '{'; }

  void word(std::string_view key, std::string_view value) {
    begin(key);
    append_quoted(text_, value);
  }
  void bit(std::string_view key, bool value) {
    begin(key);
    text_ += value ? '1' : '0';
  }
  void truth_value(std::string_view key, bool value) {
    begin(key);
    text_ += value ? "true" : "false";
  }
  void end() { text_ += "}\n"; }

 private:
  void begin(std::string_view key) {
    if (text_.back() != '{') text_ += ',';
    text_ += '"';
    text_ += key;
    text_ += "\":";
  }

  std::string& text_;
};

}  // namespace

void append_answer(std::string& lines, const Case& c, const Method& method, const Answer& answer) {
  AnswerLine line(lines);
  line.word("id", c.id);
  line.word("method", method.name);
  const bool answered = answer.status == Status::ok;
  if (answered) line.bit("hit", answer.hit);
  line.word("status", name_of(answer.status));
  if (is_fault(answer.status)) line.word("fault", fault_name(answer.status));
  if (is_fault(answer.status) && method.last_fault) line.word("detail", method.last_fault());
  if (answer.class_id != 0) line.word("class", class_name(answer.class_id));
  if (answered && answer.contact != Contact::unsaid) line.word("contact", name_of(answer.contact));
  if (answer.at != At::unsaid) line.word("at", name_of(answer.at));
  if (method.tells_side && answer.facing != Facing::unsaid) line.word("side", name_of(answer.facing));
  if (answer.stage != Stage::none) line.word("stage", name_of(answer.stage));
  const bool tells_planar = c.query.operands() == Operands::polygons && method.contract.polygons == Polygons::any;
  if (answered && tells_planar) line.truth_value("planar", answer.planar);
  line.end();
}

}  // namespace tribunal
