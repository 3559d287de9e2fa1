#pragma once

#include <atomic>

#include "base/context.hpp"

namespace tripus::cli {

/// Set by the first Ctrl-C (SIGINT) or SIGTERM after `catch_interrupts`; work then ends cleanly
/// with what is done. A second one ends the process.
const std::atomic<bool>& interrupt_requested();

/// Installs the handlers, the first time it is called. Call it when the input has been read: until
/// then there is nothing to save, and a program that waits for a terminal should just end.
void catch_interrupts();

/// A Context that ends with Ctrl-C and writes notes to standard error; the handlers are installed
/// when work begins on the input.
Context interruptible();

}  // namespace tripus::cli
