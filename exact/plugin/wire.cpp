#include "exact/plugin/wire.h"

#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdint>

namespace tribunal {
namespace {

constexpr std::uint64_t message_mark = 0x7472'6962'756e'616c;  ///< every message starts with this
constexpr std::uint64_t longest_message = std::uint64_t{1} << 32;

/// Milliseconds for poll: at least one until the deadline is over; −1 for ever.
int milliseconds_until(Deadline deadline) {
  if (deadline == no_deadline()) return -1;
  const auto left = std::chrono::duration<double, std::milli>(deadline - std::chrono::steady_clock::now()).count();
  return left <= 0 ? 0 : static_cast<int>(std::min(std::ceil(left), 1e9));
}

/// Transfers all bytes by calls of move(at, left), each of which transfers as many as it can without waiting.
template <class Move>
Transfer transfer(int socket, short event, std::size_t n, Deadline deadline, const Move& move) {
  for (std::size_t done = 0; done < n;) {
    const ssize_t moved = move(done, n - done);
    if (moved > 0) {
      done += static_cast<std::size_t>(moved);
      continue;
    }
    if (moved == 0) return Transfer::closed;
    if (errno == EINTR) continue;
    if (errno != EAGAIN && errno != EWOULDBLOCK) return Transfer::closed;
    pollfd waiting{socket, event, 0};
    const int ready = poll(&waiting, 1, milliseconds_until(deadline));
    if (ready == 0 && std::chrono::steady_clock::now() >= deadline) return Transfer::late;
  }
  return Transfer::done;
}

struct Head {
  std::uint64_t mark, length;
};

}  // namespace

Deadline after_seconds(double seconds) {
  constexpr double ever = 1e9;
  return std::chrono::steady_clock::now() + std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                                                std::chrono::duration<double>(std::min(seconds, ever)));
}

Transfer send_bytes(int socket, const void* bytes, std::size_t n, Deadline deadline) {
  const auto move = [&](std::size_t at, std::size_t left) {
    return send(socket, static_cast<const char*>(bytes) + at, left, MSG_NOSIGNAL | MSG_DONTWAIT);
  };
  return transfer(socket, POLLOUT, n, deadline, move);
}

Transfer receive_bytes(int socket, void* bytes, std::size_t n, Deadline deadline) {
  const auto move = [&](std::size_t at, std::size_t left) {
    return recv(socket, static_cast<char*>(bytes) + at, left, MSG_DONTWAIT);
  };
  return transfer(socket, POLLIN, n, deadline, move);
}

Transfer send_message(int socket, const Message& message, Deadline deadline) {
  const Head head{message_mark, message.bytes().size()};
  const Transfer sent = send_bytes(socket, &head, sizeof head, deadline);
  if (sent != Transfer::done) return sent;
  return send_bytes(socket, message.bytes().data(), message.bytes().size(), deadline);
}

Transfer receive_message(int socket, std::vector<char>& bytes, Deadline deadline) {
  Head head{};
  const Transfer received = receive_bytes(socket, &head, sizeof head, deadline);
  if (received != Transfer::done) return received;
  if (head.mark != message_mark || head.length > longest_message) return Transfer::garbled;
  bytes.resize(head.length);
  return receive_bytes(socket, bytes.data(), bytes.size(), deadline);
}

}  // namespace tribunal
