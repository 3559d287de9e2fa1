#include <set>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "solver/method.hpp"

namespace tripus::solver {
namespace {

TEST(SolverTable, NamesAreUniqueAndFound) {
  std::set<std::string_view> names;
  for (const Method& method : methods()) {
    EXPECT_TRUE(names.insert(method.name).second) << method.name;
    EXPECT_EQ(find_method(method.name), &method);
    EXPECT_FALSE(method.description.empty());
  }
  EXPECT_EQ(find_method(""), nullptr);
  EXPECT_EQ(find_method("Newton"), nullptr);
}

TEST(SolverTable, EveryTerminationHasWords) {
  std::set<std::string_view> words;
  for (const Termination t :
       {Termination::kConverged, Termination::kIterationLimit, Termination::kTimeLimit,
        Termination::kStalled, Termination::kUnbounded, Termination::kNumericalFailure,
        Termination::kInterrupted}) {
    EXPECT_TRUE(words.insert(to_string(t)).second);
  }
}

TEST(SolverOptions, ErrorsNameTheOption) {
  Options options;
  EXPECT_NO_THROW(validate(options));
  options.tolerance = -1;
  try {
    validate(options);
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find("tolerance"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("-1"), std::string::npos);
  }
}

}  // namespace
}  // namespace tripus::solver
