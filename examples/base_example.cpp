// The three kinds of failure: what the library throws is the caller's input or our own fault; a
// mathematical "no" is an answer.
#include <cstdio>

#include "base/error.hpp"
#include "base/tolerances.hpp"
#include "base/version.hpp"

int main() {
  using namespace tripus;
  std::printf("tripus %s, max|K| <= %g\n", kVersion, tolerance::kMaxCurvature);
  try {
    throw InvalidInput("the name is " + quoted("a\tb") + "; expected a word");
  } catch (const Error& error) {
    std::puts(error.what());  // the name is "a\x09b"; expected a word
  }
}
