// A test frame for C++: CHECK counts, THROWN gives the error of a call.
#pragma once

#include <medax.hpp>

#include <cstdio>

inline unsigned passed = 0, failed = 0;

inline void check(bool holds, const char *what, const char *file, int line) {
    ++(holds ? passed : failed);
    if (!holds) std::printf("%s:%d: failed: %s\n", file, line, what);
}
#define CHECK(condition) check((condition), #condition, __FILE__, __LINE__)

/// The error that the call throws; the call must throw one.
template <class Call>
medax::Error thrown(Call &&call, const char *file, int line) {
    try {
        call();
    } catch (const medax::Error &error) {
        check(true, "throws", file, line);
        return error;
    }
    check(false, "throws", file, line);
    return medax::Error(MEDAX_STATUS_OK);
}
#define THROWN(...) thrown([&] { __VA_ARGS__; }, __FILE__, __LINE__)
