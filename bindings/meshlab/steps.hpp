// SPDX-License-Identifier: MIT OR Apache-2.0
#pragma once

/// \file
/// The progress of a filter that runs several builds of medax.

#include <medax.hpp>

#include <functional>
#include <string>
#include <utility>

namespace medax_meshlab {

/// One job for all builds of a filter. Each build is a step, from where the last one ended to its own share of the whole.
class Steps {
public:
    /// Told the percentage and what is being done; false cancels.
    using Report = std::function<bool(int percent, const char *doing)>;

    explicit Steps(Report report) : report_(std::move(report)), job_(options()) {}
    // The job's callback points here.
    Steps(const Steps &) = delete;
    Steps &operator=(const Steps &) = delete;

    /// The job, for a build that ends at this percentage of the whole.
    const medax::Job &until(int percent, const char *doing) {
        begin_ = end_;
        end_ = percent;
        doing_ = doing;
        // A short build calls nobody; a cancelled job makes the next build fail at once.
        if (!report_(begin_, doing_.c_str())) job_.cancel();
        return job_;
    }

private:
    medax::JobOptions options() {
        medax::JobOptions options;
        options.progress = [this](double progress, const char *) {
            const int percent = begin_ + static_cast<int>(progress * (end_ - begin_));
            return report_(percent, doing_.c_str()) ? medax::Next::go_on : medax::Next::cancel;
        };
        return options;
    }

    Report report_;
    int begin_ = 0, end_ = 0;
    std::string doing_;
    medax::Job job_;
};

}  // namespace medax_meshlab
