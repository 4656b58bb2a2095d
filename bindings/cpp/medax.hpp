// SPDX-License-Identifier: MIT OR Apache-2.0
#pragma once

/// \file medax.hpp
/// medax for C++17: the C ABI of medax.h with destructors and exceptions. Header only.
///
/// - Every class holds one counted reference to an immutable handle. Copies share it, and any
///   thread may use any of them. An object that was moved from holds none: it has no rows.
/// - What fails throws medax::Error, or what the progress function threw.
/// - Views borrow: they are valid while an object that shares the handle lives.
/// - Units, lengths, costs and errors of each function are in medax.h, under the same name.

#include <medax.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace medax {

/// "No such element": the only sentinel in any index array.
inline constexpr std::uint32_t none = MEDAX_NONE;

/// A point in input units.
using Point = std::array<double, 3>;

// ---- Errors ------------------------------------------------------------------------------------

/// A call that failed: what() is a sentence for a person.
class Error : public std::runtime_error {
public:
    /// This thread's last error, of the call that returned `status`.
    explicit Error(medax_status status)
        : std::runtime_error(medax_last_error_message()),
          status_(status),
          kind_(static_cast<medax_error_kind>(medax_last_error_kind())),
          index_(medax_last_error_index()) {}

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

// ---- Views -------------------------------------------------------------------------------------

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

// ---- What every class is made of ------------------------------------------------------------------

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

// ---- Job ---------------------------------------------------------------------------------------

/// What a progress function asks for.
enum class Next { go_on, cancel };

/// The settings of a job.
struct JobOptions {
    /// The number of threads; 0: one per processor.
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
        : Job(std::make_shared<Callback>(Callback{options.progress, nullptr}), options) {}

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
        if (callback_ && callback_->thrown)
            std::rethrow_exception(std::exchange(callback_->thrown, nullptr));
        throw Error(status);
    }

private:
    /// What the payload points at: it lives as long as a job that has it.
    struct Callback {
        std::function<Next(double, const char *)> function;
        /// Written and read only on the thread that builds.
        std::exception_ptr thrown;
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
            callback->thrown = std::current_exception();
            return 1;
        }
    }

    std::shared_ptr<Callback> callback_;
};

// ---- Validation --------------------------------------------------------------------------------

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

// ---- Files -------------------------------------------------------------------------------------

using WriteOptions = detail::Options<medax_write_options, medax_write_options_init>;

/// Sentences about what a file did not hold, or what was left out of it.
class Warnings
    : public detail::Handle<medax_warnings, medax_warnings_clone, medax_warnings_free> {
public:
    /// Takes over a reference that a function of medax.h gave.
    explicit Warnings(const medax_warnings *owned) noexcept : Handle(owned) {}

    std::size_t count() const noexcept { return medax_warnings_count(get()); }
    bool empty() const noexcept { return count() == 0; }
    const char *operator[](std::size_t index) const noexcept {
        return medax_warnings_text(get(), index);
    }
};

// ---- Points ------------------------------------------------------------------------------------

using PointsOptions = detail::Options<medax_points_options, medax_points_options_init>;

/// An axis-parallel box.
struct Bounds {
    Point min, max;
};

/// Distinct points in spatial order, with maps from and to the input's rows.
class Points : public detail::Handle<medax_points, medax_points_clone, medax_points_free> {
public:
    /// Takes over a reference that a function of medax.h gave.
    explicit Points(const medax_points *owned) noexcept : Handle(owned) {}

    /// Copies `count` points, `stride_bytes` apart; 0 stands for no gap.
    static Points from(const double *xyz, std::size_t count, std::size_t stride_bytes = 0,
                       const PointsOptions &options = {}, const Job &job = Job::fresh()) {
        const medax_points *points = nullptr;
        job.check(medax_points_create_f64(xyz, count, stride_bytes, &options, job.get(), &points));
        return Points(points);
    }
    static Points from(const float *xyz, std::size_t count, std::size_t stride_bytes = 0,
                       const PointsOptions &options = {}, const Job &job = Job::fresh()) {
        const medax_points *points = nullptr;
        job.check(medax_points_create_f32(xyz, count, stride_bytes, &options, job.get(), &points));
        return Points(points);
    }
    static Points from(const std::vector<Point> &xyz, const PointsOptions &options = {},
                       const Job &job = Job::fresh()) {
        return from(xyz.empty() ? nullptr : xyz.front().data(), xyz.size(), 0, options, job);
    }
    static Points read(const std::string &path_utf8, const PointsOptions &options = {},
                       const Job &job = Job::fresh()) {
        const medax_points *points = nullptr;
        job.check(medax_points_read(path_utf8.c_str(), &options, job.get(), &points));
        return Points(points);
    }
    Warnings write(const std::string &path_utf8, const WriteOptions &options = {},
                   const Job &job = Job::fresh()) const {
        const medax_warnings *warnings = nullptr;
        job.check(medax_points_write(get(), path_utf8.c_str(), &options, job.get(), &warnings));
        return Warnings(warnings);
    }

    View<double> coords() const noexcept { return detail::view(medax_points_coords(get())); }
    View<std::uint32_t> vertex_of_row() const noexcept {
        return detail::view(medax_points_vertex_of_row(get()));
    }
    View<std::uint32_t> row_of_vertex() const noexcept {
        return detail::view(medax_points_row_of_vertex(get()));
    }
    View<std::uint32_t> duplicate_of() const noexcept {
        return detail::view(medax_points_duplicate_of(get()));
    }
    std::size_t count() const noexcept { return medax_points_count(get()); }
    std::size_t row_count() const noexcept { return medax_points_row_count(get()); }
    std::size_t duplicate_count() const noexcept { return medax_points_duplicate_count(get()); }
    std::size_t skipped_count() const noexcept { return medax_points_skipped_count(get()); }
    Bounds bounds() const {
        Bounds bounds;
        detail::check(medax_points_bounds(get(), bounds.min.data(), bounds.max.data()));
        return bounds;
    }
};

// ---- Complex -----------------------------------------------------------------------------------

using ComplexParts = detail::Options<medax_complex_parts, medax_complex_parts_init>;

/// Values with a name on one kind of element; one of the two views has no row.
struct Attribute {
    const char *name;
    medax_element element;
    medax_value_type value_type;
    View<double> f64_values;
    View<std::uint32_t> u32_values;

    explicit Attribute(const medax_attribute &found) noexcept
        : name(found.name),
          element(static_cast<medax_element>(found.element)),
          value_type(static_cast<medax_value_type>(found.value_type)),
          f64_values(detail::view(found.f64_values)),
          u32_values(detail::view(found.u32_values)) {}
};

using Topology = medax_topology;
using Comparison = medax_comparison;
using CompareOptions = detail::Options<medax_compare_options, medax_compare_options_init>;

/// Vertices, polygons, loose edges, volume cells and named attributes.
class Complex : public detail::Handle<medax_complex, medax_complex_clone, medax_complex_free> {
public:
    /// Takes over a reference that a function of medax.h gave.
    explicit Complex(const medax_complex *owned) noexcept : Handle(owned) {}

    static Complex from(const ComplexParts &parts) {
        const medax_complex *complex = nullptr;
        detail::check(medax_complex_create(&parts, &complex));
        return Complex(complex);
    }
    static Complex read(const std::string &path_utf8, const Job &job = Job::fresh()) {
        const medax_complex *complex = nullptr;
        job.check(medax_complex_read(path_utf8.c_str(), job.get(), &complex));
        return Complex(complex);
    }
    Warnings write(const std::string &path_utf8, const WriteOptions &options = {},
                   const Job &job = Job::fresh()) const {
        const medax_warnings *warnings = nullptr;
        job.check(medax_complex_write(get(), path_utf8.c_str(), &options, job.get(), &warnings));
        return Warnings(warnings);
    }

    std::uint32_t dimension() const noexcept { return medax_complex_dimension(get()); }
    View<double> vertices() const noexcept { return detail::view(medax_complex_vertices(get())); }
    Rows faces() const noexcept { return Rows(medax_complex_faces(get())); }
    View<std::uint32_t> edges() const noexcept { return detail::view(medax_complex_edges(get())); }
    Rows cells() const noexcept { return Rows(medax_complex_cells(get())); }
    View<std::uint32_t> cell_types() const noexcept {
        return detail::view(medax_complex_cell_types(get()));
    }
    View<std::uint32_t> triangles() const noexcept {
        return detail::view(medax_complex_triangles(get()));
    }
    View<std::uint32_t> face_of_triangle() const noexcept {
        return detail::view(medax_complex_face_of_triangle(get()));
    }

    Topology topology(const Job &job = Job::fresh()) const {
        Topology report;
        report.struct_size = sizeof report;
        job.check(medax_complex_topology(get(), job.get(), &report));
        return report;
    }
    struct Measure {
        double area, volume;
    };
    Measure measure(const Job &job = Job::fresh()) const {
        Measure measure;
        job.check(medax_complex_measure(get(), job.get(), &measure.area, &measure.volume));
        return measure;
    }
    Complex oriented(const Job &job = Job::fresh()) const {
        const medax_complex *oriented = nullptr;
        job.check(medax_complex_orient(get(), job.get(), &oriented));
        return Complex(oriented);
    }
    Comparison compare(const Complex &other, const CompareOptions &options = {},
                       const Job &job = Job::fresh()) const {
        Comparison report;
        report.struct_size = sizeof report;
        job.check(medax_complex_compare(get(), other.get(), &options, job.get(), &report));
        return report;
    }
    Validation validate(const Job &job = Job::fresh()) const {
        return detail::validated(medax_complex_validate, get(), job);
    }

    std::size_t attribute_count() const noexcept { return medax_complex_attribute_count(get()); }
    Attribute attribute(std::size_t index) const {
        medax_attribute found;
        detail::check(medax_complex_attribute_at(get(), index, &found));
        return Attribute(found);
    }
    /// The attribute of this name, which must be there.
    Attribute attribute(medax_element element, const std::string &name) const {
        medax_attribute found;
        detail::check(medax_complex_attribute(get(), element, name.c_str(), &found));
        return Attribute(found);
    }
};

// ---- Triangulation -----------------------------------------------------------------------------

using TriangulationOptions =
    detail::Options<medax_triangulation_options, medax_triangulation_options_init>;

/// A Delaunay or regular triangulation.
class Triangulation : public detail::Handle<medax_triangulation, medax_triangulation_clone,
                                            medax_triangulation_free> {
public:
    /// Takes over a reference that a function of medax.h gave.
    explicit Triangulation(const medax_triangulation *owned) noexcept : Handle(owned) {}

    static Triangulation delaunay(const Points &points, const TriangulationOptions &options = {},
                                  const Job &job = Job::fresh()) {
        const medax_triangulation *built = nullptr;
        job.check(medax_delaunay_build(points.get(), &options, job.get(), &built));
        return Triangulation(built);
    }
    /// One weight per input row of the points, in squared units.
    static Triangulation regular(const Points &points, const std::vector<double> &weights,
                                 const TriangulationOptions &options = {},
                                 const Job &job = Job::fresh()) {
        const medax_triangulation *built = nullptr;
        job.check(medax_regular_build(points.get(), weights.data(), weights.size(), &options,
                                      job.get(), &built));
        return Triangulation(built);
    }

    Points points() const {
        const medax_points *points = nullptr;
        detail::check(medax_triangulation_points(get(), &points));
        return Points(points);
    }
    View<double> coords() const noexcept { return detail::view(medax_triangulation_coords(get())); }
    View<double> weights() const noexcept {
        return detail::view(medax_triangulation_weights(get()));
    }
    View<std::uint32_t> row_of_vertex() const noexcept {
        return detail::view(medax_triangulation_row_of_vertex(get()));
    }
    View<std::uint32_t> cells() const noexcept {
        return detail::view(medax_triangulation_cells(get()));
    }
    View<std::uint32_t> neighbors() const noexcept {
        return detail::view(medax_triangulation_neighbors(get()));
    }
    View<std::uint32_t> hidden() const noexcept {
        return detail::view(medax_triangulation_hidden(get()));
    }

    /// A cell that holds the point, or medax::none outside the convex hull.
    std::uint32_t locate(const Point &point, std::uint32_t hint_cell = 0) const {
        std::uint32_t cell = none;
        detail::check(medax_triangulation_locate(get(), point.data(), hint_cell, &cell));
        return cell;
    }

    /// The cells round an edge; not closed on the hull.
    struct Ring {
        std::vector<std::uint32_t> cells;
        bool closed;
    };
    /// The ring round the edge from `a` to `b`, given one of its cells.
    Ring ring(std::uint32_t cell, std::uint32_t a, std::uint32_t b) const {
        std::vector<std::uint32_t> cells(32);
        std::size_t count = 0;
        std::uint32_t closed = 0;
        const auto fill = [&] {
            detail::check(medax_triangulation_ring(get(), cell, a, b, cells.size(), cells.data(),
                                                   &count, &closed));
            const bool fits = count <= cells.size();
            cells.resize(count);
            return fits;
        };
        if (!fill()) fill();
        return {std::move(cells), closed != 0};
    }

    /// The vertices and the cells as tetrahedra, for writing.
    Complex complex() const {
        const medax_complex *complex = nullptr;
        detail::check(medax_triangulation_complex(get(), &complex));
        return Complex(complex);
    }
    Validation validate(const Job &job = Job::fresh()) const {
        return detail::validated(medax_triangulation_validate, get(), job);
    }
};

// ---- Incidence ---------------------------------------------------------------------------------

/// The cells of each vertex of a triangulation, and its edges.
class Incidence
    : public detail::Handle<medax_incidence, medax_incidence_clone, medax_incidence_free> {
public:
    /// Takes over a reference that a function of medax.h gave.
    explicit Incidence(const medax_incidence *owned) noexcept : Handle(owned) {}

    static Incidence of(const Triangulation &triangulation, const Job &job = Job::fresh()) {
        const medax_incidence *built = nullptr;
        job.check(medax_incidence_build(triangulation.get(), job.get(), &built));
        return Incidence(built);
    }

    Rows cells_of_vertex() const noexcept { return Rows(medax_incidence_cells_of_vertex(get())); }
    View<std::uint32_t> edges() const noexcept {
        return detail::view(medax_incidence_edges(get()));
    }
    View<std::uint32_t> cell_of_edge() const noexcept {
        return detail::view(medax_incidence_cell_of_edge(get()));
    }
};

// ---- File contents ------------------------------------------------------------------------------

/// What a file holds, before points or a complex are made of it.
class File : public detail::Handle<medax_file, medax_file_clone, medax_file_free> {
public:
    /// Takes over a reference that a function of medax.h gave.
    explicit File(const medax_file *owned) noexcept : Handle(owned) {}

    static File read(const std::string &path_utf8, const Job &job = Job::fresh()) {
        const medax_file *file = nullptr;
        job.check(medax_file_read(path_utf8.c_str(), job.get(), &file));
        return File(file);
    }

    bool is_mesh() const noexcept { return medax_file_is_mesh(get()); }
    View<double> vertices() const noexcept { return detail::view(medax_file_vertices(get())); }
    Rows faces() const noexcept { return Rows(medax_file_faces(get())); }
    View<std::uint32_t> edges() const noexcept { return detail::view(medax_file_edges(get())); }
    std::size_t attribute_count() const noexcept { return medax_file_attribute_count(get()); }
    Attribute attribute(std::size_t index) const {
        medax_attribute found;
        detail::check(medax_file_attribute_at(get(), index, &found));
        return Attribute(found);
    }
    /// The attribute of this name, which must be there.
    Attribute attribute(medax_element element, const std::string &name) const {
        medax_attribute found;
        detail::check(medax_file_attribute(get(), element, name.c_str(), &found));
        return Attribute(found);
    }
    Warnings warnings() const {
        const medax_warnings *warnings = nullptr;
        detail::check(medax_file_warnings(get(), &warnings));
        return Warnings(warnings);
    }
    Points points(const PointsOptions &options = {}, const Job &job = Job::fresh()) const {
        const medax_points *points = nullptr;
        job.check(medax_file_points(get(), &options, job.get(), &points));
        return Points(points);
    }
    Complex complex(const Job &job = Job::fresh()) const {
        const medax_complex *complex = nullptr;
        job.check(medax_file_complex(get(), job.get(), &complex));
        return Complex(complex);
    }
};

// ---- Dual --------------------------------------------------------------------------------------

using DualOptions = detail::Options<medax_dual_options, medax_dual_options_init>;

/// The Voronoi or power diagram that is dual to a triangulation.
class Dual : public detail::Handle<medax_dual, medax_dual_clone, medax_dual_free> {
public:
    /// Takes over a reference that a function of medax.h gave.
    explicit Dual(const medax_dual *owned) noexcept : Handle(owned) {}

    static Dual of(const Triangulation &triangulation, const DualOptions &options = {},
                   const Job &job = Job::fresh()) {
        const medax_dual *dual = nullptr;
        job.check(medax_dual_build(triangulation.get(), &options, job.get(), &dual));
        return Dual(dual);
    }

    Triangulation triangulation() const {
        const medax_triangulation *triangulation = nullptr;
        detail::check(medax_dual_triangulation(get(), &triangulation));
        return Triangulation(triangulation);
    }
    View<double> centers() const noexcept { return detail::view(medax_dual_centers(get())); }
    View<double> radii_squared() const noexcept {
        return detail::view(medax_dual_radii_squared(get()));
    }
    View<std::uint32_t> ray_facets() const noexcept {
        return detail::view(medax_dual_ray_facets(get()));
    }
    View<double> ray_directions() const noexcept {
        return detail::view(medax_dual_ray_directions(get()));
    }
    Rows facets() const noexcept { return Rows(medax_dual_facets(get())); }
    View<std::uint32_t> facet_edges() const noexcept {
        return detail::view(medax_dual_facet_edges(get()));
    }
    View<std::uint32_t> facet_rays() const noexcept {
        return detail::view(medax_dual_facet_rays(get()));
    }
    Validation validate(const Job &job = Job::fresh()) const {
        return detail::validated(medax_dual_validate, get(), job);
    }
};

// ---- Poles -------------------------------------------------------------------------------------

using PolesOptions = detail::Options<medax_poles_options, medax_poles_options_init>;

/// The poles of a sample, and their balls.
class Poles : public detail::Handle<medax_poles, medax_poles_clone, medax_poles_free> {
public:
    /// Takes over a reference that a function of medax.h gave.
    explicit Poles(const medax_poles *owned) noexcept : Handle(owned) {}

    /// The poles of a sample alone, at infinity on its hull.
    static Poles of(const Dual &dual, const PolesOptions &options = {},
                    const Job &job = Job::fresh()) {
        const medax_poles *poles = nullptr;
        job.check(medax_poles_build(dual.get(), &options, job.get(), &poles));
        return Poles(poles);
    }
    /// The poles from which a power crust is made.
    static Poles with_far_box(const Points &points, const PolesOptions &options = {},
                              const Job &job = Job::fresh()) {
        const medax_poles *poles = nullptr;
        job.check(medax_poles_build_with_far_box(points.get(), &options, job.get(), &poles));
        return Poles(poles);
    }

    Triangulation triangulation() const {
        const medax_triangulation *triangulation = nullptr;
        detail::check(medax_poles_triangulation(get(), &triangulation));
        return Triangulation(triangulation);
    }
    bool has_far_box() const noexcept { return medax_poles_has_far_box(get()); }
    View<double> balls() const noexcept { return detail::view(medax_poles_balls(get())); }
    View<double> radii_squared() const noexcept {
        return detail::view(medax_poles_radii_squared(get()));
    }
    View<std::uint32_t> cell_of_pole() const noexcept {
        return detail::view(medax_poles_cell_of_pole(get()));
    }
    View<std::uint8_t> touches_far_box() const noexcept {
        return detail::view(medax_poles_touches_far_box(get()));
    }
    View<std::uint32_t> pole_of_sample() const noexcept {
        return detail::view(medax_poles_pole_of_sample(get()));
    }
    View<double> normals() const noexcept { return detail::view(medax_poles_normals(get())); }

    /// The distance from each point to the nearest pole.
    std::vector<double> feature_size(const std::vector<Point> &queries,
                                     const Job &job = Job::fresh()) const {
        std::vector<double> distances(queries.size());
        const double *xyz = queries.empty() ? nullptr : queries.front().data();
        job.check(medax_poles_feature_size(get(), xyz, queries.size(), job.get(),
                                           distances.data()));
        return distances;
    }
    /// The poles as vertices with `radius`, for writing.
    Complex complex() const {
        const medax_complex *complex = nullptr;
        detail::check(medax_poles_complex(get(), &complex));
        return Complex(complex);
    }
    /// The samples as vertices with `normal`, for writing.
    Complex samples_complex() const {
        const medax_complex *complex = nullptr;
        detail::check(medax_poles_samples_complex(get(), &complex));
        return Complex(complex);
    }
    Validation validate(const Job &job = Job::fresh()) const {
        return detail::validated(medax_poles_validate, get(), job);
    }
};

// ---- Power crust -------------------------------------------------------------------------------

using PowerCrustOptions =
    detail::Options<medax_power_crust_options, medax_power_crust_options_init>;

/// A power crust with all that it was made from.
class PowerCrust
    : public detail::Handle<medax_power_crust, medax_power_crust_clone, medax_power_crust_free> {
public:
    /// Takes over a reference that a function of medax.h gave.
    explicit PowerCrust(const medax_power_crust *owned) noexcept : Handle(owned) {}

    static PowerCrust of(const Points &points, const PowerCrustOptions &options = {},
                         const Job &job = Job::fresh()) {
        const medax_power_crust *crust = nullptr;
        job.check(medax_power_crust_build(points.get(), &options, job.get(), &crust));
        return PowerCrust(crust);
    }
    static PowerCrust of(const Poles &poles, const PowerCrustOptions &options = {},
                         const Job &job = Job::fresh()) {
        const medax_power_crust *crust = nullptr;
        job.check(medax_power_crust_build_from_poles(poles.get(), &options, job.get(), &crust));
        return PowerCrust(crust);
    }

    Complex surface() const {
        const medax_complex *surface = nullptr;
        detail::check(medax_power_crust_surface(get(), &surface));
        return Complex(surface);
    }
    Complex shape(medax_label label) const {
        const medax_complex *shape = nullptr;
        detail::check(medax_power_crust_shape(get(), label, &shape));
        return Complex(shape);
    }
    Poles poles() const {
        const medax_poles *poles = nullptr;
        detail::check(medax_power_crust_poles(get(), &poles));
        return Poles(poles);
    }
    /// The regular triangulation of the polar balls.
    Triangulation regular() const {
        const medax_triangulation *regular = nullptr;
        detail::check(medax_power_crust_regular(get(), &regular));
        return Triangulation(regular);
    }
    View<std::uint32_t> labels() const noexcept {
        return detail::view(medax_power_crust_labels(get()));
    }
    bool is_visible(std::uint32_t pole) const noexcept {
        return medax_power_crust_is_visible(get(), pole);
    }
    std::size_t unreached_count() const noexcept {
        return medax_power_crust_unreached_count(get());
    }
    std::size_t forced_count() const noexcept { return medax_power_crust_forced_count(get()); }
    /// The poles as vertices with `radius` and `label`, for writing.
    Complex poles_complex() const {
        const medax_complex *complex = nullptr;
        detail::check(medax_power_crust_poles_complex(get(), &complex));
        return Complex(complex);
    }
    /// The power shapes of both sides in one complex, the inner one first.
    Complex both_shapes() const {
        const medax_complex *complex = nullptr;
        detail::check(medax_power_crust_both_shapes(get(), &complex));
        return Complex(complex);
    }
    Validation validate(const Job &job = Job::fresh()) const {
        return detail::validated(medax_power_crust_validate, get(), job);
    }
};

// ---- Samples -----------------------------------------------------------------------------------

using SampleOptions = detail::Options<medax_sample_options, medax_sample_options_init>;
using ShapeFacts = medax_shape_facts;

/// The name of a shape, such as `torus`.
inline const char *name(medax_shape shape) { return medax_shape_name(shape); }

/// What is known of a shape.
inline ShapeFacts describe(medax_shape shape) {
    ShapeFacts facts;
    facts.struct_size = sizeof facts;
    detail::check(medax_shape_describe(shape, &facts));
    return facts;
}

/// Samples of a surface with its normals.
class Samples : public detail::Handle<medax_samples, medax_samples_clone, medax_samples_free> {
public:
    /// Takes over a reference that a function of medax.h gave.
    explicit Samples(const medax_samples *owned) noexcept : Handle(owned) {}

    static Samples of(medax_shape shape, const SampleOptions &options = {},
                      const Job &job = Job::fresh()) {
        const medax_samples *samples = nullptr;
        job.check(medax_samples_build(shape, &options, job.get(), &samples));
        return Samples(samples);
    }
    static Samples of(const Complex &mesh, const SampleOptions &options = {},
                      const Job &job = Job::fresh()) {
        const medax_samples *samples = nullptr;
        job.check(medax_samples_build_from_mesh(mesh.get(), &options, job.get(), &samples));
        return Samples(samples);
    }

    View<double> coords() const noexcept { return detail::view(medax_samples_coords(get())); }
    View<double> normals() const noexcept { return detail::view(medax_samples_normals(get())); }
    double spacing() const noexcept { return medax_samples_spacing(get()); }
    double area() const noexcept { return medax_samples_area(get()); }
    /// The samples as vertices with the attribute `normal`.
    Complex complex() const {
        const medax_complex *complex = nullptr;
        detail::check(medax_samples_complex(get(), &complex));
        return Complex(complex);
    }
    Points points(const PointsOptions &options = {}, const Job &job = Job::fresh()) const {
        return Points::from(coords().data(), coords().rows(), 0, options, job);
    }
};

}  // namespace medax
