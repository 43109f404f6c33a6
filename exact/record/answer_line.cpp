#include "exact/record/answer_line.h"

#include <initializer_list>

#include "exact/base/fault.h"
#include "exact/base/foreign_json.h"
#include "exact/base/record.h"
#include "exact/base/scan.h"
#include "exact/base/shown.h"

namespace tribunal {
namespace {

std::string text_at(const Json& object, const char* key, const Where& where) { return Record(object, where).name(key); }

/// The fault of an answer with the status "failed", if the line names one.
Status fault_at(const Json& object, const Where& where) {
  if (!object.contains("fault")) return Status::gave_no_answer;
  const std::string name = text_at(object, "fault", where);
  if (const Status fault = fault_named(name); is_fault(fault)) return fault;
  where.key("fault").fail("expected one that docs/formats.md lists, found \"" + name + "\"");
}

Status status_at(const Json& object, const Where& where) {
  if (!object.contains("status")) return Status::ok;
  const std::string name = text_at(object, "status", where);
  for (const Status s : {Status::ok, Status::nonfinite, Status::unsupported}) {
    if (name == name_of(s)) return s;
  }
  if (name == name_of(Status::gave_no_answer)) return fault_at(object, where);
  where.key("status").fail("expected \"ok\", \"nonfinite\", \"unsupported\" or \"failed\", found \"" + name + "\"");
}

/// Unsaid unless the line says it.
Contact contact_at(const Json& object, const Where& where) {
  if (!object.contains("contact")) return Contact::unsaid;
  const std::string name = text_at(object, "contact", where);
  for (const Contact c : {Contact::interior, Contact::edge, Contact::vertex, Contact::coplanar}) {
    if (name == name_of(c)) return c;
  }
  where.key("contact").fail("expected \"interior\", \"edge\", \"vertex\" or \"coplanar\" of a hit, found \"" + name +
                            "\"");
}

/// "t", and with it "weights": those of b and c.
std::optional<HitAt> numbers_at(const Json& object, const Where& where) {
  if (!object.contains("t")) {
    if (object.contains("weights")) where.key("weights").fail("given without \"t\"");
    return std::nullopt;
  }
  if (!object.contains("hit") || object["hit"] != 1) where.key("t").fail("given of what is no hit");
  HitAt at{.t = to_any_number(object["t"], Format::binary64, where.key("t"))};
  if (!object.contains("weights")) return at;
  const Json& weights = object["weights"];
  if (!weights.is_array() || weights.size() != 2) where.key("weights").fail("expected those of b and c, two numbers");
  at.weights = BarycentricWeights{to_any_number(weights[0], Format::binary64, where.key("weights").index(0)),
                                  to_any_number(weights[1], Format::binary64, where.key("weights").index(1))};
  return at;
}

/// Unsaid unless the line says it.
Facing side_at(const Json& object, const Where& where) {
  if (!object.contains("side")) return Facing::unsaid;
  const std::string name = text_at(object, "side", where);
  for (const Facing f : {Facing::front, Facing::back}) {
    if (name == name_of(f)) return f;
  }
  where.key("side").fail("expected \"front\" or \"back\" of a hit, found \"" + name + "\"");
}

/// Keys that this program writes into answers but does not judge are allowed.
Answer to_answer(const Json& object, const Where& where) {
  require_keys(object,
               {"id", "method", "hit", "status", "class", "contact", "at", "side", "stage", "planar", "fault", "detail",
                "t", "weights"},
               where);
  const Status status = status_at(object, where);
  if (status != Status::ok) {
    if (object.contains("hit")) where.key("hit").fail("given with a status that is not \"ok\"");
    return refusal(status);
  }
  const Json& hit = require(object, "hit", where);
  if (hit != 0 && hit != 1) where.key("hit").fail("expected 0 or 1, found " + hit.dump());
  if (hit == 0) return miss();
  Answer answer = hit_at(contact_at(object, where));
  answer.facing = side_at(object, where);
  return answer;
}

/// Whether the scanner reads such a word of the given ones; `value` is then the one of that name.
template <class Value>
bool is_named(std::string_view name, std::initializer_list<Value> values, Value& value) {
  for (const Value v : values) {
    if (name != name_of(v)) continue;
    value = v;
    return true;
  }
  return false;
}

class AnswerScanner {
 public:
  AnswerScanner(std::string_view line, GivenAnswer& given) : s_(line), given_(given) {}

  bool read() {
    given_.answer = {};
    given_.numbers.reset();
    given_.method = "answers";
    const auto value_of = [this](unsigned key) { return value(key); };
    return s_.object(seen_, key_named, value_of) && s_.at_end() && is_whole();
  }

 private:
  enum Key : unsigned { id = 1, method = 2, hit = 4, status = 8, contact = 16, side = 32, t = 64, weights = 128 };

  static unsigned key_named(std::string_view name) {
    static constexpr struct {
      std::string_view name;
      unsigned key;
    } table[] = {{"id", id},      {"method", method}, {"hit", hit},         {"status", status}, {"contact", contact},
                 {"side", side},  {"t", t},           {"weights", weights}, {"class", 256},     {"at", 512},
                 {"stage", 1024}, {"planar", 2048},   {"detail", 4096}};
    for (const auto& row : table) {
      if (row.name == name) return row.key;
    }
    return 0;
  }

  bool text(std::string& value) {
    std::string_view text;
    if (!s_.text(text) || text.empty()) return false;
    value.assign(text);
    return true;
  }

  bool value(unsigned key) {
    std::string_view word;
    bool unread = false;
    switch (key) {
      case id:
        return text(given_.id);
      case method:
        return text(given_.method) && is_name(given_.method);
      case hit:
        return s_.bit(given_.answer.hit);
      case status:
        return s_.text(word) &&
               is_named(word, {Status::ok, Status::nonfinite, Status::unsupported}, given_.answer.status);
      case contact:
        return s_.text(contact_);
      case side:
        return s_.text(side_);
      case t:
        return s_.number(at_.t);
      case weights:
        at_.weights.emplace();
        return s_.take('[') && s_.number(at_.weights->b) && s_.take(',') && s_.number(at_.weights->c) && s_.take(']');
      case 2048:
        return s_.truth_value(unread);
      default:
        return s_.text(word);
    }
  }

  /// What to_given_answer demands beside the types. Of a miss, contact and side are not read.
  bool is_whole() {
    Answer& answer = given_.answer;
    const bool answered = answer.status == Status::ok;
    if ((seen_ & id) == 0 || answered != ((seen_ & hit) != 0)) return false;
    if ((seen_ & (t | weights)) != 0 && (!answer.hit || (seen_ & t) == 0)) return false;
    if ((seen_ & t) != 0) given_.numbers = at_;
    if (!answer.hit) return true;
    answer.contact = Contact::unsaid;
    if ((seen_ & contact) != 0 &&
        !is_named(contact_, {Contact::interior, Contact::edge, Contact::vertex, Contact::coplanar}, answer.contact)) {
      return false;
    }
    return (seen_ & side) == 0 || is_named(side_, {Facing::front, Facing::back}, answer.facing);
  }

  Scanner s_;
  GivenAnswer& given_;
  unsigned seen_ = 0;
  std::string_view contact_{}, side_{};
  HitAt at_{};
};

}  // namespace

GivenAnswer to_given_answer(const Json& object, const Where& where) {
  GivenAnswer given{.answer = to_answer(object, where)};
  given.id = text_at(object, "id", where);
  given.method = object.contains("method") ? name_at(object, "method", where) : "answers";
  given.numbers = numbers_at(object, where);
  return given;
}

bool scan_answer(std::string_view line, GivenAnswer& given) { return AnswerScanner(line, given).read(); }

void read_answer(std::string_view line, const std::string& path, std::size_t number, GivenAnswer& given) {
  if (scan_answer(line, given)) return;
  const Where where{path, number};
  given = to_given_answer(parse_json_beyond(line, where), where);
}

}  // namespace tribunal
