#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <string_view>

#include "base/context.hpp"

namespace tripus::cli {

// Work ends early for one of two reasons: a signal (Ctrl-C, that is SIGINT, or SIGTERM), or
// --time-limit. Both raise a flag; work that polls it ends cleanly with what is done. What has not
// ended after a moment (0.65 s) is ended: nothing is lost by it, since files are whole at any time
// (base/output_file.hpp, base/journal.hpp). A second signal ends the process at once.
//
// The limit is one of the process, except in a batch, where each line has it for itself; a line
// that ends late does not end the process.

/// Installs the handlers of the signals, the first time it is called.
void catch_interrupts();

/// Ends the process after so many seconds as a signal would; or, for `each_line`, the work of
/// every LineLimit. To be called once, before any work. Throws IoError.
void set_time_limit(double seconds, bool each_line);

/// While it lives the time limit of a line of a batch, if there is one, holds for this thread.
class LineLimit {
 public:
  LineLimit();
  ~LineLimit();
  LineLimit(const LineLimit&) = delete;
  LineLimit& operator=(const LineLimit&) = delete;
};

/// Whether the process is to end, by a signal or its time limit.
const std::atomic<bool>& interrupt_requested();
/// Whether the work of this thread is to end: with the process, or by the limit of its line.
const std::atomic<bool>& stop_flag();
/// The same, or its deadline has passed, which comes a moment before the flag.
bool is_work_over();
/// Whether it is the time limit by which the work of this thread is to end.
bool is_time_over();
/// "interrupted", or "the time limit of 2 s was reached".
std::string stop_text();
/// Of the time limit of this thread's work; more than 0, infinity if there is none.
double seconds_left();

/// What the process says if it is ended: on standard error why (`stop_text`) and then `rest`; on
/// standard output what `output` makes of the reason.
void set_last_words(
    std::string_view rest,
    const std::function<std::string(std::string_view why, bool is_time_over)>& output = {});

/// A Context that ends with stop_flag() and the time limit, and writes notes to standard error.
Context interruptible();

}  // namespace tripus::cli
