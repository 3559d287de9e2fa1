#pragma once

#include <atomic>
#include <string>

#include "base/context.hpp"

namespace tripus::cli {

/// Set by the first Ctrl-C (SIGINT) or SIGTERM after `catch_interrupts`; work then ends cleanly
/// with what is done. What has not ended within kGrace is ended: nothing is lost by it, since files
/// are whole at any moment (base/output_file.hpp, base/journal.hpp). A second one ends the process
/// at once.
const std::atomic<bool>& interrupt_requested();

/// Installs the handlers, the first time it is called.
void catch_interrupts();

/// What the process says if it is ended: a text for standard error, and one for standard output.
/// By default that it was interrupted.
void set_last_words(std::string message, std::string output = {});

/// A Context that ends with Ctrl-C and writes notes to standard error.
Context interruptible();

}  // namespace tripus::cli
