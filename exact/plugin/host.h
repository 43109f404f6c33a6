// The two ends of the conversation with an isolated plugin: what is asked, and the child that answers.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "exact/harness/fault.h"
#include "exact/plugin/tribunal_plugin.h"
#include "exact/plugin/wire.h"

namespace tribunal {

/// What a child says first: what its library describes, or why there is none.
struct Introduction {
  int failed_with = 0;  ///< an exit code, and `failure` says why
  std::string failure{};
  int abi = 0;  ///< for another version than ours, nothing else is told
  std::optional<std::string> name{}, contract{}, summary{}, reference{};
  int format = 0, convention = 0;
  bool asks = false, batches = false;
  bool takes_polygons = false;
  int polygon_abi = 0, restrictions = 0;
  bool asks_polygons = false;
};

/// The introduction, from a message; nothing if it is none.
std::optional<Introduction> introduction_in(std::vector<char> bytes);

/// Of these triangles: one after the other, or by one call of the plugin's batch function.
enum class Kind : int { each, batch, polygon };

Message question(Kind kind, int probe, std::size_t n, const double* queries);
Message question(int probe, const double* coordinates, const tribunal_polygon& polygon);

/// What came back: one answer each, or the fault.
struct Reply {
  Fault fault{};
  std::vector<int> answers{};
};

/// The reply, from a message; nothing if it is none.
std::optional<Reply> reply_in(std::vector<char> bytes);

/// What a child does: loads the library, introduces it, and answers until the socket is closed.
void host_plugin(const std::string& file, int socket);

}  // namespace tribunal
