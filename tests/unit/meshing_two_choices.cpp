// Questions with two answers, against all answers one after the other.
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "meshing/detail/two_choices.hpp"

namespace tripus::meshing::detail {
namespace {

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

bool keeps(const Pairs& excluded, const std::vector<std::uint8_t>& answers) {
  for (const auto& [a, b] : excluded)
    if (answers[a / 2] == a % 2 && answers[b / 2] == b % 2) return false;
  return true;
}

bool has_answers(const Pairs& excluded, std::size_t questions) {
  std::vector<std::uint8_t> answers(questions);
  for (std::uint32_t all = 0; all < 1u << questions; ++all) {
    for (std::size_t q = 0; q < questions; ++q) answers[q] = all >> q & 1;
    if (keeps(excluded, answers)) return true;
  }
  return false;
}

TEST(TwoChoices, AgreeWithAllAnswers) {
  std::mt19937 random(3);
  std::size_t solvable = 0, hopeless = 0;
  for (int round = 0; round < 4000; ++round) {
    const std::size_t questions = 1 + random() % 7, count = random() % (3 * questions + 1);
    TwoChoices choices(questions);
    Pairs excluded;
    for (std::size_t i = 0; i < count; ++i) {
      const auto any = [&] { return static_cast<std::uint32_t>(random() % (2 * questions)); };
      excluded.emplace_back(any(), any());
      choices.exclude(excluded.back().first, excluded.back().second);
    }
    const auto answers = choices.answers();
    ASSERT_EQ(answers.has_value(), has_answers(excluded, questions)) << round;
    EXPECT_TRUE(!answers || keeps(excluded, *answers)) << round;
    ++(answers ? solvable : hopeless);
  }
  EXPECT_GT(solvable, 500u);
  EXPECT_GT(hopeless, 500u);
}

TEST(TwoChoices, AreFoundAlongALongChain) {
  constexpr std::uint32_t kCount = 200'000;
  TwoChoices choices(kCount);
  choices.exclude(0, 0);
  for (std::uint32_t q = 1; q < kCount; ++q) choices.exclude(2 * q - 1, 2 * q);
  const auto answers = choices.answers();
  ASSERT_TRUE(answers);
  for (const std::uint8_t answer : *answers) ASSERT_EQ(answer, 1);
}

}  // namespace
}  // namespace tripus::meshing::detail
