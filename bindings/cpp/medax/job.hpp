// SPDX-License-Identifier: MIT OR Apache-2.0
#pragma once

/// \file
/// How to run a build, and what the check of a structure found.

#include <medax/handle.hpp>

#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

namespace medax {

/// What a progress function asks for.
enum class Next { go_on, cancel };

/// The settings of a job.
struct JobOptions {
    /// The most threads that builds may use; 0: what MEDAX_THREADS says, or one per processor.
    std::uint32_t threads = 0;
    /// The most bytes that a build's own arrays may take at once; 0: no ceiling.
    std::uint64_t memory_ceiling = 0;
    /// Called on the building thread, at most twenty times a second. What it throws cancels the
    /// build, and comes out of it.
    std::function<Next(double progress, const char *stage)> progress;
};

/// How to run builds, and the handle to watch or cancel them from any thread.
class Job : public detail::Handle<medax_job, medax_job_clone, medax_job_free> {
public:
    explicit Job(const JobOptions &options = {})
        : Job(std::make_shared<Callback>(options.progress), options) {}

    /// With a progress function alone: `Job::watched([&](double progress, const char *stage) { ... })`. It returns what is asked
    /// for, or nothing, and then only watches.
    template <class Function>
    static Job watched(Function function) {
        JobOptions options;
        if constexpr (std::is_void_v<std::invoke_result_t<Function &, double, const char *>>)
            options.progress = [function](double progress, const char *stage) mutable {
                function(progress, stage);
                return Next::go_on;
            };
        else
            options.progress = std::move(function);
        return Job(options);
    }
    /// Stands for a fresh job with default options in each build.
    static Job fresh() noexcept { return Job(nullptr); }

    void cancel() const noexcept { medax_job_cancel(get()); }
    bool is_cancelled() const noexcept { return medax_job_is_cancelled(get()); }
    double progress() const noexcept { return medax_job_progress(get()); }
    const char *stage() const noexcept { return medax_job_stage(get()); }
    std::uint64_t memory_peak() const noexcept { return medax_job_memory_peak(get()); }

    struct StageTime {
        const char *stage;
        double wall_seconds, cpu_seconds;
    };
    /// The time of every stage of every build so far.
    std::vector<StageTime> times() const {
        std::vector<StageTime> times(medax_job_stage_count(get()));
        for (std::size_t i = 0; i < times.size(); ++i) {
            StageTime &time = times[i];
            detail::check(medax_job_stage_time(get(), i, &time.stage, &time.wall_seconds,
                                               &time.cpu_seconds));
        }
        return times;
    }

    /// Throws what a build with this job failed with, if it failed.
    void check(medax_status status) const {
        if (status == MEDAX_STATUS_OK) return;
        if (const std::exception_ptr thrown = callback_ ? callback_->take() : nullptr)
            std::rethrow_exception(thrown);
        throw Error(status);
    }

private:
    /// What the payload points at: it lives as long as a job that has it.
    struct Callback {
        explicit Callback(std::function<Next(double, const char *)> called)
            : function(std::move(called)) {}

        void keep(std::exception_ptr exception) {
            const std::lock_guard<std::mutex> lock(mutex);
            thrown = std::move(exception);
            thrower = std::this_thread::get_id();
        }
        /// What was thrown on this thread. Others learn that the job is busy, or cancelled.
        std::exception_ptr take() {
            const std::lock_guard<std::mutex> lock(mutex);
            if (thrower != std::this_thread::get_id()) return nullptr;
            return std::exchange(thrown, nullptr);
        }

        const std::function<Next(double, const char *)> function;

    private:
        std::mutex mutex;
        std::exception_ptr thrown;
        std::thread::id thrower;
    };

    explicit Job(std::nullptr_t) noexcept : Handle(nullptr) {}
    Job(std::shared_ptr<Callback> callback, const JobOptions &options)
        : Handle(create(callback.get(), options)), callback_(std::move(callback)) {}

    static const medax_job *create(Callback *callback, const JobOptions &options) {
        medax_job_options given;
        detail::check(medax_job_options_init(&given, sizeof given));
        given.threads = options.threads;
        given.memory_ceiling = options.memory_ceiling;
        if (callback->function) {
            given.progress = trampoline;
            given.payload = callback;
        }
        const medax_job *job = nullptr;
        detail::check(medax_job_create(&given, &job));
        return job;
    }

    static std::int32_t trampoline(double progress, const char *stage, void *payload) noexcept {
        auto *callback = static_cast<Callback *>(payload);
        try {
            return callback->function(progress, stage) == Next::go_on ? 0 : 1;
        } catch (...) {
            callback->keep(std::current_exception());
            return 1;
        }
    }

    std::shared_ptr<Callback> callback_;
};

/// What the check of a structure found.
struct Validation : medax_validation {
    bool is_valid() const noexcept { return problems == 0; }
};

namespace detail {

template <class T>
Validation validated(medax_status (*validate)(const T *, const medax_job *, medax_validation *),
                     const T *handle, const Job &job) {
    Validation report;
    report.struct_size = sizeof(medax_validation);
    job.check(validate(handle, job.get(), &report));
    return report;
}

}  // namespace detail

}  // namespace medax
