#pragma once

#include <string>
#include <string_view>

#include "meshing/tube/spatial_graph.hpp"

namespace tripus::meshing {

/// Reads a graph in space in whatever format the content has: Tripus's JSON, Geomview's VECT, the
/// lines of a Wavefront OBJ, or a list of points, one a line, with an empty line between the
/// polylines. In the last three a point where three or more pieces meet is a vertex; pieces that
/// close up make a knot. A list that touches nothing else is closed from its last point to its
/// first; an end of a VECT or OBJ line that touches nothing is loose, as in JSON.
/// Throws InvalidInput with the line; what read_spatial_graph throws for JSON.
SpatialGraph read_graph(std::string_view content);

/// Whether the content is such a graph in a format of drawings alone: VECT, an OBJ with lines and
/// no faces, or a list of points that can be read as one. JSON has to be told by its keys.
bool is_drawn_graph(std::string_view content);

/// The names of the formats, for messages.
std::string graph_format_names();

/// The lines (l) of a Wavefront OBJ, also cut into single pieces as Blender writes them.
/// Throws InvalidInput with the line; for a file that has faces or no lines.
SpatialGraph read_obj_lines(std::string_view text);

/// Whether a Wavefront OBJ has lines and no faces.
bool has_only_lines(std::string_view text);

/// Points as three numbers a line, with spaces, commas or semicolons between them; empty lines
/// between polylines. A polyline neither end of which is a point of another is closed.
/// Throws InvalidInput with the line.
SpatialGraph read_point_lists(std::string_view text);

/// Geomview's VECT (also 4VECT), as KnotPlot and others write it; a negative number of points makes
/// a polyline closed. Colours are skipped. Throws InvalidInput with the line.
SpatialGraph read_vect(std::string_view text);

}  // namespace tripus::meshing
