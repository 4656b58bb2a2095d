// SPDX-License-Identifier: MIT OR Apache-2.0
#pragma once

/// \file
/// How files are written, and what they did not hold.

#include <medax/handle.hpp>

#include <cstddef>

namespace medax {

using WriteOptions = detail::Options<medax_write_options, medax_write_options_init>;

/// Sentences about what a file did not hold, or what was left out of it.
class Warnings
    : public detail::Handle<medax_warnings, medax_warnings_clone, medax_warnings_free> {
public:
    /// Takes over a reference that a function of medax.h gave.
    explicit Warnings(const medax_warnings *owned) noexcept : Handle(owned) {}

    std::size_t count() const noexcept { return medax_warnings_count(get()); }
    bool empty() const noexcept { return count() == 0; }
    /// Lives as long as any object that shares the handle.
    const char *operator[](std::size_t index) const noexcept {
        return medax_warnings_text(get(), index);
    }
};

}  // namespace medax
