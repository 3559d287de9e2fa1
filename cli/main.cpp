#include <algorithm>

#include "cli/program.hpp"

int main(int argc, char** argv) {
  return tripus::cli::run_program({argv + std::min(argc, 1), argv + argc});
}
