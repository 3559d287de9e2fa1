#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace tripus {

/// Text for the inside of an element, or of a quoted attribute, of XML, SVG and HTML.
inline std::string escaped_xml(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

/// A colour as SVG, HTML and CSS write it: "#56b4e9".
inline std::string hex_colour(std::uint8_t red, std::uint8_t green, std::uint8_t blue) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text = "#";
  for (const std::uint8_t part : {red, green, blue}) {
    text += kDigits[part / 16];
    text += kDigits[part % 16];
  }
  return text;
}

/// The beginning of an SVG document of so many pixels, white, with a title and sans-serif letters;
/// it ends with "</svg>\n".
inline std::string svg_head(int width, int height, int font_size, std::string_view title) {
  const std::string w = std::to_string(width), h = std::to_string(height);
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + w + "\" height=\"" + h +
         "\" viewBox=\"0 0 " + w + " " + h + "\" font-family=\"sans-serif\" font-size=\"" +
         std::to_string(font_size) + "\">\n<title>" + escaped_xml(title) +
         "</title>\n<rect width=\"" + w + "\" height=\"" + h + "\" fill=\"white\"/>\n";
}

}  // namespace tripus
