// One line a comparison, and a count of those that failed.
#pragma once

#include <cstdio>
#include <string>

class Report {
public:
    void line(bool good, const std::string& name, const std::string& text) {
        ++(good ? passed : failed);
        // Hundreds of small sets pass in silence; each failure is told.
        if (!good || name.rfind("tiny", 0) != 0)
            std::printf("%-6s %-42s %s\n", good ? "ok" : "FAILED", name.c_str(), text.c_str());
        std::fflush(stdout);
    }
    // The exit code: failure also when nothing was compared.
    int finish(const char* what) const {
        std::printf("%s: %d passed, %d failed\n", what, passed, failed);
        return failed == 0 && passed > 0 ? 0 : 1;
    }

private:
    int passed = 0, failed = 0;
};
