#include "viewer/web/page_data.hpp"

#include <cmath>
#include <iterator>
#include <vector>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/version.hpp"
#include "embedding/colour.hpp"
#include "topology/covers/presentation.hpp"
#include "viewer/keys.hpp"
#include "viewer/web/detail/assets.hpp"

namespace tripus::viewer {
namespace {

using Text = fmt::memory_buffer;

void append_number(Text& out, double value) {
  if (!std::isfinite(value)) throw InternalError("a number for a page is not finite");
  fmt::format_to(std::back_inserter(out), "{}", value);
}
void append_number(Text& out, std::size_t value) {
  fmt::format_to(std::back_inserter(out), "{}", value);
}

/// [a,b,...] with one call of `append_item(i)` for each index.
template <class AppendItem>
void append_list(Text& out, std::size_t count, AppendItem&& append_item) {
  out.push_back('[');
  for (std::size_t i = 0; i < count; ++i) {
    if (i != 0) out.push_back(',');
    append_item(i);
  }
  out.push_back(']');
}

void append_key(Text& out, std::string_view key) {
  fmt::format_to(std::back_inserter(out), ",\"{}\":", key);
}

/// The numbers of a vector or, row by row, of a matrix.
template <class Matrix>
void append_entries(Text& out, const Matrix& matrix) {
  const auto columns = matrix.cols();
  append_list(out, static_cast<std::size_t>(matrix.size()), [&](std::size_t i) {
    const auto k = static_cast<Eigen::Index>(i);
    append_number(out, matrix(k / columns, k % columns));
  });
}

void append_topology(Text& out, const topology::Triangulation& m) {
  const std::size_t count = m.tetrahedron_count();
  fmt::format_to(std::back_inserter(out),
                 ",\"tetrahedron_count\":{},\"edge_count\":{},\"orientable\":{}", count,
                 m.edge_count(), m.is_orientable());
  append_key(out, "edge_valences");
  append_list(out, m.edge_count(), [&](std::size_t e) { append_number(out, m.valence(e)); });
  const auto table = [&](std::string_view key, auto numbers, std::size_t width) {
    append_key(out, key);
    append_list(out, count, [&](std::size_t t) {
      append_list(out, width,
                  [&](std::size_t i) { append_number(out, std::size_t{numbers[width * t + i]}); });
    });
  };
  table("edge_classes", m.edge_classes(), 6);
  table("vertex_classes", m.vertex_classes(), 4);
  append_key(out, "face_letters");
  const std::vector<topology::Letter> crossed = topology::fundamental_group(m).face_letters;
  append_list(out, count, [&](std::size_t t) {
    append_list(out, 4, [&](std::size_t f) {
      fmt::format_to(std::back_inserter(out), "{}", crossed[4 * t + f]);
    });
  });
  append_key(out, "gluings");
  append_list(out, count, [&](std::size_t t) {
    append_list(out, 4, [&](std::size_t f) {
      const auto letters = topology::word(m.gluings().gluing(t, static_cast<int>(f)));
      fmt::format_to(std::back_inserter(out), "[{},\"{}\"]",
                     m.gluings().neighbour(t, static_cast<int>(f)),
                     std::string_view(letters.data(), letters.size()));
    });
  });
}

void append_report(Text& out, const structure::Report& report) {
  append_key(out, "outcome");
  out.append(detail::json_string(to_string(report.outcome)));
  append_key(out, "message");
  out.append(detail::json_string(report.message));
  append_key(out, "volume");
  append_number(out, report.volume);
  append_key(out, "max_curvature");
  append_number(out, report.max_curvature);
  append_key(out, "edge_lengths");
  append_list(out, report.edge_lengths.size(),
              [&](std::size_t e) { append_number(out, report.edge_lengths[e]); });
  append_key(out, "vertices");
  append_list(out, report.vertices.size(), [&](std::size_t v) {
    fmt::format_to(std::back_inserter(out),
                   "{{\"genus\":{},\"kind\":\"{}\",\"area\":", report.vertices[v].genus,
                   topology::to_string(report.vertices[v].kind));
    append_number(out, report.vertices[v].area);
    out.push_back('}');
  });
}

void append_embedding(Text& out, const embedding::Embedding& embedding) {
  append_key(out, "tetrahedra");
  append_list(out, embedding.tetrahedra.size(), [&](std::size_t t) {
    const auto& tetrahedron = embedding.tetrahedra[t];
    out.append(std::string_view("{\"vertices\":"));
    append_list(out, 4, [&](std::size_t i) { append_entries(out, tetrahedron.vertices[i]); });
    append_key(out, "faces");
    append_list(out, 4, [&](std::size_t i) { append_entries(out, tetrahedron.faces[i]); });
    if (tetrahedron.diagonal != embedding::HyperboloidTetrahedron{}.diagonal) {
      append_key(out, "diagonal");
      append_list(out, 4, [&](std::size_t i) { append_number(out, tetrahedron.diagonal[i]); });
    }
    if (tetrahedron.parabolic_edges != 0) {
      append_key(out, "parabolic");
      append_number(out, std::size_t{tetrahedron.parabolic_edges});
      append_key(out, "scale");
      append_number(out, tetrahedron.parabolic_scale);
    }
    if (embedding.singular_edges[t] != 0) {
      append_key(out, "singular");
      append_number(out, std::size_t{embedding.singular_edges[t]});
    }
    out.push_back('}');
  });
  append_key(out, "horosphere_area");
  append_number(out, embedding.horosphere_area);
  // In words where the edge is singular, else empty.
  append_key(out, "cone_angles");
  append_list(out, embedding.cone_angles.size(), [&](std::size_t e) {
    const topology::ConeAngle& angle = embedding.cone_angles[e];
    out.append(
        detail::json_string(angle.is_full() ? std::string() : "order " + angle.order_text()));
  });
  append_key(out, "face_pairings");
  append_list(out, embedding.face_pairings.size(), [&](std::size_t t) {
    append_list(out, 4, [&](std::size_t f) { append_entries(out, embedding.face_pairings[t][f]); });
  });
}

template <class Rgb>
void append_colour(Text& out, const Rgb& rgb) {
  fmt::format_to(std::back_inserter(out), "\"#{:02x}{:02x}{:02x}\"", rgb[0], rgb[1], rgb[2]);
}

void append_colours(Text& out) {
  append_key(out, "colours");
  append_list(out, embedding::kColourCount, [&](std::size_t t) {
    append_colour(out, embedding::tetrahedron_colour(static_cast<std::uint32_t>(t)));
  });
}

/// The one list of keys: what they are, what they ask for, in words.
void append_keys(Text& out) {
  std::vector<KeyLine> lines;
  for (const KeyLine& line : key_lines())
    if (line.in_page) lines.push_back(line);
  append_key(out, "keys");
  append_list(out, lines.size(), [&](std::size_t i) {
    fmt::format_to(std::back_inserter(out), "[{},{},{}]", detail::json_string(lines[i].keys),
                   detail::json_string(lines[i].name), detail::json_string(lines[i].text));
  });
}

/// The discs of each tile as numbers, five each: the centre and the length.
void append_discs(Text& out, const WallDiscs& discs) {
  append_key(out, "discs");
  out.append(std::string_view("{\"length\":"));
  append_number(out, discs.length);
  append_key(out, "shortest");
  append_number(out, discs.scale.shortest);
  append_key(out, "longest");
  append_number(out, discs.scale.longest);
  append_key(out, "bare");
  append_colour(out, kBareWall);
  append_key(out, "colours");
  append_list(out, orthospectrum::kLengthColours.size(),
              [&](std::size_t i) { append_colour(out, orthospectrum::kLengthColours[i]); });
  append_key(out, "tiles");
  append_list(out, discs.tiles.size(), [&](std::size_t n) {
    append_list(out, discs.tiles[n].size(), [&](std::size_t i) {
      const WallDisc& disc = discs.tiles[n][i];
      const Vector4& p = disc.centre;
      // Shaders compute in single precision; the lengths are read by people.
      fmt::format_to(std::back_inserter(out), "{:.9g},{:.9g},{:.9g},{:.9g},{:.12g}", p[0], p[1],
                     p[2], p[3], disc.length);
    });
  });
  out.push_back('}');
}

void check(const PageOptions& options, const topology::Triangulation& triangulation,
           const structure::Report& report) {
  if (report.outcome != structure::Outcome::kGeometric)
    throw InvalidInput("a page shows a metric, and none was found: " + report.message);
  if (options.cells < 1 || options.cells > kMostPageCells) {
    throw InvalidInput(
        fmt::format("a page shows 1 to {} cells, not {}", kMostPageCells, options.cells));
  }
  if (options.model != "ball" && options.model != "upper" && options.model != "klein")
    throw InvalidInput("a page knows the models ball, upper and klein, not " +
                       quoted(options.model));
  if (triangulation.tetrahedron_count() > kMostPageTetrahedra) {
    throw Unsupported(fmt::format("a page shows manifolds of up to {} tetrahedra, not {}",
                                  kMostPageTetrahedra, triangulation.tetrahedron_count()));
  }
}

}  // namespace

std::string page_data(const PageOptions& options, const topology::Triangulation& triangulation,
                      const structure::Report& report, const embedding::Embedding& embedding) {
  check(options, triangulation, report);
  Text out;
  out.append(std::string_view("{\"tripus\":"));
  out.append(detail::json_string(kVersion));
  append_key(out, "name");
  out.append(detail::json_string(options.name));
  append_key(out, "isosig");
  out.append(options.isosig.empty() ? std::string("null") : detail::json_string(options.isosig));
  append_key(out, "cells_shown");
  append_number(out, options.cells);
  append_key(out, "model_shown");
  out.append(detail::json_string(options.model));
  append_key(out, "view_shown");
  out.append(detail::json_string(options.inside ? "inside" : "outside"));
  append_topology(out, triangulation);
  append_report(out, report);
  append_embedding(out, embedding);
  append_colours(out);
  append_keys(out);
  if (options.discs != nullptr) append_discs(out, *options.discs);
  out.push_back('}');
  return fmt::to_string(out);
}

}  // namespace tripus::viewer
