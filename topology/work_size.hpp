#pragma once

#include <cstddef>

namespace tripus::topology {

/// How many tetrahedra the largest triangulation had that this thread has made since
/// `begin_work`: what to say where memory has run out, and nobody up the stack knows any more.
std::size_t work_size();
void begin_work();
void note_work_size(std::size_t tetrahedra);

}  // namespace tripus::topology
