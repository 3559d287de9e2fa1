#pragma once

#include <atomic>

namespace tripus::cli {

/// Set by the first Ctrl-C (SIGINT) or SIGTERM after `catch_interrupts`; work then ends cleanly
/// with what is done. A second one ends the process.
const std::atomic<bool>& interrupt_requested();

/// Installs the handlers.
void catch_interrupts();

}  // namespace tripus::cli
