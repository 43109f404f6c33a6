// Bytes between this process and a child, with a time limit.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

namespace tribunal {

using Deadline = std::chrono::steady_clock::time_point;
Deadline after_seconds(double seconds);
inline Deadline no_deadline() { return Deadline::max(); }

/// How a transfer ended. `closed`: the other end is gone. `late`: after the deadline. `garbled`: what came is no
/// message.
enum class Transfer { done, closed, late, garbled };

/// Transfers all n bytes; unless the result is `done`, the bytes must not be used.
Transfer send_bytes(int socket, const void* bytes, std::size_t n, Deadline deadline);
Transfer receive_bytes(int socket, void* bytes, std::size_t n, Deadline deadline);

/// A message as it is written: plain values, one after the other.
class Message {
 public:
  template <class T>
  Message& add(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    return add(&value, 1);
  }

  template <class T>
  Message& add(const T* values, std::size_t n) {
    static_assert(std::is_trivially_copyable_v<T>);
    const std::size_t size = n * sizeof(T), end = bytes_.size();
    bytes_.resize(end + size);
    if (size > 0) std::memcpy(bytes_.data() + end, values, size);
    return *this;
  }

  Message& add(const std::string& text) {
    add(text.size());
    return add(text.data(), text.size());
  }

  const std::vector<char>& bytes() const { return bytes_; }

 private:
  std::vector<char> bytes_;
};

/// Reads a message from a process that may send anything: `good` is false as soon as the message was too short.
class Reader {
 public:
  explicit Reader(std::vector<char> bytes) : bytes_(std::move(bytes)) {}

  template <class T>
  T take() {
    T value{};
    take(&value, 1);
    return value;
  }

  template <class T>
  void take(T* values, std::size_t n) {
    const std::size_t left = bytes_.size() - at_;
    good_ = good_ && n <= left / sizeof(T);
    if (!good_ || n == 0) return;
    std::memcpy(values, bytes_.data() + at_, n * sizeof(T));
    at_ += n * sizeof(T);
  }

  template <class T>
  std::vector<T> take_many(std::size_t n) {
    good_ = good_ && n <= (bytes_.size() - at_) / sizeof(T);
    std::vector<T> values(good_ ? n : 0);
    take(values.data(), values.size());
    return values;
  }

  std::string take_text() {
    const std::vector<char> text = take_many<char>(take<std::size_t>());
    return {text.begin(), text.end()};
  }

  /// Everything was there, and nothing is left.
  bool complete() const { return good_ && at_ == bytes_.size(); }
  bool good() const { return good_; }

 private:
  std::vector<char> bytes_;
  std::size_t at_ = 0;
  bool good_ = true;
};

/// Transfers a whole message, after its length.
Transfer send_message(int socket, const Message& message, Deadline deadline);
Transfer receive_message(int socket, std::vector<char>& bytes, Deadline deadline);

}  // namespace tribunal
