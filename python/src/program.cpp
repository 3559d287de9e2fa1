#include "cli/program.hpp"

#include <nanobind/nanobind.h>

#include "python/src/bindings.hpp"

namespace tripus::python {

/// The program `tripus` in this process, which is given to it: a wheel then holds the library once.
void bind_program(nb::module_& module) {
  module.def("run_program", [](const nb::list& arguments) {
    std::vector<std::string> given;
    for (const nb::handle each : arguments) given.push_back(as_string(nb::cast<nb::bytes>(each)));
    return quickly([&] { return cli::run_program(given); });
  });
}

}  // namespace tripus::python
