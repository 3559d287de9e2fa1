#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

namespace tripus::python {

namespace nb = nanobind;

template <class T>
using Array = nb::ndarray<nb::numpy, T>;

/// Imports numpy, once, before nanobind does: a Ctrl-C during that would break it.
void require_numpy();

/// A numpy array that owns its numbers.
template <class T>
Array<T> owned(std::vector<T> values, std::initializer_list<std::size_t> shape) {
  require_numpy();
  auto holder = std::make_unique<std::vector<T>>(std::move(values));
  T* data = holder->data();
  nb::capsule owner(holder.release(),
                    [](void* p) noexcept { delete static_cast<std::vector<T>*>(p); });
  return Array<T>(data, shape, owner);
}

template <class T>
Array<T> owned(std::vector<T> values) {
  const std::size_t size = values.size();
  return owned(std::move(values), {size});
}

/// A read-only numpy array of numbers that `owner` keeps: no copy.
template <class T>
Array<const T> view(const T* data, std::initializer_list<std::size_t> shape, nb::handle owner) {
  require_numpy();
  return Array<const T>(data, shape, owner);
}

/// The numbers of small fixed-size matrices, row by row, as one array [n x rows x columns].
template <class Matrix>
Array<double> stacked(const std::vector<Matrix>& matrices) {
  constexpr auto kRows = std::size_t(Matrix::RowsAtCompileTime);
  constexpr auto kColumns = std::size_t(Matrix::ColsAtCompileTime);
  std::vector<double> values;
  values.reserve(matrices.size() * kRows * kColumns);
  for (const Matrix& m : matrices)
    for (std::size_t i = 0; i < kRows; ++i)
      for (std::size_t j = 0; j < kColumns; ++j)
        values.push_back(m(Eigen::Index(i), Eigen::Index(j)));
  return owned(std::move(values), {matrices.size(), kRows, kColumns});
}

}  // namespace tripus::python
