#pragma once

#include <atomic>

namespace tripus::cli {

/// Set by the first Ctrl-C (SIGINT) or SIGTERM after `catch_interrupts`; work then ends cleanly
/// with what is done. A second one ends the process.
const std::atomic<bool>& interrupt_requested();

/// Installs the handlers, the first time it is called. Call it when the input has been read: until
/// then there is nothing to save, and a program that waits for a terminal should just end.
void catch_interrupts();

}  // namespace tripus::cli
