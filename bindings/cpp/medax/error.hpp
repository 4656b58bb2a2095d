// SPDX-License-Identifier: MIT OR Apache-2.0
#pragma once

/// \file
/// What a call that fails throws, and which library answers.

#include <medax.h>

#include <cstdint>
#include <stdexcept>
#include <string>

namespace medax {

/// A call that failed: what() is a sentence for a person.
class Error : public std::runtime_error {
public:
    /// This thread's last error, of the call that returned `status`.
    explicit Error(medax_status status)
        : std::runtime_error(medax_last_error_message()),
          status_(status),
          kind_(static_cast<medax_error_kind>(medax_last_error_kind())),
          index_(medax_last_error_index()) {}

    /// One that did not come from the library.
    Error(medax_status status, const std::string &message, medax_error_kind kind = MEDAX_ERROR_KIND_NONE,
          std::uint64_t index = UINT64_MAX)
        : std::runtime_error(message), status_(status), kind_(kind), index_(index) {}

    medax_status status() const noexcept { return status_; }
    /// The kind of the offending element, MEDAX_ERROR_KIND_NONE if there is none.
    medax_error_kind kind() const noexcept { return kind_; }
    /// The index of the offending element, UINT64_MAX if there is none.
    std::uint64_t index() const noexcept { return index_; }

private:
    medax_status status_;
    medax_error_kind kind_;
    std::uint64_t index_;
};

/// The name of a status, such as MEDAX_STATUS_NON_FINITE.
inline const char *name(medax_status status) { return medax_status_name(status); }

/// The version of the library that is linked, which is MEDAX_VERSION if the headers are its own.
inline std::uint32_t version() noexcept { return medax_version(); }
/// The same as text, such as `0.1.0`.
inline const char *version_string() noexcept { return medax_version_string(); }

}  // namespace medax
