#include <limits>

#include <gtest/gtest.h>

#include "base/big_number.hpp"

namespace tripus {
namespace {

TEST(BigNumber, DecimalTextThereAndBack) {
  for (const std::string text :
       {"0", "7", "-7", "9223372036854775807", "-123456789012345678901234567890",
        "100000000000000000000000000000000000000000"})
    EXPECT_EQ(to_decimal(big_integer(text)), text);
  EXPECT_EQ(big_integer("0012"), 12) << "not octal";
  EXPECT_EQ(big_integer("-0"), 0);
}

TEST(BigNumber, FractionsAreReduced) {
  const BigRational x = BigRational(-6) / 8;
  EXPECT_EQ(numerator_of(x), -3);
  EXPECT_EQ(denominator_of(x), 4);
  EXPECT_EQ(sign_of(x), -1);
  EXPECT_EQ(sign_of(x + BigRational(3) / 4), 0);
  EXPECT_EQ(to_double(x), -0.75);
}

TEST(BigNumber, FitsBack) {
  for (const std::int64_t x : {std::numeric_limits<std::int64_t>::min(), std::int64_t{-1},
                               std::numeric_limits<std::int64_t>::max()})
    EXPECT_EQ(to_int64(BigInteger(x)), x);
  EXPECT_EQ(to_int64(BigInteger(-17) % 5), -2) << "the remainder has the sign of what is divided";
}

}  // namespace
}  // namespace tripus
