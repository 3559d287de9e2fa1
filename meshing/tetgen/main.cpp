// The program tripus-tetgen: TetGen in a process of its own, for two reasons. The library ends with
// a segmentation fault on some input, and it is under the AGPL, so that nothing else is linked to
// it. Started by meshing::tetrahedralize with a socket as standard input and the number of its
// parent as argument; answers one request and ends.
#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <vector>

#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#define TETLIBRARY
#include <tetgen.h>

#include "meshing/detail/tetgen_protocol.hpp"

namespace {

using tripus::meshing::detail::TetgenRequest;
using tripus::meshing::detail::TetgenResponse;
using tripus::meshing::detail::TetgenStatus;

bool read_all(void* data, std::size_t size) {
  auto* bytes = static_cast<char*>(data);
  while (size > 0) {
    const ssize_t count = read(STDIN_FILENO, bytes, size);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    bytes += count;
    size -= static_cast<std::size_t>(count);
  }
  return true;
}

bool send_all(const void* data, std::size_t size) {
  const auto* bytes = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t count = send(STDIN_FILENO, bytes, size, MSG_NOSIGNAL);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    bytes += count;
    size -= static_cast<std::size_t>(count);
  }
  return true;
}

void limit(int resource, rlim_t value) {
  if (value == 0) return;
  const rlimit both{value, value};
  setrlimit(static_cast<decltype(RLIMIT_CPU)>(resource), &both);
}

/// No core file, no more memory and time than was granted, and no life after the parent's.
void bind_process(const TetgenRequest& request) {
  const rlimit none{0, 0};
  setrlimit(RLIMIT_CORE, &none);
#if !defined(TRIPUS_SANITIZED)  // its shadow memory is beyond any limit
  limit(RLIMIT_AS, request.memory_limit);
#endif
  limit(RLIMIT_CPU, request.processor_seconds);
}

struct Surface {
  std::vector<double> points, holes;
  std::vector<std::uint32_t> triangles;
};

/// The arrays are grown as they arrive, so that a wrong count is not believed.
template <class Number>
bool read_numbers(std::vector<Number>& numbers, std::uint64_t count) {
  constexpr std::uint64_t kBlock = 1 << 20;
  while (numbers.size() < count) {
    const std::size_t old = numbers.size();
    numbers.resize(std::min<std::uint64_t>(count, old + kBlock));
    if (!read_all(&numbers[old], (numbers.size() - old) * sizeof(Number))) return false;
  }
  return true;
}

/// TetGen frees what it is given with delete[].
void fill(tetgenio& in, const Surface& surface) {
  in.firstnumber = 0;
  in.numberofpoints = static_cast<int>(surface.points.size() / 3);
  in.pointlist = new REAL[surface.points.size()];
  std::copy(surface.points.begin(), surface.points.end(), in.pointlist);
  in.numberofholes = static_cast<int>(surface.holes.size() / 3);
  if (in.numberofholes > 0) {
    in.holelist = new REAL[surface.holes.size()];
    std::copy(surface.holes.begin(), surface.holes.end(), in.holelist);
  }
  in.numberoffacets = static_cast<int>(surface.triangles.size() / 3);
  in.facetlist = new tetgenio::facet[surface.triangles.size() / 3];
  for (std::size_t t = 0; t < surface.triangles.size() / 3; ++t) {
    tetgenio::facet& facet = in.facetlist[t];
    tetgenio::init(&facet);
    facet.numberofpolygons = 1;
    facet.polygonlist = new tetgenio::polygon[1];
    facet.polygonlist->numberofvertices = 3;
    facet.polygonlist->vertexlist = new int[3];
    for (std::size_t k = 0; k < 3; ++k)
      facet.polygonlist->vertexlist[k] = static_cast<int>(surface.triangles[3 * t + k]);
  }
}

/// TetGen reports its errors by throwing integers.
std::uint64_t run(tetgenio& in, tetgenio& out, const TetgenRequest& request) {
  try {
    tetgenbehavior options;
    char keeping[] = "pYQ", splitting[] = "pQ";
    if (!options.parse_commandline(request.keep_boundary != 0 ? keeping : splitting))
      return static_cast<std::uint64_t>(TetgenStatus::kInternal);
    if (request.max_volume > 0) {
      options.quality = 1;
      options.fixedvolume = 1;
      options.maxvolume = request.max_volume;
    }
    tetrahedralize(&options, &in, &out);
    return 0;
  } catch (const int code) {
    return code > 0 ? static_cast<std::uint64_t>(code) : 2;
  } catch (const std::bad_alloc&) {
    return static_cast<std::uint64_t>(TetgenStatus::kOutOfMemory);
  }
}

bool answer(const TetgenRequest& request) {
  Surface surface;
  if (!read_numbers(surface.points, 3 * request.points) ||
      !read_numbers(surface.triangles, 3 * request.triangles) ||
      !read_numbers(surface.holes, 3 * request.holes))
    return false;
  // Never destroyed: nobody needs TetGen's clean-up, which may crash as well.
  static tetgenio& in = *new tetgenio;
  static tetgenio& out = *new tetgenio;
  fill(in, surface);
  TetgenResponse response;
  response.status = run(in, out, request);
  if (response.status != 0) return send_all(&response, sizeof response);
  response.points = static_cast<std::uint64_t>(out.numberofpoints);
  response.tetrahedra = static_cast<std::uint64_t>(out.numberoftetrahedra);
  static_assert(sizeof(int) == sizeof(std::uint32_t) && sizeof(REAL) == sizeof(double));
  return out.numberofcorners == 4 && send_all(&response, sizeof response) &&
         send_all(out.pointlist, 3 * response.points * sizeof(REAL)) &&
         send_all(out.tetrahedronlist, 4 * response.tetrahedra * sizeof(int));
}

}  // namespace

int main(int argc, char** argv) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  // The parent may have ended before that line.
  if (argc != 2 || getppid() != static_cast<pid_t>(std::atol(argv[1]))) return 2;
  TetgenRequest request;
  if (!read_all(&request, sizeof request) || request.mark != TetgenRequest::kMark) return 2;
  constexpr std::uint64_t kMost = 1u << 30;
  if (request.points > kMost || request.triangles > kMost || request.holes > kMost) return 2;
  bind_process(request);
  bool done = false;
  try {
    done = answer(request);
  } catch (const std::bad_alloc&) {
    TetgenResponse response;
    response.status = static_cast<std::uint64_t>(TetgenStatus::kOutOfMemory);
    done = send_all(&response, sizeof response);
  }
  return done ? 0 : 1;
}
