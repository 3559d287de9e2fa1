#include <nanobind/nanobind.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>

#include "base/stop.hpp"
#include "base/system_error.hpp"
#include "base/version.hpp"
#include "python/src/arrays.hpp"
#include "python/src/bindings.hpp"
#include "python/src/meshes.hpp"

namespace tripus::python {
namespace {

/// The Python class of an error; the most special first.
const char* class_of(const std::exception& error) {
  if (dynamic_cast<const Unsupported*>(&error) != nullptr) return "Unsupported";
  if (dynamic_cast<const UnusableFile*>(&error) != nullptr) return "FileError";
  if (dynamic_cast<const InvalidInput*>(&error) != nullptr) return "InvalidInput";
  if (dynamic_cast<const IoError*>(&error) != nullptr) return "FileError";
  if (dynamic_cast<const Stopped*>(&error) != nullptr) return "Stopped";
  if (dynamic_cast<const InternalError*>(&error) != nullptr) return "InternalError";
  return "TripusError";
}

void translate(const std::exception_ptr& pointer, void* /*payload*/) {
  try {
    std::rethrow_exception(pointer);
  } catch (const Error& error) {
    // What tripus says is ASCII but for what it quotes from files.
    const nb::object text = nb::steal(
        PyUnicode_DecodeUTF8(error.what(), Py_ssize_t(std::char_traits<char>::length(error.what())),
                             "backslashreplace"));
    const nb::object type = nb::module_::import_("tripus._errors").attr(class_of(error));
    PyErr_SetObject(type.ptr(), text.ptr());
  }
}

}  // namespace

void require_numpy() {
  static bool is_there = false;
  if (is_there) return;
  nb::module_::import_("tripus._lazy").attr("load")("numpy");
  is_there = true;
}

void bind_errors(nb::module_& module) {
  nb::register_exception_translator(translate);
  module.attr("version") = kVersion;
}

}  // namespace tripus::python

NB_MODULE(_core, module) {
  using namespace tripus::python;
  module.doc() = "The compiled part of tripus. Use the package instead.";
  prepare_for_work();
  bind_errors(module);
  nb::class_<Limits>(module, "Limits", "How long work may take.")
      .def(
          "__init__",
          [](Limits* self, std::optional<double> time_limit, unsigned threads,
             nb::object progress) {
            new (self) Limits{time_limit, threads, std::move(progress)};
          },
          nb::arg("time_limit") = nb::none(), nb::arg("threads") = 0,
          nb::arg("progress") = nb::none());
  bind_manifold(module);
  bind_metric(module);
  bind_canonical(module);
  bind_files(module);
  bind_diagrams(module);
  bind_parameterise(module);
  bind_program(module);
  bind_solve_many(module);
  bind_studies(module);
  bind_views(module);
}
