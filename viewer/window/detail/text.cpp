#include "viewer/window/detail/text.hpp"

#include <algorithm>
#include <vector>

#include "viewer/detail/gl.hpp"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_easy_font.h>
#pragma GCC diagnostic pop

namespace tripus::viewer {
namespace {

/// While it lives, drawing is flat, in pixels from the top left corner.
class FlatDrawing {
 public:
  FlatDrawing(int width, int height) {
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    glViewport(0, 0, width, height);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glMatrixMode(GL_PROJECTION);
    glPushMatrix();
    glLoadIdentity();
    glOrtho(0, width, height, 0, -1, 1);
    glMatrixMode(GL_MODELVIEW);
    glPushMatrix();
    glLoadIdentity();
  }
  ~FlatDrawing() {
    glPopMatrix();
    glMatrixMode(GL_PROJECTION);
    glPopMatrix();
    glMatrixMode(GL_MODELVIEW);
    glPopAttrib();
  }
  FlatDrawing(const FlatDrawing&) = delete;
  FlatDrawing& operator=(const FlatDrawing&) = delete;
};

}  // namespace

void draw_text(const std::string& text, float x, float y, int scale, int width, int height) {
  std::string shown = text;  // the font's functions take it without const
  std::vector<char> quads(300 * shown.size() + 64);
  const int count = stb_easy_font_print(0, 0, shown.data(), nullptr, quads.data(),
                                        static_cast<int>(quads.size()));
  const auto wide = static_cast<float>(stb_easy_font_width(shown.data()));
  const auto high = static_cast<float>(stb_easy_font_height(shown.data()));
  const FlatDrawing flat(width, height);
  glTranslatef(x, y, 0);
  glScalef(static_cast<float>(scale), static_cast<float>(scale), 1);
  glColor4f(1, 1, 1, 0.75F);
  glRectf(-4, -4, wide + 4, high + 1);
  glColor4f(0.13F, 0.16F, 0.2F, 1);
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(2, GL_FLOAT, 16, quads.data());
  glDrawArrays(GL_QUADS, 0, 4 * count);
  glDisableClientState(GL_VERTEX_ARRAY);
}

void draw_legend(std::span<const LegendRectangle> rectangles, int width, int height) {
  const FlatDrawing flat(width, height);
  for (const LegendRectangle& rectangle : rectangles) {
    glColor4ubv(rectangle.colour.data());
    glRectf(rectangle.left, rectangle.top, rectangle.right, rectangle.bottom);
  }
}

}  // namespace tripus::viewer
