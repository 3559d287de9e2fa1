// The one list of keys, what they do to a view, the slider, and words for what is seen: no window.
#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "embedding/universal_cover.hpp"
#include "tests/support/embedded_manifolds.hpp"
#include "viewer/keys.hpp"
#include "viewer/scene_words.hpp"
#include "viewer/window/slider.hpp"
#include "viewer/window/view_state.hpp"

namespace tripus::viewer {
namespace {

const BoundingBall kFocus{{0.25, 0, 0}, 2};

TEST(ViewerKeys, HaveOneMeaningEachInWindowAndPage) {
  for (const bool page : {false, true}) {
    std::set<std::string_view> keys;
    for (const KeyLine& line : key_lines()) {
      if (!(page ? line.in_page : line.in_window)) continue;
      EXPECT_TRUE(keys.insert(line.keys).second) << line.keys;
      if (line.action == KeyAction::kNone) continue;
      EXPECT_EQ(line.name.empty(), !line.in_page) << line.keys;
      EXPECT_EQ(line.keys.size(), 1U) << line.keys;
    }
  }
}

TEST(ViewerKeys, OfTheWindowReachEveryActionAndNoHeldKey) {
  std::set<KeyAction> reached;
  for (char32_t c = ' '; c < 127; ++c) reached.insert(window_action(c));
  for (int i = 0; i <= static_cast<int>(KeyAction::kHelp); ++i) {
    const auto action = static_cast<KeyAction>(i);
    EXPECT_TRUE(reached.contains(action)) << i;
  }
  for (const char32_t held : U"wasdrfWASDRF") EXPECT_EQ(window_action(held), KeyAction::kNone);
  EXPECT_EQ(window_action('m'), window_action('M'));
  EXPECT_EQ(window_action(0x1F600), KeyAction::kNone);
  const auto help = window_help();
  EXPECT_EQ(std::ranges::count(help[0], '\n'), std::ranges::count(help[1], '\n'));
  EXPECT_NE(help[1].find("roll"), std::string::npos);
}

TEST(ViewerKeys, AreHelpedInWindowsOfAnySize) {
  const auto lines = [](const std::string& text) {
    return static_cast<std::size_t>(std::ranges::count(text, '\n')) + 1;
  };
  const std::size_t all = lines(window_help()[0]);
  for (const std::size_t letters : {0U, 1U, 10U, 25U, 40U, 100U}) {
    for (const std::size_t most : {0U, 1U, 2U, 5U, 20U, 1000U}) {
      const auto [keys, texts] = window_help(letters, most);
      EXPECT_EQ(lines(keys), lines(texts));
      EXPECT_LE(lines(keys), std::max<std::size_t>(most, 1));
      if (most == 1000) {
        EXPECT_EQ(lines(keys) > all, letters < 60) << letters;
      }
      std::size_t longest = 0;
      for (std::size_t begin = 0; begin < texts.size();) {
        const std::size_t end = std::min(texts.find('\n', begin), texts.size());
        // A word may be longer than a line.
        if (texts.substr(begin, end - begin).find(' ') != std::string::npos)
          longest = std::max(longest, end - begin);
        begin = end + 1;
      }
      EXPECT_LE(longest, letters);
    }
  }
  EXPECT_EQ(broken_at_blanks("one two three four", 7), "one two\nthree\nfour");
  EXPECT_EQ(broken_at_blanks("one two three four", 7, 2), "one two\nthree ...");
  EXPECT_EQ(broken_at_blanks("abcdefghij", 4), "abcdefghij");
  EXPECT_EQ(broken_at_blanks("", 4), "");
}

/// Whatever a state says of itself.
std::string words(const ViewState& state) {
  return state.as_options() + (state.help ? " help" : "") + (state.rate ? " rate" : "") +
         (state.shown.occlusion ? " nooks" : "") + (state.shown.discs ? " discs" : "");
}

TEST(ViewerState, ChangesByEveryKeyAndBack) {
  ViewState first;
  first.cells = 100;
  first.shown.cut_away = 0.5;
  for (int i = 1; i <= static_cast<int>(KeyAction::kHelp); ++i) {
    const auto action = static_cast<KeyAction>(i);
    ViewState state = first;
    if (action == KeyAction::kFirstView) state.turn(10, 5);
    const std::string before = words(state);
    const Change change = state.act(action, first, kFocus);
    EXPECT_EQ(words(state) != before, change != Change::kNothing) << i;
  }
  // Choices come round again, and switches switch back.
  for (const auto& [action, times] : {std::pair{KeyAction::kChangeColour, kColourByCount},
                                      {KeyAction::kFaces, 2},
                                      {KeyAction::kTruncations, 2},
                                      {KeyAction::kLines, 2},
                                      {KeyAction::kHollow, 2},
                                      {KeyAction::kLabels, 2},
                                      {KeyAction::kTheme, 2}}) {
    ViewState state = first;
    for (int n = 0; n < times; ++n) state.act(action, first, kFocus);
    EXPECT_EQ(words(state), words(first)) << static_cast<int>(action);
  }
  ViewState state = first;
  for (int n = 0; n < 3; ++n)
    EXPECT_EQ(state.act(KeyAction::kChangeModel, first, kFocus), Change::kScene);
  EXPECT_EQ(state.shown.model, first.shown.model);
  EXPECT_FALSE(state.shown.cut_away);  // of another model
}

TEST(ViewerState, NeverHidesEverythingAndKeepsItsBounds) {
  ViewState first;
  ViewState state = first;
  state.act(KeyAction::kFaces, first, kFocus);
  state.act(KeyAction::kTruncations, first, kFocus);
  EXPECT_TRUE(state.shown.faces || state.shown.truncations);
  for (int n = 0; n < 200; ++n) state.act(KeyAction::kMoreCells, first, kFocus);
  EXPECT_EQ(state.cells, kMostDrawnCells);
  for (int n = 0; n < 200; ++n) state.act(KeyAction::kFewerCells, first, kFocus);
  EXPECT_EQ(state.cells, 1U);
  for (int n = 0; n < 200; ++n) state.turn(7, 3);
  EXPECT_LE(state.shown.camera.elevation, 89);
  EXPECT_LE(std::abs(state.shown.camera.azimuth), 180);
}

TEST(ViewerState, ZoomsToThePointer) {
  ViewState state;
  state.shift(0.3, -0.2);
  const BoundingBall ball{{0.1, 0.2, 0.3}, 1.5};
  const auto view = [&] { return view_of(state.shown.camera, ball, 400, 300); };
  // What is seen at a pixel: x to the right and y upwards in halves of the height.
  const double x = 0.6, y = -0.4;
  const Ray before = ray_through(view(), 400, 300, 200 + 150 * x, 150 - 150 * y);
  state.zoom(1.7, x, y);
  const Ray after = ray_through(view(), 400, 300, 200 + 150 * x, 150 - 150 * y);
  EXPECT_LT((before.direction - after.direction).norm(), 1e-12);
  EXPECT_NEAR(state.shown.camera.zoom, 1.7, 1e-15);
}

TEST(ViewerState, FliesByHyperbolicTranslations) {
  ViewState state;
  state.turn(40, 10);
  for (const Vector3& way : {Vector3(0, 0, 1), Vector3(1, 0, 0), Vector3(0, -1, 0)}) {
    ViewState moved_state = state;
    EXPECT_EQ(moved_state.fly(way, 0.7), Change::kPlaces);
    const Vector4 there = moved_state.motion.col(3);
    EXPECT_NEAR(geometry::hyperbolic_distance(there, geometry::origin()), 0.7, 1e-12);
    // Forwards, what was in the middle comes towards the eye.
    const View view = view_of(state.shown.camera, BoundingBall{Vector3::Zero(), 1}, 1, 1);
    const Vector3 in_eye_space =
        view.model_view.topLeftCorner<3, 3>() * there.head<3>() / std::sinh(0.7);
    EXPECT_LT((in_eye_space - Vector3(-way.x(), -way.y(), way.z())).norm(), 1e-12);
    moved_state.fly(-way, 0.7);
    EXPECT_LT((moved_state.motion - geometry::Matrix4::Identity()).norm(), 1e-12);
  }
  for (int n = 0; n < 1000; ++n) state.fly({0, 0, 1}, 0.1);
  EXPECT_LE(state.motion(3, 3), 1000);
  EXPECT_LT(geometry::orthogonality_defect(state.motion), 1e-9);
}

TEST(ViewerSlider, GoesThereAndBack) {
  for (const int width : {300, 1200}) {
    EXPECT_EQ(slider_value(-1e4, width, 600), 1U);
    EXPECT_EQ(slider_value(1e4, width, 600), kMostDrawnCells);
    for (const std::size_t cells : {std::size_t{1}, std::size_t{20}, std::size_t{5000}}) {
      const LegendRectangle handle = slider(cells, width, 600, 1).back();
      const double middle = (handle.left + handle.right) / 2;
      EXPECT_TRUE(is_on_slider(middle, (handle.top + handle.bottom) / 2, width, 600));
      EXPECT_NEAR(
          static_cast<double>(slider_value(middle, width, 600)) / static_cast<double>(cells), 1,
          1e-3);
    }
    EXPECT_FALSE(is_on_slider(10, 10, width, 600));
  }
}

TEST(ViewerWords, NameWhatReportsAndGluingsSay) {
  for (const char* signature : {"cPcbbbihq", "dLQbcccherw", "dLQbccchrqg"}) {
    const testing::Embedded m = *testing::try_embed(signature);
    embedding::UniversalCoverOptions options;
    options.max_cells = 30;
    Scene scene = make_scene("x", m.embedding,
                             embedding::universal_cover(m.embedding, m.triangulation, options),
                             geometry::Matrix4::Identity());
    add_classes(scene, m.triangulation, m.report.edge_lengths);
    for (std::size_t c = 0; c < scene.cells.size(); ++c) {
      const SceneCell& cell = scene.cells[c];
      const std::size_t t = cell.tetrahedron;
      for (std::size_t f = 0; f < 4; ++f) {
        // Glued faces have one number.
        const int face = static_cast<int>(f);
        const std::size_t other = m.triangulation.gluings().neighbour(t, face);
        const auto at = static_cast<std::size_t>(m.triangulation.gluings().gluing(t, face)(face));
        for (const SceneCell& each : scene.cells) {
          if (each.tetrahedron != other) continue;
          EXPECT_EQ(each.face_class[at], cell.face_class[f]);
        }
        const std::string text = describe(scene, c, f);
        EXPECT_EQ(text.find(fmt::format("tetrahedron {}, face {}", t, f)), 0U) << text;
        // Its three edges have both ends off the vertex f, and the lengths of the report.
        for (std::size_t v = 0; v < 4; ++v)
          for (std::size_t w = v + 1; w < 4; ++w) {
            const std::size_t e = m.triangulation.edge_classes()[6 * t + edge_between(v, w)];
            const std::string edge =
                fmt::format("{}{} of class {} (length {:.8g}", v, w, e, m.report.edge_lengths[e]);
            EXPECT_EQ(text.find(edge) != std::string::npos, v != f && w != f) << text << edge;
          }
      }
      EXPECT_EQ(describe(scene, c, 5),
                fmt::format("tetrahedron {}, truncation 1 of boundary component {}", t,
                            m.triangulation.vertex_classes()[4 * t + 1]));
    }
  }
}

}  // namespace
}  // namespace tripus::viewer
