#include "topology/work_size.hpp"

#include <algorithm>

namespace tripus::topology {
namespace {

thread_local std::size_t largest_work = 0;

}  // namespace

std::size_t work_size() { return largest_work; }
void begin_work() { largest_work = 0; }
void note_work_size(std::size_t tetrahedra) { largest_work = std::max(largest_work, tetrahedra); }

}  // namespace tripus::topology
