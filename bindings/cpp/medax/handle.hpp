// SPDX-License-Identifier: MIT OR Apache-2.0
#pragma once

/// \file
/// What every class is made of: a counted reference, and sized options.

#include <medax/view.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>

namespace medax {

namespace detail {

inline View<double> view(medax_view_f64 v) noexcept { return {v.data, v.rows, v.cols}; }
inline View<std::uint8_t> view(medax_view_u8 v) noexcept { return {v.data, v.rows, v.cols}; }
inline View<std::uint32_t> view(medax_view_u32 v) noexcept { return {v.data, v.rows, v.cols}; }

inline void check(medax_status status) {
    if (status != MEDAX_STATUS_OK) throw Error(status);
}

/// One counted reference.
template <class T, const T *(*Clone)(const T *), void (*Free)(const T *)>
class Handle {
public:
    Handle(const Handle &other) noexcept : handle_(Clone(other.handle_)) {}
    Handle(Handle &&other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
    Handle &operator=(Handle other) noexcept {
        std::swap(handle_, other.handle_);
        return *this;
    }
    ~Handle() { Free(handle_); }

    /// The handle for the functions of medax.h; it stays this object's.
    const T *get() const noexcept { return handle_; }

protected:
    /// Takes a reference over.
    explicit Handle(const T *owned) noexcept : handle_(owned) {}

private:
    const T *handle_;
};

/// A sized struct at its defaults.
template <class T, medax_status (*Init)(T *, std::size_t)>
struct Options : T {
    Options() { check(Init(this, sizeof(T))); }
};

}  // namespace detail

}  // namespace medax
