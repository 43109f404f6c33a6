// SIGINT, SIGTERM and SIGHUP. Work that keeps nothing ends at once; work that has something to put in order first is
// told of the signal, and asks.
#pragma once

#include <string>

namespace tribunal {

/// Installs the handlers. From here on a signal removes all temporary files, writes one line to standard error and ends
/// the program with 128 + signal, at any time, unless an OrderlyEnd lives. A process that was forked off is ended by
/// the signal as by default. SIGHUP is left alone where it is ignored, as nohup wants it.
void watch_interrupts();

/// The signal that asked for an end, or 0.
int interrupted();

/// Fails with 128 + the signal that asked for an end, if one did, and says what is missing now: "no chart written".
void fail_if_interrupted(const std::string& missing);

/// While one lives, on any thread, a first signal is only remembered: the work asks interrupted() and ends soon. A
/// second signal ends the program at once, as above.
class OrderlyEnd {
 public:
  OrderlyEnd();
  ~OrderlyEnd();
  OrderlyEnd(const OrderlyEnd&) = delete;
  OrderlyEnd& operator=(const OrderlyEnd&) = delete;
};

/// An OrderlyEnd of work that loses something if it is cut short: findings not yet saved, a set of files half in place.
/// A second signal changes nothing either, but for a line that says so; a third ends the program at once.
class UnbrokenEnd {
 public:
  UnbrokenEnd();
  ~UnbrokenEnd();
  UnbrokenEnd(const UnbrokenEnd&) = delete;
  UnbrokenEnd& operator=(const UnbrokenEnd&) = delete;

 private:
  OrderlyEnd orderly_{};
};

/// While it lives, the line of a signal that ends the program at once says this too: "chart.json holds the parts
/// before". The latest counts. Of the main thread alone.
class IfInterrupted {
 public:
  explicit IfInterrupted(std::string note);
  ~IfInterrupted();
  IfInterrupted(const IfInterrupted&) = delete;
  IfInterrupted& operator=(const IfInterrupted&) = delete;

 private:
  std::string note_;
  const char* before_;
};

}  // namespace tribunal
