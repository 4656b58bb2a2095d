// SPDX-License-Identifier: MIT OR Apache-2.0
#pragma once

/// \file
/// Arrays that belong to another object, and the values in them.

#include <medax/error.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace medax {

/// "No such element": the only sentinel in any index array.
inline constexpr std::uint32_t none = MEDAX_NONE;

/// A point in input units.
using Point = std::array<double, 3>;

/// Values in succession that belong to another object.
template <class T>
class Span {
public:
    Span() noexcept = default;
    Span(const T *data, std::size_t size) noexcept : data_(data), size_(size) {}

    const T *data() const noexcept { return data_; }
    std::size_t size() const noexcept { return size_; }
    bool empty() const noexcept { return size_ == 0; }
    const T *begin() const noexcept { return data_; }
    const T *end() const noexcept { return data_ + size_; }
    const T &operator[](std::size_t i) const noexcept { return data_[i]; }

private:
    const T *data_ = nullptr;
    std::size_t size_ = 0;
};

/// Rows of equal length, row-major, that belong to another object: view[i][j]. The range is that of
/// all values.
template <class T>
class View {
public:
    View() noexcept = default;
    View(const T *data, std::size_t rows, std::size_t cols) noexcept
        : data_(data), rows_(rows), cols_(cols) {}

    const T *data() const noexcept { return data_; }
    std::size_t rows() const noexcept { return rows_; }
    std::size_t cols() const noexcept { return cols_; }
    /// The number of values.
    std::size_t size() const noexcept { return rows_ * cols_; }
    bool empty() const noexcept { return rows_ == 0; }
    const T *begin() const noexcept { return data_; }
    const T *end() const noexcept { return data_ + size(); }
    Span<T> operator[](std::size_t row) const noexcept { return {data_ + row * cols_, cols_}; }

private:
    const T *data_ = nullptr;
    std::size_t rows_ = 0;
    std::size_t cols_ = 0;
};

/// Rows of varying length that belong to another object: rows[i][j].
class Rows {
public:
    Rows() noexcept = default;
    explicit Rows(medax_view_rows view) noexcept : view_(view) {}

    std::size_t rows() const noexcept { return view_.rows; }
    bool empty() const noexcept { return view_.rows == 0; }
    Span<std::uint32_t> operator[](std::size_t row) const noexcept {
        const std::uint32_t begin = view_.offsets[row], end = view_.offsets[row + 1];
        return begin == end ? Span<std::uint32_t>() : Span(view_.indices + begin, end - begin);
    }
    /// rows() + 1 positions in indices(); none without a handle.
    Span<std::uint32_t> offsets() const noexcept {
        return {view_.offsets, view_.offsets == nullptr ? 0 : view_.rows + 1};
    }
    /// All rows, one after the other.
    Span<std::uint32_t> indices() const noexcept {
        return {view_.indices, view_.offsets == nullptr ? 0 : view_.offsets[view_.rows]};
    }

private:
    medax_view_rows view_{};
};

}  // namespace medax
