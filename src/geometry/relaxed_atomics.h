// Threads that share plain numbers of a vector, and need no order between different ones: what std::atomic_ref does,
// which libc++ has from version 19 on, with std::memory_order_relaxed. Reading and writing cost as without threads.
#pragma once

namespace flowcert::geometry {

template <typename Number>
[[nodiscard]] Number relaxed_load(const Number& from) {
  return __atomic_load_n(&from, __ATOMIC_RELAXED);
}

template <typename Number>
void relaxed_store(Number& to, Number value) {
  __atomic_store_n(&to, value, __ATOMIC_RELAXED);
}

template <typename Number>
void relaxed_increment(Number& number) {
  __atomic_fetch_add(&number, Number{1}, __ATOMIC_RELAXED);
}

// Whether this call changed it, which one call of those with the same `before` does.
template <typename Number>
[[nodiscard]] bool relaxed_exchange(Number& number, Number before, Number after) {
  return __atomic_compare_exchange_n(&number, &before, after, false, __ATOMIC_RELAXED, __ATOMIC_RELAXED);
}

}  // namespace flowcert::geometry
