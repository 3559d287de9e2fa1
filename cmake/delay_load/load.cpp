// Loads a shared library at the first call of one of its functions; see stubs.py.
#include <cstddef>
#include <string>

#include <dlfcn.h>

#include "base/error.hpp"

namespace {

struct Function {
  const char* library;
  const char* name;
};

#include "tripus_delayed_functions.inc"

}  // namespace

/// The address of a function, called by its stub until the slot has it. Any thread may come first:
/// all would write the same. The library stays for good. Throws IoError where it cannot be loaded.
extern "C" [[gnu::visibility("hidden")]] void* tripus_delayed_function(std::size_t number) {
  const Function& function = kFunctions[number];
  void* const library = ::dlopen(function.library, RTLD_NOW | RTLD_LOCAL);
  void* const address = library != nullptr ? ::dlsym(library, function.name) : nullptr;
  if (address == nullptr) {
    throw tripus::IoError("cannot load " + std::string(function.library) + ": " + ::dlerror() +
                          "; install Tripus again, or that library");
  }
  __atomic_store_n(&tripus_delayed_slots[number], address, __ATOMIC_RELEASE);
  return address;
}
