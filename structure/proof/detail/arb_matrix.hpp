#pragma once

#include <cstddef>

#include <arb_mat.h>

namespace tripus::structure::detail {

/// A matrix of Arb's balls, all 0 at first.
class ArbMatrix {
 public:
  ArbMatrix(std::size_t rows, std::size_t columns) {
    arb_mat_init(m_, static_cast<long>(rows), static_cast<long>(columns));
  }
  ~ArbMatrix() { arb_mat_clear(m_); }
  ArbMatrix(const ArbMatrix&) = delete;
  ArbMatrix& operator=(const ArbMatrix&) = delete;
  arb_mat_struct* get() { return m_; }
  arb_ptr at(std::size_t i, std::size_t j) {
    return arb_mat_entry(m_, static_cast<long>(i), static_cast<long>(j));
  }

 private:
  arb_mat_t m_;
};

}  // namespace tripus::structure::detail
