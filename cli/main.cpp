#include <algorithm>

#include "cli/program.hpp"
#include "cli/streams.hpp"

int main(int argc, char** argv) {
  tripus::cli::secure_standard_streams();
  tripus::cli::limit_blas_threads(argv);
  return tripus::cli::run_program({argv + std::min(argc, 1), argv + argc});
}
