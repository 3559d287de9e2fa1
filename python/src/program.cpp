#include "cli/program.hpp"

#include <nanobind/nanobind.h>

#include "cli/batch_output.hpp"
#include "cli/output.hpp"
#include "manifold/load.hpp"
#include "python/src/bindings.hpp"

namespace tripus::python {
namespace {

/// A batch that Python answers, with the answers of an earlier run as the program keeps them.
class ResumedBatch {
 public:
  ResumedBatch(const nb::bytes& path, const nb::bytes& resume, const nb::bytes& asked) {
    const std::string file = as_string(path), earlier = as_string(resume);
    quickly([&] {
      if (!earlier.empty()) cli::declare_output("--resume", earlier);
      cli::require_not_written(file);
      lines_ = read_batch_file(file);
      output_.emplace(earlier, as_string(asked), lines_);
      return true;
    });
  }

  /// (number in the file, text) of all lines.
  nb::list lines() const {
    nb::list all;
    for (const topology::BatchLine& line : lines_)
      all.append(nb::make_tuple(line.line_number, as_bytes(line.text)));
    return all;
  }
  std::size_t answered() const { return output_->answered(); }
  /// A whole line, with its line end. Only with a file of answers.
  void write(const nb::bytes& line) {
    const std::string text = as_string(line);
    quickly([&] {
      output_->write(text);
      return true;
    });
  }

 private:
  std::vector<topology::BatchLine> lines_;
  std::optional<cli::BatchOutput> output_;
};

}  // namespace

/// The program `tripus` in this process, which is given to it: a wheel then holds the library once.
void bind_program(nb::module_& module) {
  module.def("run_program", [](const nb::list& arguments) {
    std::vector<std::string> given;
    for (const nb::handle each : arguments) given.push_back(as_string(nb::cast<nb::bytes>(each)));
    return quickly([&] { return cli::run_program(given); });
  });
  nb::class_<ResumedBatch>(module, "ResumedBatch", "cli::BatchOutput")
      .def(nb::init<const nb::bytes&, const nb::bytes&, const nb::bytes&>())
      .def("lines", &ResumedBatch::lines)
      .def("answered", &ResumedBatch::answered)
      .def("write", &ResumedBatch::write);
}

}  // namespace tripus::python
