#include <gtest/gtest.h>

#include "base/svg_text.hpp"

namespace {

using namespace tripus;

TEST(SvgText, EscapesWhatMarkupTakesForItsOwn) {
  EXPECT_EQ(escaped_xml("a < b & \"c\" > d"), "a &lt; b &amp; &quot;c&quot; &gt; d");
  EXPECT_EQ(escaped_xml("&lt;"), "&amp;lt;");
  EXPECT_EQ(escaped_xml("genus 2, \xc3\xa9"), "genus 2, \xc3\xa9");
}

TEST(SvgText, WritesColoursWithTwoDigitsAPart) {
  EXPECT_EQ(hex_colour(0, 114, 178), "#0072b2");
  EXPECT_EQ(hex_colour(255, 10, 0), "#ff0a00");
}

TEST(SvgText, BeginsAPictureOfThatSizeWithItsTitle) {
  const std::string head = svg_head(640, 480, 14, "a<b");
  EXPECT_NE(head.find("viewBox=\"0 0 640 480\""), std::string::npos);
  EXPECT_NE(head.find("<title>a&lt;b</title>"), std::string::npos);
  EXPECT_NE(head.find("font-size=\"14\""), std::string::npos);
}

}  // namespace
