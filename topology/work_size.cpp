#include "topology/work_size.hpp"

#include <algorithm>

namespace tripus::topology {
namespace {

thread_local std::size_t largest = 0;

}  // namespace

std::size_t work_size() { return largest; }
void begin_work() { largest = 0; }
void note_work_size(std::size_t tetrahedra) { largest = std::max(largest, tetrahedra); }

}  // namespace tripus::topology
