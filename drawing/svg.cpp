#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string_view>

#include <fmt/format.h>

#include "base/svg_text.hpp"
#include "drawing/drawing.hpp"

namespace tripus::drawing {
namespace {

/// Okabe and Ito's colours, which people with any colour vision tell apart, dark ones first.
constexpr std::array<std::string_view, 6> kColours{"#1f4e79", "#d55e00", "#009e73",
                                                   "#cc79a7", "#7a5c00", "#56b4e9"};

constexpr double kStrokeOfSide = 0.014;     // of the picture's longer side
constexpr double kStrokeOfCrossing = 0.22;  // of the radius of the smallest crossing's disc
constexpr double kGapInStrokes = 2.0;       // from the middle of the over-strand
constexpr double kVertexInStrokes = 1.7;
constexpr double kLargestNumber = 0.045;  // height of arc numbers, of the picture's longer side
constexpr double kNumberInDisc = 0.9;     // and of the radius of the arc's disc

class SvgWriter {
 public:
  SvgWriter(const Drawing& drawing, const SvgOptions& options) : drawing_(&drawing) {
    const Point diagonal = drawing.high - drawing.low;
    const double side = std::max({diagonal.real(), diagonal.imag(), 1e-9});
    stroke_ = kStrokeOfSide * side;
    over_.assign(drawing.crossings.size(), nullptr);
    for (const DrawnStrand& strand : drawing.strands)
      for (const StrandPiece& piece : strand.pieces)
        if (piece.level == Level::kOver) {
          over_[piece.node] = &piece.curve;
          stroke_ = std::min(stroke_, kStrokeOfCrossing * drawing.crossings[piece.node].radius);
        }
    const double margin = 2.5 * stroke_ + (options.arcs ? 1.5 * kLargestNumber * side : 0);
    largest_number_ = kLargestNumber * side;
    scale_ = options.size / (side + 2 * margin);
    corner_ = {drawing.low.real() - margin, drawing.high.imag() + margin};
    width_ = (diagonal.real() + 2 * margin) * scale_;
    height_ = (diagonal.imag() + 2 * margin) * scale_;
  }

  std::string write(const SvgOptions& options) {
    out_ = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
        "viewBox=\"0 0 {0:.2f} {1:.2f}\" role=\"img\">\n",
        width_, height_);
    if (!options.title.empty()) out_ += "<title>" + escaped_xml(options.title) + "</title>\n";
    out_ += fmt::format(
        "<g fill=\"none\" stroke-width=\"{:.2f}\" stroke-linecap=\"round\" "
        "stroke-linejoin=\"round\">\n",
        stroke_ * scale_);
    for (std::size_t s = 0; s < drawing_->strands.size(); ++s)
      strand(drawing_->strands[s], options.colours ? kColours[s % kColours.size()] : "#000");
    out_ += "</g>\n";
    for (const Point vertex : drawing_->vertices) {
      const Point p = pixel(vertex);
      out_ += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\"/>\n", p.real(),
                          p.imag(), kVertexInStrokes * stroke_ * scale_);
    }
    if (options.arcs) numbers();
    return std::move(out_) + "</svg>\n";
  }

 private:
  Point pixel(Point p) const {
    return {(p.real() - corner_.real()) * scale_, (corner_.imag() - p.imag()) * scale_};
  }

  /// Beside the arcs. A digit is some 0.6 of its height wide.
  void numbers() {
    out_ += "<g font-family=\"sans-serif\" text-anchor=\"middle\" dominant-baseline=\"central\">\n";
    for (const ArcLabel& label : drawing_->arcs) {
      const std::string text = std::to_string(label.arc);
      const double height = std::min(largest_number_, kNumberInDisc * label.radius);
      const Point half{0.3 * height * double(text.size()), 0.4 * height};
      const double out = stroke_ + std::abs(label.away.real()) * half.real() +
                         std::abs(label.away.imag()) * half.imag();
      const Point p = pixel(label.middle + out * label.away);
      out_ += fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{:.2f}\">{}</text>\n",
                          p.real(), p.imag(), height * scale_, text);
    }
    out_ += "</g>\n";
  }

  void strand(const DrawnStrand& drawn, std::string_view colour) {
    out_ += fmt::format("<path stroke=\"{}\" d=\"", colour);
    pen_down_ = false;
    for (const StrandPiece& piece : drawn.pieces) {
      if (piece.level != Level::kUnder) {
        curve(piece.curve, 0, 1);
        continue;
      }
      const double at = crossing_parameter(piece.curve, *over_[piece.node]);
      const double gap = kGapInStrokes * stroke_ / piece.curve.length();
      curve(piece.curve, 0, std::max(at - gap, 0.02));
      pen_down_ = false;
      curve(piece.curve, std::min(at + gap, 0.98), 1);
    }
    out_ += "\"/>\n";
  }

  void curve(const Curve& curve, double from, double to) {
    if (!pen_down_) {
      const Point start = pixel(curve.at(from));
      fmt::format_to(std::back_inserter(out_), "M{:.2f} {:.2f}", start.real(), start.imag());
      pen_down_ = true;
    }
    const Point end = pixel(curve.at(to));
    if (curve.radius == 0)
      fmt::format_to(std::back_inserter(out_), "L{:.2f} {:.2f}", end.real(), end.imag());
    else  // the picture's y axis points down: what turns left turns right
      fmt::format_to(std::back_inserter(out_), "A{0:.2f} {0:.2f} 0 0 {1} {2:.2f} {3:.2f}",
                     curve.radius * scale_, curve.turns_left() ? 0 : 1, end.real(), end.imag());
  }

  const Drawing* drawing_;
  std::vector<const Curve*> over_;
  double stroke_ = 0, largest_number_ = 0, scale_ = 1, width_ = 0, height_ = 0;
  Point corner_;
  bool pen_down_ = false;
  std::string out_;
};

}  // namespace

std::string to_svg(const topology::Diagram& diagram, const SvgOptions& options) {
  const Drawing drawing = draw(diagram);
  return SvgWriter(drawing, options).write(options);
}

}  // namespace tripus::drawing
