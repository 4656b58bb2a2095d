/* SPDX-License-Identifier: MIT OR Apache-2.0 */
/* Made by `make header` from src/capi: do not edit. */
#ifndef MEDAX_H
#define MEDAX_H

/**
 * \file medax.h
 *
 * medax turns samples of a surface into the structures that tell a solid's shape: exact Delaunay
 * and regular triangulations, duals, poles, power crusts, medial axes, flow complexes; and measures
 * distances to plane figures and meshes, with the medial axes that these have.
 *
 *     points -> triangulation -> dual -> poles -> power crust -> complex
 *
 * \mainpage
 *
 * **Names.** `medax_<noun>_<verb>`. The verbs: `create` makes a handle of the caller's data,
 * `read` of a file, `build` by computing; `init` sets options to their defaults; `clone` and
 * `free` count references; `write` makes a file; `validate` checks. What is named by a noun alone
 * and takes no job is an accessor: it computes nothing and cannot fail.
 *
 * **Arguments.** The subject, the inputs, the options, the job, the outputs. An argument may be
 * NULL only where its text says so. NULL options are the defaults, a NULL job is a fresh one.
 *
 * **Results.** What can fail returns a #medax_status; #medax_last_error_message and its
 * companions tell the rest. A call that fails writes no output, except that a buffer which the
 * caller lent for a batch of answers may be partly filled. Nothing is ever printed, and no
 * exception or panic leaves the library.
 *
 * **Handles** are immutable and counted by reference. Any function may be called on any handle
 * from any thread at any time; only the last `free` of a handle must come last. Handles may be
 * freed in any order, since what is built from one keeps what it needs of it alive. An output
 * handle belongs to the caller. Freeing NULL does nothing.
 *
 * **Views** borrow from a handle and are valid until the last reference to it is freed.
 *
 * **Sized structs** begin with `struct_size`. Options are set with their `init` function, which
 * takes `sizeof`; a report needs only its `struct_size` set. Programs and libraries of different
 * versions then understand each other: a field that the caller's version lacks is at its default,
 * one that the library lacks must be 0.
 *
 * **Units.** Coordinates and lengths are in the units of the input, angles in radians; what is
 * squared says so in its name. Enumerations cross as `uint32_t`. Text is UTF-8, paths included.
 *
 * **Answers** depend on the set of the input's points alone: not on the order of its rows, nor on
 * threads or the machine. Vertices are numbered by spatial rank; rows appear only in maps.
 */

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/** The first number of this header's version: another one is another ABI. */
#define MEDAX_VERSION_MAJOR 0
/** The second number: while the first one is 0, another one is another ABI, too. */
#define MEDAX_VERSION_MINOR 1
/** The third number: the ABI stays. */
#define MEDAX_VERSION_PATCH 0
/** The version of this header as #medax_version tells that of the library. */
#define MEDAX_VERSION \
    ((uint32_t)MEDAX_VERSION_MAJOR << 22 | (uint32_t)MEDAX_VERSION_MINOR << 12 | \
     (uint32_t)MEDAX_VERSION_PATCH)

/** "No such element": the only sentinel in any index array. */
#define MEDAX_NONE UINT32_MAX

/* Define MEDAX_STATIC to link the static library on Windows. */
#if defined(_WIN32) && !defined(MEDAX_STATIC)
#define MEDAX_API __declspec(dllimport)
#else
#define MEDAX_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* ---- 1. Library ------------------------------------------------------------------------------
 *
 * The version, the statuses, the last error of each thread.
 */

/**
 * What a fallible function returns. 1-19 lie with the caller or the data, 20-39 with the run,
 * 40-59 with files. Numbers are never reused.
 */
enum medax_status
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : int32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
    /**
     * Success.
     */
    MEDAX_STATUS_OK = 0,
    /**
     * A pointer that must not be NULL is NULL.
     */
    MEDAX_STATUS_NULL_ARGUMENT = 1,
    /**
     * An argument's value has no meaning here.
     */
    MEDAX_STATUS_INVALID_ARGUMENT = 2,
    /**
     * A coordinate or weight is NaN or infinite.
     */
    MEDAX_STATUS_NON_FINITE = 3,
    /**
     * A coordinate or weight lies outside the range in which all predicates are exact.
     */
    MEDAX_STATUS_COORDINATE_RANGE = 4,
    /**
     * Too few distinct points.
     */
    MEDAX_STATUS_TOO_FEW_POINTS = 5,
    /**
     * All points lie in a plane, on a line, or at one point.
     */
    MEDAX_STATUS_DEGENERATE = 6,
    /**
     * Two arguments do not belong together, such as arrays of different lengths.
     */
    MEDAX_STATUS_MISMATCH = 7,
    /**
     * The job was cancelled.
     */
    MEDAX_STATUS_CANCELLED = 20,
    /**
     * Memory ran out, or the job's memory ceiling would have been passed.
     */
    MEDAX_STATUS_OUT_OF_MEMORY = 21,
    /**
     * The result would have more elements than 32-bit indices can name.
     */
    MEDAX_STATUS_LIMIT_EXCEEDED = 22,
    /**
     * The job is already running a build.
     */
    MEDAX_STATUS_BUSY = 23,
    /**
     * The operating system refused to read or write a file.
     */
    MEDAX_STATUS_IO = 40,
    /**
     * A file is malformed or truncated.
     */
    MEDAX_STATUS_FORMAT = 41,
    /**
     * A file is well formed but of a kind that medax does not read or write.
     */
    MEDAX_STATUS_UNSUPPORTED = 42,
    /**
     * A defect in medax; please report it.
     */
    MEDAX_STATUS_INTERNAL = 99,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum medax_status medax_status;
#else
typedef int32_t medax_status;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

/**
 * The kind of the element that an error points at.
 */
enum medax_error_kind
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
    /**
     * The error points at no element.
     */
    MEDAX_ERROR_KIND_NONE = 0,
    /**
     * A row of an input array, or of a file's vertex table, from 0.
     */
    MEDAX_ERROR_KIND_ROW = 1,
    /**
     * A line of a text file, from 1.
     */
    MEDAX_ERROR_KIND_LINE = 2,
    /**
     * A byte of a binary file, from 0.
     */
    MEDAX_ERROR_KIND_BYTE = 3,
    /**
     * A ring of a polygon, from 0.
     */
    MEDAX_ERROR_KIND_RING = 4,
    /**
     * A face, from 0.
     */
    MEDAX_ERROR_KIND_FACE = 5,
    /**
     * A cell, from 0.
     */
    MEDAX_ERROR_KIND_CELL = 6,
    /**
     * A vertex of a structure, from 0.
     */
    MEDAX_ERROR_KIND_VERTEX = 7,
    /**
     * An edge, from 0.
     */
    MEDAX_ERROR_KIND_EDGE = 8,
    /**
     * An open polyline of a figure, from 0.
     */
    MEDAX_ERROR_KIND_POLYLINE = 9,
    /**
     * A circle of a figure, from 0.
     */
    MEDAX_ERROR_KIND_CIRCLE = 10,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum medax_error_kind medax_error_kind;
#else
typedef uint32_t medax_error_kind;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

/**
 * The version of the loaded library, `major << 22 | minor << 12 | patch`; compare it with
 * `MEDAX_VERSION`, the version of this header.
 *
 * \return The version.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API uint32_t medax_version(void);

/**
 * The version of the loaded library as text, such as `0.1.0`.
 *
 * \return A static string; never NULL, never to be freed.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API const char *medax_version_string(void);

/**
 * The name of a status, such as `MEDAX_STATUS_NON_FINITE`.
 *
 * \param status A status, or any other number: then the name is `MEDAX_STATUS_UNKNOWN`.
 * \return A static string; never NULL, never to be freed.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API const char *medax_status_name(int32_t status);

/**
 * What went wrong in this thread's last failing call: a sentence for a person.
 * A call that succeeds does not clear it.
 *
 * \return UTF-8 text, empty if no call has failed; never NULL. Borrowed: valid until the next
 *         failing call of this thread, or its end.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API const char *medax_last_error_message(void);

/**
 * The kind of the element at which this thread's last error points.
 *
 * \return A #medax_error_kind; `MEDAX_ERROR_KIND_NONE` if it points at none.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API uint32_t medax_last_error_kind(void);

/**
 * The index of the element at which this thread's last error points.
 *
 * \return The index, or `UINT64_MAX` if it points at none.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API uint64_t medax_last_error_index(void);

/* ---- 2. Handles ------------------------------------------------------------------------------
 *
 * Every structure is immutable once created, and counted by reference.
 *
 * A handle is passed as `const T *` and may be used from any thread at any time; only the last
 * `free` must come last. What is built from a handle keeps what it needs of it alive, so that
 * handles may be freed in any order. Freeing NULL does nothing.
 */

/**
 * All that is nearest to each of some points.
 */
typedef struct medax_all_nearest medax_all_nearest;

/**
 * Balls, whose union is a solid.
 */
typedef struct medax_balls medax_balls;

/**
 * Cocone and Tight Cocone of a sample.
 */
typedef struct medax_cocone medax_cocone;

/**
 * Vertices, polygons, loose edges, volume cells and named attributes: every result that can be
 * drawn or written.
 */
typedef struct medax_complex medax_complex;

/**
 * The Voronoi or power diagram that is dual to a triangulation.
 */
typedef struct medax_dual medax_dual;

/**
 * Points of the medial axis of sites, and where they were looked for.
 */
typedef struct medax_field_axis medax_field_axis;

/**
 * Polygons with holes, open polylines, points and circles in the plane.
 */
typedef struct medax_figure medax_figure;

/**
 * What a file holds, before points or a complex are made of it.
 */
typedef struct medax_file medax_file;

/**
 * A complex without its flat tetrahedra, and what became of them.
 */
typedef struct medax_flattened medax_flattened;

/**
 * The flow of the distance to a sample: its critical points, and where it goes.
 */
typedef struct medax_flow medax_flow;

/**
 * The unstable flow complex of a sample, and its flow DAG.
 */
typedef struct medax_flow_complex medax_flow_complex;

/**
 * Every face of every element of a pair-mesh, with its edges.
 */
typedef struct medax_half_faces medax_half_faces;

/**
 * The cells of each vertex of a triangulation, and its edges.
 */
typedef struct medax_incidence medax_incidence;

/**
 * The pairs of triangles of a complex that intersect.
 */
typedef struct medax_intersections medax_intersections;

/**
 * How to run a build: threads, memory ceiling, progress, cancel.
 */
typedef struct medax_job medax_job;

/**
 * For each cell of a Delaunay triangulation whether it lies in the solid.
 */
typedef struct medax_labels medax_labels;

/**
 * Every Voronoi facet of a sample with what decides whether it belongs to the medial axis.
 */
typedef struct medax_medial medax_medial;

/**
 * The medial axis of sites in the plane as a graph.
 */
typedef struct medax_medial_graph medax_medial_graph;

/**
 * A solid between an inner structure and its boundary.
 */
typedef struct medax_pair medax_pair;

/**
 * Distinct points in spatial order, with maps from and to the input's rows.
 */
typedef struct medax_points medax_points;

/**
 * The poles of a sample, and their balls.
 */
typedef struct medax_poles medax_poles;

/**
 * A power crust with all that it was made from.
 */
typedef struct medax_power_crust medax_power_crust;

/**
 * Samples of a surface with its normals.
 */
typedef struct medax_samples medax_samples;

/**
 * A simplified power crust, and what became of the poles.
 */
typedef struct medax_simplified medax_simplified;

/**
 * Pieces that distances are measured to: points, segments, rays, lines, circles, triangles, spheres.
 */
typedef struct medax_sites medax_sites;

/**
 * A Delaunay or regular triangulation: finite cells and their neighbours.
 */
typedef struct medax_triangulation medax_triangulation;

/**
 * Sentences about what a file did not hold, or what was left out of it.
 */
typedef struct medax_warnings medax_warnings;

/* ---- 3. Views --------------------------------------------------------------------------------
 *
 * Arrays that are read where they lie.
 *
 * A view is row-major and contiguous. It borrows from the handle that gave it, and is valid
 * until the last reference to that handle is freed. A NULL handle, or an array without a row,
 * gives a view without a row, whose data is NULL.
 */

/**
 * Rows of floats: row `i` is `data[i * cols]` to `data[i * cols + cols - 1]`.
 */
typedef struct {
    /**
     * `rows * cols` values; NULL if there are none.
     */
    const double *data;
    /**
     * The number of rows.
     */
    size_t rows;
    /**
     * The number of values in a row.
     */
    size_t cols;
} medax_view_f64;

/**
 * Rows of indices: row `i` is `data[i * cols]` to `data[i * cols + cols - 1]`.
 */
typedef struct {
    /**
     * `rows * cols` values; NULL if there are none.
     */
    const uint32_t *data;
    /**
     * The number of rows.
     */
    size_t rows;
    /**
     * The number of values in a row.
     */
    size_t cols;
} medax_view_u32;

/**
 * Rows of bytes, such as flags that are 0 or 1.
 */
typedef struct {
    /**
     * `rows * cols` values; NULL if there are none.
     */
    const uint8_t *data;
    /**
     * The number of rows.
     */
    size_t rows;
    /**
     * The number of values in a row.
     */
    size_t cols;
} medax_view_u8;

/**
 * Rows of varying length: row `i` is `indices[offsets[i]]` to `indices[offsets[i + 1] - 1]`.
 */
typedef struct {
    /**
     * `rows + 1` positions in `indices`, the first of them 0; NULL for a NULL handle.
     */
    const uint32_t *offsets;
    /**
     * `offsets[rows]` values; NULL if there are none.
     */
    const uint32_t *indices;
    /**
     * The number of rows.
     */
    size_t rows;
} medax_view_rows;

/* ---- 4. Attributes ---------------------------------------------------------------------------
 *
 * Named values on the vertices, loose edges, faces or volume cells of a complex or a file.
 */

/**
 * The kinds of elements of a complex.
 */
enum medax_element
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
    /**
     * A vertex.
     */
    MEDAX_ELEMENT_VERTEX = 0,
    /**
     * A loose edge.
     */
    MEDAX_ELEMENT_EDGE = 1,
    /**
     * A face.
     */
    MEDAX_ELEMENT_FACE = 2,
    /**
     * A volume cell.
     */
    MEDAX_ELEMENT_CELL = 3,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum medax_element medax_element;
#else
typedef uint32_t medax_element;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

/**
 * The type of an attribute's values.
 */
enum medax_value_type
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
    /**
     * Lengths, angles, coordinates.
     */
    MEDAX_VALUE_TYPE_F64 = 0,
    /**
     * Indices and labels.
     */
    MEDAX_VALUE_TYPE_U32 = 1,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum medax_value_type medax_value_type;
#else
typedef uint32_t medax_value_type;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

/**
 * Values with a name on one kind of element, one row an element.
 */
typedef struct {
    /**
     * The name, such as `radius`: a terminated UTF-8 string.
     */
    const char *name;
    /**
     * A #medax_element: what carries the values.
     */
    uint32_t element;
    /**
     * A #medax_value_type: which of the two arrays is filled.
     */
    uint32_t value_type;
    /**
     * The values, if they are of type `MEDAX_VALUE_TYPE_F64`; else without a row.
     */
    medax_view_f64 f64_values;
    /**
     * The values, if they are of type `MEDAX_VALUE_TYPE_U32`; else without a row.
     */
    medax_view_u32 u32_values;
} medax_attribute;

/* ---- 5. Job ----------------------------------------------------------------------------------
 *
 * Options of a build say what to build; a job says how to run it: with how many threads and how
 * much memory. It tells how far it is, and cancels.
 *
 * A job runs one build at a time: a second one meanwhile fails with `MEDAX_STATUS_BUSY`. A
 * cancelled job is spent: every later build with it fails with `MEDAX_STATUS_CANCELLED`.
 * Wherever a job is asked for, NULL stands for a fresh one with default options.
 */

/**
 * Called with the progress of a build on the thread that runs it, at most twenty times a second.
 *
 * \param progress How far the build is, in [0, 1]; never falls during a build.
 * \param stage What the build is doing, such as `triangulate`: a static string.
 * \param payload The pointer of the job's options, untouched.
 * \return 0 to go on, anything else to cancel the job. The function must return: an exception
 *         or a longjmp out of it is undefined behaviour.
 */
typedef int32_t (*medax_progress_callback)(double progress, const char *stage, void *payload);

/**
 * The settings of a job.
 */
typedef struct {
    /**
     * The size of this struct in the caller's program.
     */
    size_t struct_size;
    /**
     * The most bytes that a build's own arrays may take at once; 0, the default: no ceiling.
     */
    uint64_t memory_ceiling;
    /**
     * The most threads that builds may use; 0, the default: what the environment variable MEDAX_THREADS says, or
     * one per processor. Results do not depend on it.
     */
    uint32_t threads;
    /**
     * Must be 0.
     */
    uint32_t reserved;
    /**
     * Called during builds, on the thread that runs them; NULL, the default: not called.
     */
    medax_progress_callback progress;
    /**
     * Passed to `progress`; never read by medax. It must stay valid until the last reference
     * to the job is freed.
     */
    void *payload;
} medax_job_options;

/**
 * Sets job options to their defaults.
 *
 * \param options The caller's struct, of `struct_size` bytes.
 * \param struct_size `sizeof *options`.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_status medax_job_options_init(medax_job_options *options, size_t struct_size);

/**
 * Makes a job that waits for its first build.
 *
 * \param options Threads, memory ceiling, progress callback; NULL for the defaults. Copied.
 * \param out_job Receives the job, which the caller frees with #medax_job_free.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for options of no version.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_status medax_job_create(const medax_job_options *options,
                              const medax_job **out_job);

/**
 * Asks the running build of a job, and every later one, to stop: within 50 ms it returns
 * `MEDAX_STATUS_CANCELLED` and leaves nothing behind. Never undone; may be called again.
 *
 * \param job The job; NULL does nothing.
 *
 * Constant time, any thread. Since 0.1.
 */
MEDAX_API void medax_job_cancel(const medax_job *job);

/**
 * Whether a job was cancelled, by #medax_job_cancel or by its callback.
 *
 * \param job The job; NULL is not cancelled.
 * \return True once it was cancelled.
 *
 * Constant time, any thread. Since 0.1.
 */
MEDAX_API bool medax_job_is_cancelled(const medax_job *job);

/**
 * How far the running build of a job is, or the last one came.
 *
 * \param job The job; NULL is at 0.
 * \return A number in [0, 1] that never falls during a build.
 *
 * Constant time, any thread. Since 0.1.
 */
MEDAX_API double medax_job_progress(const medax_job *job);

/**
 * What the running build of a job is doing, or the last one did last.
 *
 * \param job The job; NULL is idle.
 * \return A static string, such as `triangulate`; `idle` before the first build; never NULL.
 *
 * Constant time, any thread. Since 0.1.
 */
MEDAX_API const char *medax_job_stage(const medax_job *job);

/**
 * The most bytes that the arrays of one build of a job took at once.
 *
 * \param job The job; NULL took none.
 * \return Bytes, as counted against the memory ceiling.
 *
 * Constant time, any thread. Since 0.1.
 */
MEDAX_API uint64_t medax_job_memory_peak(const medax_job *job);

/**
 * The number of stages that the builds of a job have been through.
 *
 * \param job The job; NULL has been through none.
 * \return The number of stages whose times #medax_job_stage_time tells; it only grows.
 *
 * Constant time, any thread. Since 0.1.
 */
MEDAX_API size_t medax_job_stage_count(const medax_job *job);

/**
 * How long a stage took.
 *
 * \param job The job.
 * \param index Which stage, below #medax_job_stage_count, in the order of time.
 * \param out_stage Receives a static string, such as `triangulate`; or NULL.
 * \param out_wall_seconds Receives the elapsed seconds; or NULL.
 * \param out_cpu_seconds Receives the processor seconds of the whole process; or NULL.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT` without a job, or `INVALID_ARGUMENT` for an index
 *         past the last stage.
 *
 * Constant time, any thread. Since 0.1.
 */
MEDAX_API
medax_status medax_job_stage_time(const medax_job *job,
                                  size_t index,
                                  const char **out_stage,
                                  double *out_wall_seconds,
                                  double *out_cpu_seconds);

/**
 * One more reference to a job.
 *
 * \param job The job, or NULL.
 * \return The same pointer; the caller frees it once more.
 *
 * Constant time, any thread. Since 0.1.
 */
MEDAX_API const medax_job *medax_job_clone(const medax_job *job);

/**
 * Gives one reference to a job back; the last one frees it.
 *
 * \param job The job; NULL does nothing.
 *
 * Any thread. Since 0.1.
 */
MEDAX_API void medax_job_free(const medax_job *job);

/* ---- 6. Validation ---------------------------------------------------------------------------
 *
 * Every structure can check itself: what it promises is looked at element by element, in exact
 * arithmetic where there is any. A report is data: to find a problem is a success.
 */

/**
 * What the check of a structure found. The caller sets `struct_size`, the library the rest.
 */
typedef struct {
    /**
     * The size of this struct in the caller's program.
     */
    size_t struct_size;
    /**
     * The number of conditions checked.
     */
    uint64_t checked;
    /**
     * The number of conditions that do not hold; 0 for a sound structure.
     */
    uint64_t problems;
    /**
     * The index of the first offending element, or `UINT64_MAX`.
     */
    uint64_t first_index;
    /**
     * A #medax_error_kind: the kind of the first offending element.
     */
    uint32_t first_kind;
    /**
     * 0.
     */
    uint32_t reserved;
    /**
     * What is wrong with it: a terminated UTF-8 sentence, cut if it is too long; empty if
     * nothing is wrong.
     */
    char first_message[256];
} medax_validation;

/* ---- 7. Points -------------------------------------------------------------------------------
 *
 * They are checked, merged where they coincide, and put into spatial order.
 *
 * The distinct points are the vertices of everything built from them, numbered by spatial rank:
 * the numbers depend on the set of points alone. The rows of the caller's array appear only in
 * the maps. Coordinates are in the caller's units. They must be 0 or have an absolute value
 * from 2^-160 to 2^200; there may be 2^28 rows.
 */

/**
 * What to do with rows that are not numbers, and the like.
 */
typedef struct {
    /**
     * The size of this struct in the caller's program.
     */
    size_t struct_size;
    /**
     * 1 leaves rows with a NaN or an infinity out; they map to `MEDAX_NONE`. 0, the default:
     * they are an error.
     */
    uint32_t skip_non_finite;
    /**
     * Must be 0.
     */
    uint32_t reserved;
} medax_points_options;

/**
 * Sets points options to their defaults.
 *
 * \param options The caller's struct, of `struct_size` bytes.
 * \param struct_size `sizeof *options`.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_status medax_points_options_init(medax_points_options *options, size_t struct_size);

/**
 * Makes points of the caller's array of doubles, which is copied.
 *
 * \param xyz `count` points of three coordinates, `stride_bytes` apart; need not be aligned. Several threads read
 *        them, and they must not change during the call.
 *        NULL only if `count` is 0.
 * \param count The number of rows.
 * \param stride_bytes The distance between rows in bytes, at least 24; 0 stands for 24.
 * \param options NULL for the defaults.
 * \param job NULL for a default job.
 * \param out_points Receives the points, which the caller frees with #medax_points_free.
 * \return `MEDAX_STATUS_OK`; `NON_FINITE` or `COORDINATE_RANGE` with the row; `TOO_FEW_POINTS`
 *         when no row is left; `LIMIT_EXCEEDED` past 2^28 rows; `NULL_ARGUMENT`,
 *         `INVALID_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(n log n). Since 0.1.
 */
MEDAX_API
medax_status medax_points_create_f64(const double *xyz,
                                     size_t count,
                                     size_t stride_bytes,
                                     const medax_points_options *options,
                                     const medax_job *job,
                                     const medax_points **out_points);

/**
 * Makes points of the caller's array of floats, which is copied; otherwise as
 * #medax_points_create_f64.
 *
 * \param xyz `count` points of three coordinates, `stride_bytes` apart; need not be aligned.
 *        NULL only if `count` is 0.
 * \param count The number of rows.
 * \param stride_bytes The distance between rows in bytes, at least 12; 0 stands for 12.
 * \param options NULL for the defaults.
 * \param job NULL for a default job.
 * \param out_points Receives the points, which the caller frees with #medax_points_free.
 * \return As #medax_points_create_f64.
 *
 * O(n log n). Since 0.1.
 */
MEDAX_API
medax_status medax_points_create_f32(const float *xyz,
                                     size_t count,
                                     size_t stride_bytes,
                                     const medax_points_options *options,
                                     const medax_job *job,
                                     const medax_points **out_points);

/**
 * The distinct points in spatial order: the vertices.
 *
 * \param points The points, or NULL.
 * \return n x 3 coordinates. Borrowed from `points`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_f64 medax_points_coords(const medax_points *points);

/**
 * The vertex of each row of the input.
 *
 * \param points The points, or NULL.
 * \return Rows x 1: a vertex, or `MEDAX_NONE` for a row left out. Borrowed from `points`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_u32 medax_points_vertex_of_row(const medax_points *points);

/**
 * The first row of the input at each vertex.
 *
 * \param points The points, or NULL.
 * \return n x 1 rows. Borrowed from `points`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_u32 medax_points_row_of_vertex(const medax_points *points);

/**
 * The rows of the input that repeat an earlier one.
 *
 * \param points The points, or NULL.
 * \return Rows x 1: the first row with the same coordinates; `MEDAX_NONE` where the row is itself
 *         the first, or was left out. Borrowed from `points`.
 *
 * Made by the first call, in linear time; empty if there is no memory for it. Constant time afterwards. Since 0.1.
 */
MEDAX_API
medax_view_u32 medax_points_duplicate_of(const medax_points *points);

/**
 * The number of distinct points.
 *
 * \param points The points; NULL has none.
 * \return The number of vertices.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API size_t medax_points_count(const medax_points *points);

/**
 * The number of rows of the input.
 *
 * \param points The points; NULL has none.
 * \return The number of rows, those left out included.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API size_t medax_points_row_count(const medax_points *points);

/**
 * The number of rows of the input that repeat an earlier one.
 *
 * \param points The points; NULL has none.
 * \return The number of rows that #medax_points_duplicate_of maps to another one.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API size_t medax_points_duplicate_count(const medax_points *points);

/**
 * The number of rows of the input that were left out.
 *
 * \param points The points; NULL has none.
 * \return The number of rows that map to no vertex.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API size_t medax_points_skipped_count(const medax_points *points);

/**
 * The smallest box that holds every point.
 *
 * \param points The points.
 * \param out_min Receives the three least coordinates.
 * \param out_max Receives the three greatest coordinates.
 * \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_status medax_points_bounds(const medax_points *points,
                                 double *out_min,
                                 double *out_max);

/**
 * One more reference to points.
 *
 * \param points The points, or NULL.
 * \return The same pointer; the caller frees it once more.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API const medax_points *medax_points_clone(const medax_points *points);

/**
 * Gives one reference to points back; the last one frees them.
 *
 * \param points The points; NULL does nothing.
 *
 * Since 0.1.
 */
MEDAX_API void medax_points_free(const medax_points *points);

/* ---- 8. Triangulation ------------------------------------------------------------------------
 *
 * Exact Delaunay and regular triangulations. The power distance of a point x to a vertex p of
 * weight w is |x - p|^2 - w; a cell is in the regular triangulation when no other vertex has a
 * smaller power distance to the cell's orthocentre than the cell's own have. Without weights
 * that is the Delaunay triangulation. A vertex whose weight is too small for any cell is hidden.
 * Ties are broken by a symbolic perturbation, so that the cells depend on the set alone.
 *
 * Vertices are those of the points. Facet i of a cell is the one opposite its vertex i.
 */

/**
 * The settings of a triangulation: none yet but the size.
 */
typedef struct {
    /**
     * The size of this struct in the caller's program.
     */
    size_t struct_size;
} medax_triangulation_options;

/**
 * Sets triangulation options to their defaults.
 *
 * \param options The caller's struct, of `struct_size` bytes.
 * \param struct_size `sizeof *options`.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_status medax_triangulation_options_init(medax_triangulation_options *options,
                                              size_t struct_size);

/**
 * Builds the Delaunay triangulation of points.
 *
 * \param points The points, which the triangulation keeps alive.
 * \param options NULL for the defaults.
 * \param job NULL for a default job.
 * \param out_triangulation Receives the triangulation, which the caller frees with
 *        #medax_triangulation_free.
 * \return `MEDAX_STATUS_OK`; `TOO_FEW_POINTS` below four distinct points; `DEGENERATE` when all
 *         lie in a plane; `LIMIT_EXCEEDED` past 2^30 cells; `NULL_ARGUMENT`, `INVALID_ARGUMENT`,
 *         `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * Expected O(n log n) where there are O(n) cells. Since 0.1.
 */
MEDAX_API
medax_status medax_delaunay_build(const medax_points *points,
                                  const medax_triangulation_options *options,
                                  const medax_job *job,
                                  const medax_triangulation **out_triangulation);

/**
 * Builds the regular triangulation of weighted points.
 *
 * \param points The points, which the triangulation keeps alive.
 * \param weights `weight_count` weights in squared input units, one per row of the points' input.
 *        Of rows with equal coordinates the largest weight wins. Copied.
 * \param weight_count #medax_points_row_count.
 * \param options NULL for the defaults.
 * \param job NULL for a default job.
 * \param out_triangulation Receives the triangulation, which the caller frees with
 *        #medax_triangulation_free.
 * \return As #medax_delaunay_build; also `MISMATCH` for a wrong number of weights, `NON_FINITE` and
 *         `COORDINATE_RANGE` with the row of a weight.
 *
 * Expected O(n log n) where there are O(n) cells. Since 0.1.
 */
MEDAX_API
medax_status medax_regular_build(const medax_points *points,
                                 const double *weights,
                                 size_t weight_count,
                                 const medax_triangulation_options *options,
                                 const medax_job *job,
                                 const medax_triangulation **out_triangulation);

/**
 * The points of a triangulation.
 *
 * \param triangulation The triangulation.
 * \param out_points Receives the points, which the caller frees with #medax_points_free.
 * \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_status medax_triangulation_points(const medax_triangulation *triangulation,
                                        const medax_points **out_points);

/**
 * The coordinates of the vertices.
 *
 * \param triangulation The triangulation, or NULL.
 * \return n x 3, in input units. Borrowed from `triangulation`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_f64 medax_triangulation_coords(const medax_triangulation *triangulation);

/**
 * The weights of the vertices.
 *
 * \param triangulation The triangulation, or NULL.
 * \return n x 1, in squared input units; no row for a Delaunay triangulation. Borrowed from
 *         `triangulation`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_f64 medax_triangulation_weights(const medax_triangulation *triangulation);

/**
 * The row of the input that each vertex stands for.
 *
 * \param triangulation The triangulation, or NULL.
 * \return n x 1: the first row with the vertex's coordinates, in a regular triangulation the first
 *         of the heaviest ones. Borrowed from `triangulation`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_view_u32 medax_triangulation_row_of_vertex(const medax_triangulation *triangulation);

/**
 * The finite cells.
 *
 * \param triangulation The triangulation, or NULL.
 * \return m x 4 vertices, positively oriented: the determinant of b - a, c - a, d - a is positive.
 *         The least vertex comes first, the second least next; cells ascend by their vertices.
 *         Borrowed from `triangulation`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_u32 medax_triangulation_cells(const medax_triangulation *triangulation);

/**
 * The neighbours of the finite cells.
 *
 * \param triangulation The triangulation, or NULL.
 * \return m x 4 cells: column i shares facet i with the cell, and is `MEDAX_NONE` on the hull.
 *         Borrowed from `triangulation`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_u32 medax_triangulation_neighbors(const medax_triangulation *triangulation);

/**
 * The vertices that no cell uses, because their weights are too small.
 *
 * \param triangulation The triangulation, or NULL.
 * \return Hidden vertices x 1, ascending. Borrowed from `triangulation`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_u32 medax_triangulation_hidden(const medax_triangulation *triangulation);

/**
 * A cell that holds a point. Of a point on a facet, edge or vertex, which lies in several cells,
 * the hint decides which one.
 *
 * \param triangulation The triangulation.
 * \param xyz The three coordinates of the point.
 * \param hint_cell Where to begin the search; any number that is no cell stands for cell 0.
 * \param out_cell Receives the cell, or `MEDAX_NONE` outside the convex hull.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, `NON_FINITE`, `COORDINATE_RANGE`.
 *
 * O(cells between the hint and the point). Since 0.1.
 */
MEDAX_API
medax_status medax_triangulation_locate(const medax_triangulation *triangulation,
                                        const double *xyz,
                                        uint32_t hint_cell,
                                        uint32_t *out_cell);

/**
 * The ring of cells round an edge, counterclockwise seen from `b` to `a`. A closed ring begins
 * with its least cell, one that the hull cuts begins where it has the hull behind it.
 *
 * \param triangulation The triangulation.
 * \param cell A cell that has the edge, such as #medax_incidence_cell_of_edge names.
 * \param a One vertex of the edge.
 * \param b The other one.
 * \param capacity The number of cells for which `out_cells` has room.
 * \param out_cells Receives the first `capacity` cells of the ring; NULL only if `capacity` is 0.
 * \param out_count Receives the length of the ring, which may be more than `capacity`.
 * \param out_closed Receives 1 if the ring is closed, 0 if the edge lies on the hull.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` with the cell if it does not
 *         have the edge.
 *
 * O(length of the ring). Since 0.1.
 */
MEDAX_API
medax_status medax_triangulation_ring(const medax_triangulation *triangulation,
                                      uint32_t cell,
                                      uint32_t a,
                                      uint32_t b,
                                      size_t capacity,
                                      uint32_t *out_cells,
                                      size_t *out_count,
                                      uint32_t *out_closed);

/**
 * The vertices of a triangulation, hidden ones included, and its cells as tetrahedra, for writing.
 * Vertices have the attribute `row`, and `weight` where there are weights.
 *
 * \param triangulation The triangulation.
 * \param out_complex Receives the complex, which the caller frees with #medax_complex_free.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `LIMIT_EXCEEDED` past 2^32 - 1
 *         corners of cells.
 *
 * O(n). Since 0.1.
 */
MEDAX_API
medax_status medax_triangulation_complex(const medax_triangulation *triangulation,
                                         const medax_complex **out_complex);

/**
 * Checks a triangulation in exact arithmetic: order, orientation, adjacency, the empty sphere
 * or power of every facet, the convex hull, Euler's formula, the hidden vertices.
 *
 * \param triangulation The triangulation.
 * \param job NULL for a default job.
 * \param out_report Filled, its `struct_size` being set.
 * \return `MEDAX_STATUS_OK` whatever was found; `NULL_ARGUMENT`, `INVALID_ARGUMENT` for a report
 *         of no version, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(m) exact predicates. Since 0.1.
 */
MEDAX_API
medax_status medax_triangulation_validate(const medax_triangulation *triangulation,
                                          const medax_job *job,
                                          medax_validation *out_report);

/**
 * One more reference to a triangulation.
 *
 * \param triangulation The triangulation, or NULL.
 * \return The same pointer; the caller frees it once more.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
const medax_triangulation *medax_triangulation_clone(const medax_triangulation *triangulation);

/**
 * Gives one reference to a triangulation back; the last one frees it.
 *
 * \param triangulation The triangulation; NULL does nothing.
 *
 * Since 0.1.
 */
MEDAX_API void medax_triangulation_free(const medax_triangulation *triangulation);

/* ---- 9. Incidence ----------------------------------------------------------------------------
 *
 * What a triangulation tells only indirectly: the cells of each vertex, and the edges.
 */

/**
 * Builds the incidences of a triangulation.
 *
 * \param triangulation The triangulation.
 * \param job NULL for a default job.
 * \param out_incidence Receives the incidences, which the caller frees with
 *        #medax_incidence_free.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(m log m). Since 0.1.
 */
MEDAX_API
medax_status medax_incidence_build(const medax_triangulation *triangulation,
                                   const medax_job *job,
                                   const medax_incidence **out_incidence);

/**
 * The cells of each vertex.
 *
 * \param incidence The incidences, or NULL.
 * \return One row a vertex: the cells that have it, ascending; a hidden vertex has none. Borrowed
 *         from `incidence`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_rows medax_incidence_cells_of_vertex(const medax_incidence *incidence);

/**
 * The edges.
 *
 * \param incidence The incidences, or NULL.
 * \return e x 2 vertices, the lesser one first; edges ascend. Borrowed from `incidence`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_u32 medax_incidence_edges(const medax_incidence *incidence);

/**
 * A cell of each edge, from which #medax_triangulation_ring finds the others.
 *
 * \param incidence The incidences, or NULL.
 * \return e x 1: the least cell that has the edge. Borrowed from `incidence`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_u32 medax_incidence_cell_of_edge(const medax_incidence *incidence);

/**
 * One more reference to incidences.
 *
 * \param incidence The incidences, or NULL.
 * \return The same pointer; the caller frees it once more.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API const medax_incidence *medax_incidence_clone(const medax_incidence *incidence);

/**
 * Gives one reference to incidences back; the last one frees them.
 *
 * \param incidence The incidences; NULL does nothing.
 *
 * Since 0.1.
 */
MEDAX_API void medax_incidence_free(const medax_incidence *incidence);

/* ---- 10. Dual ---------------------------------------------------------------------------------
 *
 * The Voronoi diagram of a Delaunay triangulation, or the power diagram of a regular one. A Voronoi
 * vertex is dual to a cell of the triangulation, an edge to a facet, a facet to an edge, a
 * Voronoi cell to a vertex. What is unbounded continues along rays, one for each facet of the hull.
 */

/**
 * What a dual holds besides centres, squared radii and rays.
 */
typedef struct {
    /**
     * The size of this struct in the caller's program.
     */
    size_t struct_size;
    /**
     * 1 keeps the Voronoi facets: a ring of cells for each edge. 0, the default: none.
     */
    uint32_t facets;
    /**
     * Must be 0.
     */
    uint32_t reserved;
} medax_dual_options;

/**
 * Sets dual options to their defaults.
 *
 * \param options The caller's struct, of `struct_size` bytes.
 * \param struct_size `sizeof *options`.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_status medax_dual_options_init(medax_dual_options *options, size_t struct_size);

/**
 * Reads the dual off a triangulation.
 *
 * \param triangulation The triangulation, which the dual keeps alive.
 * \param options NULL for the defaults.
 * \param job NULL for a default job.
 * \param out_dual Receives the dual, which the caller frees with #medax_dual_free.
 * \return `MEDAX_STATUS_OK`; `LIMIT_EXCEEDED` where the rings of facets have more than 2^32 - 1 entries
 *         together; `NULL_ARGUMENT`, `INVALID_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(m) for m cells. Since 0.1.
 */
MEDAX_API
medax_status medax_dual_build(const medax_triangulation *triangulation,
                              const medax_dual_options *options,
                              const medax_job *job,
                              const medax_dual **out_dual);

/**
 * The triangulation of a dual.
 *
 * \param dual The dual.
 * \param out_triangulation Receives the triangulation, which the caller frees with
 *        #medax_triangulation_free.
 * \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_status medax_dual_triangulation(const medax_dual *dual,
                                      const medax_triangulation **out_triangulation);

/**
 * The Voronoi vertex of each cell: its circumcentre, or its orthocentre in a power diagram.
 *
 * \param dual The dual, or NULL.
 * \return m x 3, in input units, correctly rounded; never NaN or infinite. Borrowed from `dual`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_f64 medax_dual_centers(const medax_dual *dual);

/**
 * The squared radius of each cell's sphere; negative where weights are large.
 *
 * \param dual The dual, or NULL.
 * \return m x 1, in squared input units, correctly rounded; never NaN or infinite. Borrowed from
 *         `dual`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_f64 medax_dual_radii_squared(const medax_dual *dual);

/**
 * Where the unbounded Voronoi edges begin and leave: facets of the hull.
 *
 * \param dual The dual, or NULL.
 * \return r x 2, ascending: a cell, at whose centre the ray begins, and the facet 0 to 3 of that cell
 *         whose plane it crosses at a right angle. Borrowed from `dual`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_view_u32 medax_dual_ray_facets(const medax_dual *dual);

/**
 * The directions of the unbounded Voronoi edges.
 *
 * \param dual The dual, or NULL.
 * \return r x 3 unit vectors, outward. Borrowed from `dual`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_f64 medax_dual_ray_directions(const medax_dual *dual);

/**
 * The facets of the diagram: each the ring of the centres of its cells.
 *
 * \param dual The dual, or NULL.
 * \return One row a facet, in the order of #medax_dual_facet_edges: cells, each the neighbour of the
 *         one before, counterclockwise round the edge from its lesser vertex to the greater. A bounded
 *         facet's ring is closed and begins with its least cell. An unbounded one's is open: rays
 *         continue it. No row unless the options asked for facets. Borrowed from `dual`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_view_rows medax_dual_facets(const medax_dual *dual);

/**
 * The edge of the triangulation to which each facet is dual.
 *
 * \param dual The dual, or NULL.
 * \return f x 2 vertices, the lesser first, ascending; no row unless the options asked for facets.
 *         Borrowed from `dual`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_u32 medax_dual_facet_edges(const medax_dual *dual);

/**
 * The rays of each facet.
 *
 * \param dual The dual, or NULL.
 * \return f x 2 rays: the one that comes in from infinity to the first cell, and the one that goes
 *         out from the last; `MEDAX_NONE` twice for a bounded facet. No row unless the options
 *         asked for facets. Borrowed from `dual`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_u32 medax_dual_facet_rays(const medax_dual *dual);

/**
 * Checks a dual: that each centre has the same power with respect to its cell's vertices, that rays are
 * normal to the hull, that rings are sound.
 *
 * \param dual The dual.
 * \param job NULL for a default job.
 * \param out_report Filled, its `struct_size` being set.
 * \return `MEDAX_STATUS_OK` whatever was found; `NULL_ARGUMENT`, `INVALID_ARGUMENT` for a report
 *         of no version, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(m). Since 0.1.
 */
MEDAX_API
medax_status medax_dual_validate(const medax_dual *dual,
                                 const medax_job *job,
                                 medax_validation *out_report);

/**
 * One more reference to a dual.
 *
 * \param dual The dual, or NULL.
 * \return The same pointer; the caller frees it once more.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API const medax_dual *medax_dual_clone(const medax_dual *dual);

/**
 * Gives one reference to a dual back; the last one frees it.
 *
 * \param dual The dual; NULL does nothing.
 *
 * Since 0.1.
 */
MEDAX_API void medax_dual_free(const medax_dual *dual);

/* ---- 11. Poles --------------------------------------------------------------------------------
 *
 * The first pole of a sample is the farthest vertex of its Voronoi cell, the second the farthest one
 * on the other side. A Voronoi vertex that several samples choose is one pole. The ball round a
 * pole that passes through its samples is its polar ball. The Voronoi cell of a sample on the hull is
 * unbounded: its first pole is at infinity, and is no row of the balls.
 *
 * Poles with the far box are those of the power crust: eight points far round the sample make
 * every Voronoi cell bounded. These eight are in no count but those of #medax_poles_triangulation.
 */

/**
 * What is left out where the Voronoi cell of a sample is not long and thin: where one of its poles is nearer than the cell's
 * width allows for the spacing `lambda` (section 6 of the paper).
 */
enum medax_omit
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
    /**
     * Nothing.
     */
    MEDAX_OMIT_NOTHING = 0,
    /**
     * The pole that is too near: for noise.
     */
    MEDAX_OMIT_SIDE = 1,
    /**
     * Both poles of the sample where one is too near: for sharp edges and corners.
     */
    MEDAX_OMIT_BOTH = 2,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum medax_omit medax_omit;
#else
typedef uint32_t medax_omit;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

/**
 * The settings of poles.
 */
typedef struct {
    /**
     * The size of this struct in the caller's program.
     */
    size_t struct_size;
    /**
     * An estimate of the spacing of the sample, relative to the local feature size, in [0, pi/4); 0, the default, to estimate it
     * from the sample. Without effect where nothing is left out.
     */
    double lambda;
    /**
     * A #medax_omit: what is left out; `MEDAX_OMIT_NOTHING` by default.
     */
    uint32_t omit;
    /**
     * Must be 0.
     */
    uint32_t reserved;
} medax_poles_options;

/**
 * Sets poles options to their defaults.
 *
 * \param options The caller's struct, of `struct_size` bytes.
 * \param struct_size `sizeof *options`.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_status medax_poles_options_init(medax_poles_options *options, size_t struct_size);

/**
 * Builds the poles of a sample from its Voronoi diagram.
 *
 * \param dual The dual of a Delaunay triangulation.
 * \param options NULL for the defaults.
 * \param job NULL for a default job.
 * \param out_poles Receives the poles, which the caller frees with #medax_poles_free.
 * \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` for the dual of a regular triangulation and for options out of range;
 *         `TOO_FEW_POINTS` where all poles would be left out;
 *         `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(m) for m cells. Since 0.1.
 */
MEDAX_API
medax_status medax_poles_build(const medax_dual *dual,
                               const medax_poles_options *options,
                               const medax_job *job,
                               const medax_poles **out_poles);

/**
 * Builds the poles of a sample with the far box: those from which a power crust is made.
 *
 * \param points The sample.
 * \param options NULL for the defaults.
 * \param job NULL for a default job.
 * \param out_poles Receives the poles, which the caller frees with #medax_poles_free.
 * \return `MEDAX_STATUS_OK`; `TOO_FEW_POINTS` below four distinct points, or where all poles would be left out; `DEGENERATE` when all
 *         lie in a plane; `COORDINATE_RANGE` where there is no room for the far box;
 *         `LIMIT_EXCEEDED` past 2^30 cells; `NULL_ARGUMENT`, `INVALID_ARGUMENT`, `CANCELLED`,
 *         `BUSY`, `OUT_OF_MEMORY`.
 *
 * One Delaunay triangulation, then O(m log m) for its m cells. Since 0.1.
 */
MEDAX_API
medax_status medax_poles_build_with_far_box(const medax_points *points,
                                            const medax_poles_options *options,
                                            const medax_job *job,
                                            const medax_poles **out_poles);

/**
 * The triangulation whose cells' circumcentres the poles are.
 *
 * \param poles The poles.
 * \param out_triangulation Receives the triangulation, which the caller frees with
 *        #medax_triangulation_free. Its vertices are the samples, and after them the far box if
 *        there is one.
 * \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_status medax_poles_triangulation(const medax_poles *poles,
                                       const medax_triangulation **out_triangulation);

/**
 * Whether the poles were chosen with the far box.
 *
 * \param poles The poles; NULL was not.
 * \return True for the poles of a power crust.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API bool medax_poles_has_far_box(const medax_poles *poles);

/**
 * The polar balls. Poles are numbered by the spatial rank of their centres.
 *
 * \param poles The poles, or NULL.
 * \return p x 4: the three coordinates of the centre and the radius, in input units. Borrowed from
 *         `poles`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_f64 medax_poles_balls(const medax_poles *poles);

/**
 * The squared radius of each polar ball, rounded once: the weight of the pole in the power
 * diagram.
 *
 * \param poles The poles, or NULL.
 * \return p x 1, in squared input units. Borrowed from `poles`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_f64 medax_poles_radii_squared(const medax_poles *poles);

/**
 * The cell of #medax_poles_triangulation whose circumcentre each pole is.
 *
 * \param poles The poles, or NULL.
 * \return p x 1 cells: the least chosen one if several have the same circumsphere. Borrowed from
 *         `poles`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_u32 medax_poles_cell_of_pole(const medax_poles *poles);

/**
 * Whether the Delaunay cell of each pole has a corner of the far box: such poles are outer from the
 * start.
 *
 * \param poles The poles, or NULL.
 * \return p x 1 flags, 0 or 1. Borrowed from `poles`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_u8 medax_poles_touches_far_box(const medax_poles *poles);

/**
 * The poles of each sample.
 *
 * \param poles The poles, or NULL.
 * \return n x 2: the first and second pole of each vertex of the points; `MEDAX_NONE` where there is
 *         none, or it is at infinity, or left out. Borrowed from `poles`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_view_u32 medax_poles_pole_of_sample(const medax_poles *poles);

/**
 * The samples on each polar ball, ascending: those whose Voronoi cells meet at the pole.
 *
 * \param poles The poles, or NULL.
 * \return p rows of vertices of the points: four or more, or fewer where the ball touches the far box. Borrowed from `poles`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_view_rows medax_poles_samples_on_balls(const medax_poles *poles);

/**
 * The object angle of each pole: the largest angle at its centre between two samples on its ball.
 *
 * \param poles The poles, or NULL.
 * \return p x 1, in [0, pi] radians; 0 where fewer than two samples are on the ball. Borrowed from `poles`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_view_f64 medax_poles_object_angles(const medax_poles *poles);

/**
 * The lambda by which poles were left out.
 *
 * \param poles The poles, or NULL.
 * \return As given or, if that was 0, as estimated; 0 where nothing was to be left out.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API double medax_poles_lambda(const medax_poles *poles);

/**
 * The unit vector from each sample towards its first pole, be it at infinity: normal to the
 * surface, on either side of it.
 *
 * \param poles The poles, or NULL.
 * \return n x 3. Borrowed from `poles`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_f64 medax_poles_normals(const medax_poles *poles);

/**
 * The distance from points to the nearest pole: an estimate of the local feature size, the
 * distance to the medial axis.
 *
 * \param poles The poles.
 * \param query_xyz `query_count` x 3 coordinates; NULL only if `query_count` is 0.
 * \param query_count The number of points.
 * \param job NULL for a default job.
 * \param out_distances Receives `query_count` distances in input units, infinite if all poles are
 *        at infinity; the caller's buffer, NULL only if `query_count` is 0.
 * \return `MEDAX_STATUS_OK`; `NON_FINITE`, or `COORDINATE_RANGE` beyond 2^200, with the row of a query;
 *         `NULL_ARGUMENT`, `INVALID_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(log p) a query, and O(p log p) once, in the first call. Since 0.1.
 */
MEDAX_API
medax_status medax_poles_feature_size(const medax_poles *poles,
                                      const double *query_xyz,
                                      size_t query_count,
                                      const medax_job *job,
                                      double *out_distances);

/**
 * The poles as vertices with the attributes `radius` and `object_angle`, in their order, for writing.
 *
 * \param poles The poles.
 * \param out_complex Receives the complex, which the caller frees with #medax_complex_free.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`.
 *
 * O(n). Since 0.1.
 */
MEDAX_API
medax_status medax_poles_complex(const medax_poles *poles,
                                 const medax_complex **out_complex);

/**
 * The samples as vertices with the attribute `normal`, for writing.
 *
 * \param poles The poles.
 * \param out_complex Receives the complex, which the caller frees with #medax_complex_free.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`.
 *
 * O(n). Since 0.1.
 */
MEDAX_API
medax_status medax_poles_samples_complex(const medax_poles *poles,
                                         const medax_complex **out_complex);

/**
 * Checks poles: that each is what its samples' Voronoi cells make it.
 *
 * \param poles The poles.
 * \param job NULL for a default job.
 * \param out_report Filled, its `struct_size` being set.
 * \return `MEDAX_STATUS_OK` whatever was found; `NULL_ARGUMENT`, `INVALID_ARGUMENT` for a report
 *         of no version, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * As building the poles anew. Since 0.1.
 */
MEDAX_API
medax_status medax_poles_validate(const medax_poles *poles,
                                  const medax_job *job,
                                  medax_validation *out_report);

/**
 * One more reference to poles.
 *
 * \param poles The poles, or NULL.
 * \return The same pointer; the caller frees it once more.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API const medax_poles *medax_poles_clone(const medax_poles *poles);

/**
 * Gives one reference to poles back; the last one frees them.
 *
 * \param poles The poles; NULL does nothing.
 *
 * Since 0.1.
 */
MEDAX_API void medax_poles_free(const medax_poles *poles);

/* ---- 12. Power crust --------------------------------------------------------------------------
 *
 * The poles are labelled inner and outer; the power diagram of their balls then falls into the solid
 * and its complement, and the power crust is the boundary between them: closed by construction,
 * made of convex polygons, and pointing out of the solid. A pole with an unbounded power cell is
 * outer, and so is one that no label reached. The power shape of a side connects its poles as the
 * regular triangulation of the balls does: an approximation of the medial axis.
 * (Amenta, Choi, Kolluri 2001, The Power Crust.)
 */

/**
 * The side of the surface on which a pole lies.
 */
enum medax_label
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
    /**
     * Outside the solid.
     */
    MEDAX_LABEL_OUTER = 0,
    /**
     * Inside the solid.
     */
    MEDAX_LABEL_INNER = 1,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum medax_label medax_label;
#else
typedef uint32_t medax_label;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

/**
 * How poles are labelled.
 */
enum medax_label_rule
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
    /**
     * As `MEDAX_LABEL_RULE_SPREAD`; as `MEDAX_LABEL_RULE_LEAST_CONFLICT` if that leaves a conflict above 0.005.
     */
    MEDAX_LABEL_RULE_AUTO = 0,
    /**
     * Labels spread from the far box, the most certain first, and are never taken back (Figure 8 of the paper).
     */
    MEDAX_LABEL_RULE_SPREAD = 1,
    /**
     * Then labels are changed until they contradict each other as little as can be found: for noise, and for samples
     * with large gaps.
     */
    MEDAX_LABEL_RULE_LEAST_CONFLICT = 2,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum medax_label_rule medax_label_rule;
#else
typedef uint32_t medax_label_rule;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

/**
 * The settings of a power crust.
 */
typedef struct {
    /**
     * The size of this struct in the caller's program.
     */
    size_t struct_size;
    /**
     * Neighbouring balls intersect deeply, and so lie on the same side, where -cos of the angle
     * between their spheres exceeds this; in [0, 1], 0.4 by default.
     */
    double deep;
    /**
     * As in #medax_poles_options, where poles are chosen: not for #medax_power_crust_build_from_poles.
     */
    double lambda;
    /**
     * 1 to take the power diagram of balls whose centres are rounded to a grid, which is faster; 0, the
     * default, not to. The step of the grid is 2^-36 of the least power of two that the longest side of the
     * samples' box does not exceed. #medax_power_crust_regular and the shapes then have the rounded balls,
     * #medax_power_crust_poles those that were chosen; offsets and simplified crusts are made of these.
     */
    uint32_t round_poles;
    /**
     * 1 to keep the shards of every sample, the vertices of the power diagram that are the sample itself but for the rounding of
     * the balls; 0, the default, to make them one vertex, exactly where the sample is.
     */
    uint32_t keep_shards;
    /**
     * A #medax_omit: which poles are left out, where they are chosen: not for #medax_power_crust_build_from_poles.
     * `MEDAX_OMIT_NOTHING` by default.
     */
    uint32_t omit;
    /**
     * A #medax_label_rule: how poles are labelled. `MEDAX_LABEL_RULE_AUTO` by default.
     */
    uint32_t label_rule;
    /**
     * Where the scanner of a one-sided scan was, if `has_viewpoint` is 1: what it sees a sample from is outside, and labels
     * spread from there instead of from the far box.
     */
    double viewpoint[3];
    /**
     * 1 if there is a viewpoint; 0, the default, if not.
     */
    uint32_t has_viewpoint;
    /**
     * Must be 0.
     */
    uint32_t reserved;
} medax_power_crust_options;

/**
 * Sets power crust options to their defaults.
 *
 * \param options The caller's struct, of `struct_size` bytes.
 * \param struct_size `sizeof *options`.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_status medax_power_crust_options_init(medax_power_crust_options *options,
                                            size_t struct_size);

/**
 * Builds the power crust of a sample.
 *
 * \param points The sample.
 * \param options NULL for the defaults.
 * \param job NULL for a default job.
 * \param out_crust Receives the power crust, which the caller frees with #medax_power_crust_free.
 * \return As #medax_poles_build_with_far_box; also `INVALID_ARGUMENT` for options out of range.
 *
 * Two triangulations: of the n samples, and of their at most 2 n poles. Since 0.1.
 */
MEDAX_API
medax_status medax_power_crust_build(const medax_points *points,
                                     const medax_power_crust_options *options,
                                     const medax_job *job,
                                     const medax_power_crust **out_crust);

/**
 * Builds the power crust of poles, without choosing them again.
 *
 * \param poles Poles with the far box, which the power crust keeps alive.
 * \param options NULL for the defaults.
 * \param job NULL for a default job.
 * \param out_crust Receives the power crust, which the caller frees with #medax_power_crust_free.
 * \return As #medax_power_crust_build; also `MISMATCH` for poles without the far box.
 *
 * One regular triangulation of the poles. Since 0.1.
 */
MEDAX_API
medax_status medax_power_crust_build_from_poles(const medax_poles *poles,
                                                const medax_power_crust_options *options,
                                                const medax_job *job,
                                                const medax_power_crust **out_crust);

/**
 * The surface: convex polygons that point out of the solid. Faces have the attributes `inner_pole`
 * and `outer_pole`. Vertices have `cell`, the cell of #medax_power_crust_regular whose orthocentre they
 * are, and `sample`: the vertex of the points that they are, or `MEDAX_NONE`. With shards merged such a vertex lies exactly where the
 * sample does, and `cell` is the least of its shards; shards that stay apart, because merging would change the topology or turn a
 * triangle over, are no sample then.
 *
 * \param crust The power crust.
 * \param out_surface Receives the surface, which the caller frees with #medax_complex_free.
 * \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_status medax_power_crust_surface(const medax_power_crust *crust,
                                       const medax_complex **out_surface);

/**
 * The power shape of one side: its poles, and the faces, edges and cells of #medax_power_crust_regular between them.
 *
 * Vertices have the attributes `radius`, `pole`, `label` (a #medax_label) and `object_angle` (see #medax_poles_object_angles). Cells are
 * tetrahedra, most of them flat, and have `flatness`: the least altitude relative to the longest edge. #medax_complex_flatten
 * collapses flat ones.
 *
 * \param crust The power crust.
 * \param label A #medax_label: which side.
 * \param out_shape Receives the shape, which the caller frees with #medax_complex_free.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a number that is no label.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_status medax_power_crust_shape(const medax_power_crust *crust,
                                     uint32_t label,
                                     const medax_complex **out_shape);

/**
 * The poles of a power crust.
 *
 * \param crust The power crust.
 * \param out_poles Receives the poles, which the caller frees with #medax_poles_free.
 * \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_status medax_power_crust_poles(const medax_power_crust *crust,
                                     const medax_poles **out_poles);

/**
 * The regular triangulation of the polar balls. Poles are the rows of its points:
 * #medax_triangulation_row_of_vertex names the pole of each vertex.
 *
 * \param crust The power crust.
 * \param out_regular Receives the triangulation, which the caller frees with
 *        #medax_triangulation_free.
 * \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_status medax_power_crust_regular(const medax_power_crust *crust,
                                       const medax_triangulation **out_regular);

/**
 * The label of each pole.
 *
 * \param crust The power crust, or NULL.
 * \return p x 1: a #medax_label. Borrowed from `crust`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_u32 medax_power_crust_labels(const medax_power_crust *crust);

/**
 * The poles as vertices with the attributes `radius`, `object_angle` and `label`, in their order, for writing.
 *
 * \param crust The power crust.
 * \param out_complex Receives the complex, which the caller frees with #medax_complex_free.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`.
 *
 * O(n). Since 0.1.
 */
MEDAX_API
medax_status medax_power_crust_poles_complex(const medax_power_crust *crust,
                                             const medax_complex **out_complex);

/**
 * The power shapes of both sides in one complex, the inner one first, with their attributes; the sides share no vertex.
 *
 * \param crust The power crust.
 * \param out_complex Receives the complex, which the caller frees with #medax_complex_free.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `LIMIT_EXCEEDED` past 2^32 - 2 elements.
 *
 * O(n). Since 0.1.
 */
MEDAX_API
medax_status medax_power_crust_both_shapes(const medax_power_crust *crust,
                                           const medax_complex **out_complex);

/**
 * Whether a pole takes part in the power diagram: it is neither hidden nor a lighter duplicate of
 * another pole's centre.
 *
 * \param crust The power crust; NULL has no poles.
 * \param pole The pole.
 * \return False also for a number that is no pole.
 *
 * O(log p). Since 0.1.
 */
MEDAX_API bool medax_power_crust_is_visible(const medax_power_crust *crust, uint32_t pole);

/**
 * The number of poles that no label reached, and that are outer for that reason.
 *
 * \param crust The power crust; NULL has none.
 * \return The number of poles.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API size_t medax_power_crust_unreached_count(const medax_power_crust *crust);

/**
 * The number of poles made outer because their power cells are unbounded.
 *
 * \param crust The power crust; NULL has none.
 * \return The number of poles.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API size_t medax_power_crust_forced_count(const medax_power_crust *crust);

/**
 * How much the labels contradict each other: the sum of the squared weights of the links that do not have the labels that they
 * ask for, divided by the number of poles. Links are samples with two poles, which ask for different labels, and
 * balls that intersect deeply, which ask for the same.
 *
 * \param crust The power crust; NULL has none.
 * \return The conflict: 1e-3 and less where a sample is dense; near 0.1 the solid is a guess.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
double medax_power_crust_conflict(const medax_power_crust *crust);

/**
 * Whether labels were changed to lessen their conflict: `MEDAX_LABEL_RULE_LEAST_CONFLICT` was asked for, or needed.
 *
 * \param crust The power crust; NULL has no labels.
 * \return Whether they were.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
bool medax_power_crust_is_settled(const medax_power_crust *crust);

/**
 * Checks a power crust: the labels, that the surface is closed and is the boundary between inner and outer cells, that merging shards moved
 * vertices to their samples and turned no triangle over, the shapes.
 *
 * \param crust The power crust.
 * \param job NULL for a default job.
 * \param out_report Filled, its `struct_size` being set.
 * \return `MEDAX_STATUS_OK` whatever was found; `NULL_ARGUMENT`, `INVALID_ARGUMENT` for a report
 *         of no version, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(p log p). Since 0.1.
 */
MEDAX_API
medax_status medax_power_crust_validate(const medax_power_crust *crust,
                                        const medax_job *job,
                                        medax_validation *out_report);

/**
 * One more reference to a power crust.
 *
 * \param crust The power crust, or NULL.
 * \return The same pointer; the caller frees it once more.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API const medax_power_crust *medax_power_crust_clone(const medax_power_crust *crust);

/**
 * Gives one reference to a power crust back; the last one frees it.
 *
 * \param crust The power crust; NULL does nothing.
 *
 * Since 0.1.
 */
MEDAX_API void medax_power_crust_free(const medax_power_crust *crust);

/* ---- 13. Power crusts with other labels -------------------------------------------------------
 *
 * Labels can be given by the host, or be told by a mesh whose inside is known. Poles and the regular triangulation stay;
 * the surface and the shapes are made anew.
 */

/**
 * The same poles with other labels.
 *
 * An inner pole with an unbounded power cell becomes outer, and is counted by #medax_power_crust_forced_count. Offsets and simplified power
 * crusts of the result keep the labels.
 *
 * \param crust The power crust.
 * \param labels `label_count` values: a #medax_label for each pole, in the order of #medax_power_crust_labels.
 * \param label_count The number of labels, which is that of the poles.
 * \param job NULL for a default job.
 * \param out_crust Receives the power crust with these labels, which the caller frees with #medax_power_crust_free.
 * \return `MEDAX_STATUS_OK`; `MISMATCH` unless there is one label per pole; `INVALID_ARGUMENT` with the row of a number that is no
 *         label; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(size), without a triangulation. Since 0.1.
 */
MEDAX_API
medax_status medax_power_crust_with_labels(const medax_power_crust *crust,
                                           const uint32_t *labels,
                                           size_t label_count,
                                           const medax_job *job,
                                           const medax_power_crust **out_crust);

/**
 * The same poles, labelled by a mesh: inner are those round whose centres its faces wind more than half a time, by
 * #medax_complex_winding_numbers.
 *
 * Faces must point out of the solid, and those of voids into them; where shells overlap is inside. Holes are closed where the number passes through
 * one half. Of a mesh that is turned inside out no pole is inner, and the surface is empty: #medax_complex_orient turns it. The samples need not
 * be the mesh's vertices. The rest is as for #medax_power_crust_with_labels.
 *
 * \param crust The power crust.
 * \param mesh The mesh, as a complex with faces.
 * \param job NULL for a default job.
 * \param out_crust Receives the power crust with these labels, which the caller frees with #medax_power_crust_free.
 * \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` for a mesh without faces; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O((n + p) log n) for n triangles and p poles, without a triangulation. Since 0.1.
 */
MEDAX_API
medax_status medax_power_crust_labelled_by_mesh(const medax_power_crust *crust,
                                                const medax_complex *mesh,
                                                const medax_job *job,
                                                const medax_power_crust **out_crust);

/* ---- 14. Power crusts of other balls ----------------------------------------------------------
 *
 * Offsets, simplified power shapes and surfaces with holes are made from a power crust without starting over. Labels are kept, and so
 * are the numbers of poles: those whose balls are left out have no vertex in the regular triangulation.
 * (Amenta, Choi, Kolluri 2001, The Power Crust, section 7.)
 */

/**
 * How far a power shape is simplified.
 */
typedef struct {
    /**
     * The size of this struct in the caller's program.
     */
    size_t struct_size;
    /**
     * Poles go whose samples are all within this distance of each other, in input units; negative, as by default, for a hundredth
     * of the diagonal of the samples' box.
     */
    double epsilon;
    /**
     * Poles go whose balls lie in that of a larger ball, grown by this, in input units; negative, as by default, for three
     * thousandths of the diagonal.
     */
    double delta;
} medax_simplify_options;

/**
 * Which faces of a power crust fill holes.
 */
typedef struct {
    /**
     * The size of this struct in the caller's program.
     */
    size_t struct_size;
    /**
     * The two balls of a face intersect deeply where -cos of the angle between their spheres exceeds this; in [0, 1], 0.1 by
     * default.
     */
    double depth;
    /**
     * And both radii exceed this, in input units; 0 by default.
     */
    double radius;
} medax_hole_options;

/**
 * Builds an approximate offset surface: outside the solid for a positive distance, inside for a negative one.
 *
 * The radius of every inner ball grows by the distance, that of every outer ball shrinks by it; balls whose radius falls to 0
 * vanish, and do not come back. The result is a power crust, closed, and empty where no inner ball is left. Its surface has
 * no samples among its vertices.
 *
 * \param crust The power crust.
 * \param distance The signed distance, in input units.
 * \param job NULL for a default job.
 * \param out_crust Receives the power crust of the changed balls, which the caller frees with #medax_power_crust_free.
 * \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` for a distance that is not finite; `TOO_FEW_POINTS` or `DEGENERATE` where too few balls
 *         are left; `NULL_ARGUMENT`, `LIMIT_EXCEEDED`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * One regular triangulation. Since 0.1.
 */
MEDAX_API
medax_status medax_power_crust_offset(const medax_power_crust *crust,
                                      double distance,
                                      const medax_job *job,
                                      const medax_power_crust **out_crust);

/**
 * Builds the scale axis of one side: the axis of the union of its balls, grown by a factor, with the balls shrunk back (Giesen, Miklos,
 * Pauly, Wormser 2009). What is small beside what is near is gone.
 *
 * It is the dual complex of the union, which has its homotopy type. Vertices have the attributes `radius`, `pole`, `label` and `object_angle`, as
 * those of #medax_power_crust_shape.
 *
 * \param crust The power crust.
 * \param side A #medax_label.
 * \param factor The factor, at least 1; at 1 itself rounding makes voids without a size at the samples, which lie on the union's boundary.
 * \param job NULL for a default job.
 * \param out_axis Receives the axis, which the caller frees with #medax_complex_free.
 * \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` for a factor below 1 or too large, or a number that is no label; `TOO_FEW_POINTS` or `DEGENERATE`
 *         where there are too few balls of that side; `NULL_ARGUMENT`, `LIMIT_EXCEEDED`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * One regular triangulation. Since 0.1.
 */
MEDAX_API
medax_status medax_power_crust_scale_axis(const medax_power_crust *crust,
                                          uint32_t side,
                                          double factor,
                                          const medax_job *job,
                                          const medax_complex **out_axis);

/**
 * Sets simplify options to their defaults.
 *
 * \param options The caller's struct, of `struct_size` bytes.
 * \param struct_size `sizeof *options`.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_status medax_simplify_options_init(medax_simplify_options *options,
                                         size_t struct_size);

/**
 * Simplifies a power crust: unstable poles go, then redundant ones, inner and outer alike, and the power diagram of what is left is
 * calculated anew.
 *
 * A pole is unstable if no two samples on its ball are farther apart than epsilon; a ball that touches the far box is stable. Of
 * the others, a pole is redundant if its ball lies in that of another one of its side, which is larger, grown by delta. Balls are looked
 * at from the largest to the smallest.
 *
 * \param crust The power crust.
 * \param options NULL for the defaults.
 * \param job NULL for a default job.
 * \param out_simplified Receives the result, which the caller frees with #medax_simplified_free.
 * \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` for an epsilon or a delta that is not finite; `TOO_FEW_POINTS` or `DEGENERATE` where
 *         too few poles are left; `NULL_ARGUMENT`, `LIMIT_EXCEEDED`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * One regular triangulation, of what is left. Since 0.1.
 */
MEDAX_API
medax_status medax_power_crust_simplify(const medax_power_crust *crust,
                                        const medax_simplify_options *options,
                                        const medax_job *job,
                                        const medax_simplified **out_simplified);

/**
 * The power crust of the poles that are left.
 *
 * \param simplified The result.
 * \param out_crust Receives the power crust, which the caller frees with #medax_power_crust_free.
 * \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_status medax_simplified_crust(const medax_simplified *simplified,
                                    const medax_power_crust **out_crust);

/**
 * The epsilon that was used.
 *
 * \param simplified The result, or NULL.
 * \return In input units; 0 for NULL.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API double medax_simplified_epsilon(const medax_simplified *simplified);

/**
 * The delta that was used.
 *
 * \param simplified The result, or NULL.
 * \return In input units; 0 for NULL.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API double medax_simplified_delta(const medax_simplified *simplified);

/**
 * The poles that were unstable.
 *
 * \param simplified The result, or NULL.
 * \return Poles, ascending. Borrowed from `simplified`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_u32 medax_simplified_unstable(const medax_simplified *simplified);

/**
 * The poles that were redundant, and which pole keeps the place of each.
 *
 * \param simplified The result, or NULL.
 * \return Rows of two poles, ascending: the one that went, and the one that is left, whose ball, grown by delta, holds the other's.
 *         Borrowed from `simplified`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_view_u32 medax_simplified_redundant(const medax_simplified *simplified);

/**
 * One more reference to the result of a simplification.
 *
 * \param simplified The result, or NULL.
 * \return The same pointer; the caller frees it once more.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API const medax_simplified *medax_simplified_clone(const medax_simplified *simplified);

/**
 * Gives one reference to the result of a simplification back; the last one frees it.
 *
 * \param simplified The result; NULL does nothing.
 *
 * Since 0.1.
 */
MEDAX_API void medax_simplified_free(const medax_simplified *simplified);

/**
 * Sets hole options to their defaults.
 *
 * \param options The caller's struct, of `struct_size` bytes.
 * \param struct_size `sizeof *options`.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_status medax_hole_options_init(medax_hole_options *options, size_t struct_size);

/**
 * The surface of a power crust without the faces that fill holes: those between an inner and an outer ball that intersect
 * deeply and are large.
 *
 * \param crust The power crust.
 * \param options NULL for the defaults.
 * \param job NULL for a default job.
 * \param out_surface Receives the faces that are left, which the caller frees with #medax_complex_free; #medax_complex_topology counts
 *        its boundary loops.
 * \param out_left_out Receives the faces that were left out, with the attribute `face`, their numbers in the whole surface;
 *        the caller frees it with #medax_complex_free. NULL if it is not wanted.
 * \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` for options out of range; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(n). Since 0.1.
 */
MEDAX_API
medax_status medax_power_crust_open(const medax_power_crust *crust,
                                    const medax_hole_options *options,
                                    const medax_job *job,
                                    const medax_complex **out_surface,
                                    const medax_complex **out_left_out);

/* ---- 15. Sizes --------------------------------------------------------------------------------
 *
 * Two lengths that a power crust knows of any point. The local feature size is the distance to the medial axis, estimated by that to
 * the nearest pole: a mesh with edges in proportion to it follows the surface (Amenta, Bern 1999, Surface reconstruction by Voronoi
 * filtering). The thickness of the solid at a sample is the diameter of the sample's inner polar ball, which touches the surface there and
 * on the other side; any other point has the thickness at the nearest sample.
 */

/**
 * The local feature size and the thickness at any points.
 *
 * The feature size is the distance to the nearest pole whose ball the power crust has, inner or outer. The thickness is the diameter
 * of the inner ball of the nearest sample that has one, of several as near that of the least number; of two inner balls the larger counts. A
 * sample may have none, because its poles were left out, are both outer, or their balls vanished. Balls have the radii
 * that they have in this power crust: those of an offset the changed ones.
 *
 * \param crust The power crust.
 * \param query_xyz `query_count` x 3 coordinates; NULL only if `query_count` is 0.
 * \param query_count The number of points.
 * \param job NULL for a default job.
 * \param out_feature_size Receives `query_count` lengths in input units; the caller's buffer, NULL only if `query_count` is 0.
 * \param out_thickness Receives `query_count` lengths in input units, 0 if no sample has an inner ball; the caller's buffer, NULL only if
 *        `query_count` is 0.
 * \return `MEDAX_STATUS_OK`; `NON_FINITE`, or `COORDINATE_RANGE` beyond 2^200, with the row of a query;
 *         `NULL_ARGUMENT`, `INVALID_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(log n) a query, and O(n log n) once, in the first call. Since 0.1.
 */
MEDAX_API
medax_status medax_power_crust_sizes_at(const medax_power_crust *crust,
                                        const double *query_xyz,
                                        size_t query_count,
                                        const medax_job *job,
                                        double *out_feature_size,
                                        double *out_thickness);

/**
 * The distinct samples as vertices, in spatial order, with the attributes `feature_size`, `thickness` and `row`, the first input row of
 * each.
 *
 * \param crust The power crust.
 * \param job NULL for a default job.
 * \param out_complex Receives the complex, which the caller frees with #medax_complex_free.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(n log n). Since 0.1.
 */
MEDAX_API
medax_status medax_power_crust_samples_complex(const medax_power_crust *crust,
                                               const medax_job *job,
                                               const medax_complex **out_complex);

/**
 * A complex with the sizes at its vertices, as the attributes `feature_size` and `thickness`, which take the place of any that have
 * these names: the surface of the power crust, a part of it, or another mesh of the same thing.
 *
 * \param crust The power crust.
 * \param complex The complex.
 * \param job NULL for a default job.
 * \param out_complex Receives the complex with the attributes, which the caller frees with #medax_complex_free.
 * \return `MEDAX_STATUS_OK`; `COORDINATE_RANGE` with a vertex beyond 2^200; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(log n) a vertex, and O(n log n) once, in the first call. Since 0.1.
 */
MEDAX_API
medax_status medax_power_crust_with_sizes(const medax_power_crust *crust,
                                          const medax_complex *complex,
                                          const medax_job *job,
                                          const medax_complex **out_complex);

/* ---- 16. Cocone -------------------------------------------------------------------------------
 *
 * Surfaces through the samples, made of Delaunay triangles. Cocone chooses the triangles whose dual Voronoi edges pass through the
 * tangent planes of their corners; its surface is open where the sample is too sparse. Tight Cocone marks the cells on both
 * sides of it and peels off what is outside: its surface is the boundary of the cells that are left, closed for every sample.
 * (Amenta, Choi, Dey, Leekha 2002, A simple algorithm for homeomorphic surface reconstruction; Dey, Goswami 2003, Tight Cocone.)
 */

/**
 * The settings of Cocone and Tight Cocone.
 */
typedef struct {
    /**
     * The size of this struct in the caller's program.
     */
    size_t struct_size;
    /**
     * How far from the tangent plane at a sample a Voronoi edge of the surface may pass, in radians between 0 and pi/2; pi/8 by default.
     */
    double angle;
    /**
     * How many times as far as the corners of its tangent polygon the poles of a sample are at least that is dense enough;
     * not negative, 1.2 by default.
     */
    double ratio;
    /**
     * The largest angle between the pole vectors of neighbours that are dense enough, in radians between 0 and pi/2; pi/6 by
     * default.
     */
    double normal_angle;
} medax_cocone_options;

/**
 * Sets cocone options to their defaults.
 *
 * \param options The caller's struct, of `struct_size` bytes.
 * \param struct_size `sizeof *options`.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_status medax_cocone_options_init(medax_cocone_options *options, size_t struct_size);

/**
 * Builds both surfaces from the Voronoi diagram of a sample.
 *
 * \param dual The dual of a Delaunay triangulation, which the result keeps alive.
 * \param options NULL for the defaults.
 * \param job NULL for a default job.
 * \param out_cocone Receives the surfaces, which the caller frees with #medax_cocone_free.
 * \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` for a power diagram and for options out of range; `MISMATCH` for the dual of points with
 *         the far box; `DEGENERATE` where no cell is inside; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(m) for m cells, besides sorting. Since 0.1.
 */
MEDAX_API
medax_status medax_cocone_build(const medax_dual *dual,
                                const medax_cocone_options *options,
                                const medax_job *job,
                                const medax_cocone **out_cocone);

/**
 * The watertight surface of Tight Cocone: the triangles between inner and outer cells, which point out of the solid. Every edge is in an even
 * number of them. Vertices have the attribute `sample`, the vertex of the points that they are.
 *
 * \param cocone The surfaces.
 * \param out_surface Receives the surface, which the caller frees with #medax_complex_free.
 * \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_status medax_cocone_surface(const medax_cocone *cocone,
                                  const medax_complex **out_surface);

/**
 * The surface of Cocone alone, which has a boundary where the sample is too sparse. Vertices have the attribute `sample`.
 *
 * \param cocone The surfaces.
 * \param out_surface Receives the surface, which the caller frees with #medax_complex_free.
 * \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_status medax_cocone_open_surface(const medax_cocone *cocone,
                                       const medax_complex **out_surface);

/**
 * Whether each cell of the triangulation is inside the watertight surface.
 *
 * \param cocone The surfaces, or NULL.
 * \return m x 1 flags, 0 or 1, in the order of #medax_triangulation_cells. Borrowed from `cocone`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_u8 medax_cocone_is_inner(const medax_cocone *cocone);

/**
 * Whether each sample is too sparse beside its neighbours for Cocone to trust it.
 *
 * \param cocone The surfaces, or NULL.
 * \return n x 1 flags, 0 or 1, one for each vertex of the points. Borrowed from `cocone`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_u8 medax_cocone_is_undersampled(const medax_cocone *cocone);

/**
 * Whether the triangles round each sample are a disk that divides inside from outside. Triangles of undersampled points count here,
 * which are not in the open surface.
 *
 * \param cocone The surfaces, or NULL.
 * \return n x 1 flags, 0 or 1, one for each vertex of the points. Borrowed from `cocone`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_view_u8 medax_cocone_is_well_sampled(const medax_cocone *cocone);

/**
 * The number of cells that well sampled vertices mark as inner or outer. What is left of the others, when those outside are peeled off, is
 * inner.
 *
 * \param cocone The surfaces; NULL has none.
 * \return The number of cells.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
size_t medax_cocone_marked_count(const medax_cocone *cocone);

/**
 * The number of samples that the watertight surface has as vertices.
 *
 * \param cocone The surfaces; NULL has none.
 * \return The number of samples used; by n the share of them.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API size_t medax_cocone_used_count(const medax_cocone *cocone);

/**
 * Checks the surfaces by other means than those that made them.
 *
 * \param cocone The surfaces.
 * \param job NULL for a default job.
 * \param out_report Filled, its `struct_size` being set.
 * \return `MEDAX_STATUS_OK` whatever was found; `NULL_ARGUMENT`, `INVALID_ARGUMENT` for a report
 *         of no version, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(m log m). Since 0.1.
 */
MEDAX_API
medax_status medax_cocone_validate(const medax_cocone *cocone,
                                   const medax_job *job,
                                   medax_validation *out_report);

/**
 * One more reference to surfaces.
 *
 * \param cocone The surfaces, or NULL.
 * \return The same pointer; the caller frees it once more.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API const medax_cocone *medax_cocone_clone(const medax_cocone *cocone);

/**
 * Gives one reference to surfaces back; the last one frees them.
 *
 * \param cocone The surfaces; NULL does nothing.
 *
 * Since 0.1.
 */
MEDAX_API void medax_cocone_free(const medax_cocone *cocone);

/* ---- 17. Labels of cells ----------------------------------------------------------------------
 *
 * For each cell of a Delaunay triangulation of samples whether it lies in the solid: where a mesh or a power crust tells, whether its Voronoi
 * vertex does, and not its barycentre, since flat cells in the surface are nowhere. Inner axes take these labels, wherever they come from.
 */

/**
 * Labels that the caller has found.
 *
 * \param triangulation The triangulation, which the labels keep alive.
 * \param is_inner `count` flags, in the order of #medax_triangulation_cells: 1 for a cell in the solid, 0 for one outside. Copied.
 * \param count The number of flags, which is that of the cells.
 * \param out_labels Receives the labels, which the caller frees with #medax_labels_free.
 * \return `MEDAX_STATUS_OK`; `MISMATCH` unless there is one flag per cell; `INVALID_ARGUMENT` with the cell of a flag that is
 *         neither; `NULL_ARGUMENT`.
 *
 * O(m) for m cells. Since 0.1.
 */
MEDAX_API
medax_status medax_labels_create(const medax_triangulation *triangulation,
                                 const uint8_t *is_inner,
                                 size_t count,
                                 const medax_labels **out_labels);

/**
 * Labels from Tight Cocone: the cells that its watertight surface encloses are inner.
 *
 * \param cocone The surfaces, whose triangulation the labels keep alive.
 * \param job NULL for a default job.
 * \param out_labels Receives the labels, which the caller frees with #medax_labels_free.
 * \return `MEDAX_STATUS_OK`; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(m) for m cells. Since 0.1.
 */
MEDAX_API
medax_status medax_labels_of_cocone(const medax_cocone *cocone,
                                    const medax_job *job,
                                    const medax_labels **out_labels);

/**
 * Labels from a power crust of the same samples: a cell is inner where its Voronoi vertex lies in the power cell of an inner pole, in the
 * solid that the power crust bounds.
 *
 * \param dual The Voronoi diagram of the samples, whose triangulation the labels keep alive.
 * \param crust The power crust.
 * \param job NULL for a default job.
 * \param out_labels Receives the labels, which the caller frees with #medax_labels_free.
 * \return `MEDAX_STATUS_OK`; `MISMATCH` for a power crust of other samples; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`,
 *         `OUT_OF_MEMORY`.
 *
 * About O(m) for m cells. Since 0.1.
 */
MEDAX_API
medax_status medax_labels_of_crust(const medax_dual *dual,
                                   const medax_power_crust *crust,
                                   const medax_job *job,
                                   const medax_labels **out_labels);

/**
 * Labels from a mesh of the solid: a cell is inner where the faces wind round its Voronoi vertex more than half a time, by
 * #medax_complex_winding_numbers.
 *
 * Faces must point out of the solid, and those of voids into them; small holes are bridged. The samples need not be the mesh's
 * vertices.
 *
 * \param dual The Voronoi diagram of the samples, whose triangulation the labels keep alive.
 * \param mesh The mesh, as a complex with faces.
 * \param job NULL for a default job.
 * \param out_labels Receives the labels, which the caller frees with #medax_labels_free.
 * \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` for a mesh without faces; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`,
 *         `OUT_OF_MEMORY`.
 *
 * O((n + m) log n) for n triangles and m cells. Since 0.1.
 */
MEDAX_API
medax_status medax_labels_of_mesh(const medax_dual *dual,
                                  const medax_complex *mesh,
                                  const medax_job *job,
                                  const medax_labels **out_labels);

/**
 * The triangulation whose cells have the labels.
 *
 * \param labels The labels.
 * \param out_triangulation Receives the triangulation, which the caller frees with
 *        #medax_triangulation_free.
 * \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_status medax_labels_triangulation(const medax_labels *labels,
                                        const medax_triangulation **out_triangulation);

/**
 * Whether each cell lies in the solid.
 *
 * \param labels The labels, or NULL.
 * \return m x 1 flags, 0 or 1, in the order of #medax_triangulation_cells. Borrowed from `labels`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_u8 medax_labels_is_inner(const medax_labels *labels);

/**
 * The number of cells in the solid.
 *
 * \param labels The labels; NULL has none.
 * \return The number of inner cells.
 *
 * O(m). Since 0.1.
 */
MEDAX_API size_t medax_labels_inner_count(const medax_labels *labels);

/**
 * In how many cells two labellings of one triangulation differ.
 *
 * \param a The one.
 * \param b The other one, which may be the same; its triangulation must be the same as that of `a`, or equal to it.
 * \param out_count Receives the number of cells.
 * \return `MEDAX_STATUS_OK`; `MISMATCH` for labels of another triangulation; `NULL_ARGUMENT`.
 *
 * O(m). Since 0.1.
 */
MEDAX_API
medax_status medax_labels_disagreement(const medax_labels *a,
                                       const medax_labels *b,
                                       size_t *out_count);

/**
 * One more reference to labels.
 *
 * \param labels The labels, or NULL.
 * \return The same pointer; the caller frees it once more.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API const medax_labels *medax_labels_clone(const medax_labels *labels);

/**
 * Gives one reference to labels back; the last one frees them.
 *
 * \param labels The labels; NULL does nothing.
 *
 * Since 0.1.
 */
MEDAX_API void medax_labels_free(const medax_labels *labels);

/* ---- 18. Medial axis --------------------------------------------------------------------------
 *
 * The medial axis straight from the Voronoi diagram of a sample: a Voronoi facet belongs to it if its dual Delaunay edge makes a
 * large angle with the surface at one of its ends, or is long beside the triangles of the surface there. These triangles are a
 * sample's umbrella: those at the sample whose dual Voronoi edges the tangent plane cuts. A #medax_medial has for every facet what
 * decides; a filter is a threshold on that, and to move it builds nothing again.
 * (Dey, Zhao 2004, Approximating the medial axis from the Voronoi diagram with a convergence guarantee.)
 */

/**
 * Which of the two conditions of the paper decide whether a facet belongs to the axis.
 */
enum medax_medial_rule
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
    /**
     * Either is enough: the paper's algorithm.
     */
    MEDAX_MEDIAL_RULE_ANGLE_OR_RATIO = 0,
    /**
     * The angle condition alone.
     */
    MEDAX_MEDIAL_RULE_ANGLE = 1,
    /**
     * The ratio condition alone.
     */
    MEDAX_MEDIAL_RULE_RATIO = 2,
    /**
     * Neither: all facets, those of the surface as well, for the other thresholds to choose from.
     */
    MEDAX_MEDIAL_RULE_EVERY = 3,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum medax_medial_rule medax_medial_rule;
#else
typedef uint32_t medax_medial_rule;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

/**
 * The side of the surface on which an axis lies. The first two are those of #medax_label.
 */
enum medax_side
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
    /**
     * Facets of which every cell round the dual edge is outer.
     */
    MEDAX_SIDE_OUTER = 0,
    /**
     * Facets of which every cell round the dual edge is inner.
     */
    MEDAX_SIDE_INNER = 1,
    /**
     * All facets, those that cross the surface as well. The only one that needs no labels.
     */
    MEDAX_SIDE_BOTH = 2,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum medax_side medax_side;
#else
typedef uint32_t medax_side;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

/**
 * What is calculated.
 */
typedef struct {
    /**
     * The size of this struct in the caller's program.
     */
    size_t struct_size;
    /**
     * `normal_count` x 3 coordinates: the normals of the surface at the samples, in the order of the points' vertices, in place of
     * the vectors to their poles. Their lengths do not count, nor which way they point; a vertex whose normal is 0 has no
     * umbrella. Copied. NULL, the default: the poles.
     */
    const double *normals;
    /**
     * The number of normals, which is that of the vertices; 0 without.
     */
    size_t normal_count;
    /**
     * 1 to calculate the pairwise scales too, which filters by scale need, and which cost far more than all the rest: 12 seconds for 44,000 samples with two threads; 0, the
     * default, not to.
     */
    uint32_t scales;
    /**
     * Must be 0.
     */
    uint32_t reserved;
} medax_medial_options;

/**
 * Thresholds on the facets of a #medax_medial: a facet must pass all of them.
 */
typedef struct {
    /**
     * The size of this struct in the caller's program.
     */
    size_t struct_size;
    /**
     * The threshold of the angle condition, in radians in [0, pi/2); pi/8 by default, the paper's.
     */
    double theta;
    /**
     * The threshold of the ratio condition, not negative; 8 by default, the paper's.
     */
    double rho;
    /**
     * The least object angle, in radians in [0, pi]: some point of the facet must have as much; 0 by default.
     */
    double object_angle;
    /**
     * The least lambda, in input units: half the length of the dual edge, the radius of the smallest ball round the nearest
     * samples of a point within the facet (Chazal, Lieutier 2005, The lambda-medial axis); 0 by default.
     */
    double lambda;
    /**
     * The least pairwise scale: the ball of some corner of the facet must have more; 0, the default, asks for nothing, and
     * anything else for #medax_medial_scales.
     */
    double scale;
    /**
     * The least corner of a box to which the axis is clipped, if `has_clip` is 1, so that it keeps its unbounded facets. No
     * coordinate is beyond 2^200.
     */
    double clip_min[3];
    /**
     * The largest corner of that box.
     */
    double clip_max[3];
    /**
     * 1 to clip the axis; 0, the default, not to: unbounded facets are then left out.
     */
    uint32_t has_clip;
    /**
     * A #medax_medial_rule: which conditions decide; `MEDAX_MEDIAL_RULE_ANGLE_OR_RATIO` by default.
     */
    uint32_t rule;
    /**
     * A #medax_side; `MEDAX_SIDE_INNER` by default.
     */
    uint32_t side;
    /**
     * Must be 0.
     */
    uint32_t reserved;
} medax_medial_filter;

/**
 * Sets medial options to their defaults.
 *
 * \param options The caller's struct, of `struct_size` bytes.
 * \param struct_size `sizeof *options`.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_status medax_medial_options_init(medax_medial_options *options, size_t struct_size);

/**
 * Sets a filter to its defaults: those of the paper, for the inner axis.
 *
 * \param filter The caller's struct, of `struct_size` bytes.
 * \param struct_size `sizeof *filter`.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_status medax_medial_filter_init(medax_medial_filter *filter, size_t struct_size);

/**
 * Calculates umbrellas, conditions and attributes of all Voronoi facets of a sample.
 *
 * \param dual The dual of the Delaunay triangulation, with its facets (#medax_dual_options), which the result keeps alive.
 * \param labels Labels of the triangulation's cells, with which the inner and the outer axis can be told apart; NULL for none. The
 *        result keeps them alive.
 * \param options NULL for the defaults.
 * \param job NULL for a default job.
 * \param out_medial Receives the result, which the caller frees with #medax_medial_free.
 * \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` for the dual of a regular triangulation, a dual without facets and, with the
 *         vertex, a normal that is not finite; `MISMATCH` for labels of another triangulation, and unless there is one normal per
 *         vertex; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(size of the dual), and for each Delaunay edge a look at every umbrella triangle of its ends: linear on surfaces that are
 * sampled evenly, quadratic at a sample of which most others are neighbours. Scales cost a search for each cell. Since 0.1.
 */
MEDAX_API
medax_status medax_medial_build(const medax_dual *dual,
                                const medax_labels *labels,
                                const medax_medial_options *options,
                                const medax_job *job,
                                const medax_medial **out_medial);

/**
 * The axis: the Voronoi facets that a filter lets pass, with their edges and vertices, as convex polygons.
 *
 * Vertices are Voronoi vertices, one for all cells that share a sphere, and carry `cell`, the least of these, or `MEDAX_NONE` where
 * a box has cut, `radius`, that of the ball round them through their samples, and `scale`, NaN where a box has cut, if scales were
 * calculated. Faces are in the order of #medax_dual_facets
 * and turn counterclockwise as seen from the second sample; they carry `facet`, `samples` (the two ends of the dual edge),
 * `condition` (1 the angle condition, 2 the ratio condition, 3 both, 0 neither), `object_angle` (the least and the largest on the
 * face, in radians), `lambda` (half the length of the dual edge) and `side` (a #medax_side; `MEDAX_SIDE_BOTH` for one that crosses
 * the surface, or where there are no labels). Facets that have no area, since their cells share spheres, are no faces. Of a facet
 * that only touches the box nothing is left.
 *
 * \param medial The facets with what decides.
 * \param filter NULL for the defaults.
 * \param job NULL for a default job.
 * \param out_complex Receives the complex, which the caller frees with #medax_complex_free.
 * \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` for thresholds out of range, an inner or an outer side without labels, a scale
 *         where scales were not calculated; `COORDINATE_RANGE` for a box beyond 2^200; `NULL_ARGUMENT`, `LIMIT_EXCEEDED`,
 *         `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(f) for f facets, and O(size) of what passes. Since 0.1.
 */
MEDAX_API
medax_status medax_medial_axis(const medax_medial *medial,
                               const medax_medial_filter *filter,
                               const medax_job *job,
                               const medax_complex **out_complex);

/**
 * The facets that a filter lets pass, unbounded ones and those without area as well.
 *
 * \param medial The facets with what decides.
 * \param filter NULL for the defaults.
 * \param job NULL for a default job.
 * \param capacity The number of facets for which `out_facets` has room; that of #medax_dual_facets is always enough.
 * \param out_facets Receives the first `capacity` of the facets, which ascend; the caller's buffer, NULL only if `capacity` is 0.
 * \param out_count Receives the number of facets that pass, which may be more than `capacity`.
 * \return As #medax_medial_axis.
 *
 * O(f) for f facets. Since 0.1.
 */
MEDAX_API
medax_status medax_medial_selected(const medax_medial *medial,
                                   const medax_medial_filter *filter,
                                   const medax_job *job,
                                   size_t capacity,
                                   uint32_t *out_facets,
                                   size_t *out_count);

/**
 * The Voronoi diagram.
 *
 * \param medial The facets with what decides.
 * \param out_dual Receives the dual, which the caller frees with #medax_dual_free.
 * \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_status medax_medial_dual(const medax_medial *medial, const medax_dual **out_dual);

/**
 * The labels that tell the inner from the outer axis.
 *
 * \param medial The facets with what decides.
 * \param out_labels Receives the labels, which the caller frees with #medax_labels_free; NULL if none were given.
 * \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_status medax_medial_labels(const medax_medial *medial,
                                 const medax_labels **out_labels);

/**
 * What the angle condition asks of each facet, by the two ends of its dual edge: the sine of the least angle between the edge and
 * the planes of the end's umbrella triangles. The condition holds where one of the two exceeds the sine of theta. Right to 10^-12,
 * however thin the triangles are.
 *
 * \param medial The facets with what decides, or NULL.
 * \return f x 2, in the order of #medax_dual_facet_edges, in [0, 1]; minus infinity where the umbrella has the edge, or has no
 *         triangle. Borrowed from `medial`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_view_f64 medax_medial_sines(const medax_medial *medial);

/**
 * What the ratio condition asks of each facet, by the two ends of its dual edge: the length of the edge by the largest
 * circumradius of the end's umbrella triangles. The condition holds where one of the two exceeds rho. Right to 10^-12 of itself,
 * however thin the triangles are.
 *
 * \param medial The facets with what decides, or NULL.
 * \return f x 2, in the order of #medax_dual_facet_edges, not negative; minus infinity where the umbrella has the edge, or has no
 *         triangle. Borrowed from `medial`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_view_f64 medax_medial_ratios(const medax_medial *medial);

/**
 * The least and the largest distance of each facet's points from the middle of its dual edge. The object angle at a point is twice
 * the arc tangent of half the edge's length by that distance.
 *
 * \param medial The facets with what decides, or NULL.
 * \return f x 2, in the order of #medax_dual_facet_edges, in input units; the largest is infinite where the facet is unbounded.
 *         Borrowed from `medial`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_view_f64 medax_medial_reaches(const medax_medial *medial);

/**
 * For each cell the least with the same circumscribed sphere: the same Voronoi vertex.
 *
 * \param medial The facets with what decides, or NULL.
 * \return m x 1 cells. Borrowed from `medial`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_u32 medax_medial_least_cell(const medax_medial *medial);

/**
 * The pairwise scale of each cell's ball: the least factor at which another ball of the same label, its radius grown by it, covers
 * this one, grown as well; |c - c'| / (r' - r), the least over all larger balls.
 *
 * It stands for the scale axis transform (Giesen, Miklos, Pauly, Wormser 2009), where grown balls are covered by many together.
 *
 * \param medial The facets with what decides, or NULL.
 * \return m x 1; infinite for the largest balls. No row unless the options asked for scales. Borrowed from `medial`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_view_f64 medax_medial_scales(const medax_medial *medial);

/**
 * Where the triangles of each sample's umbrella begin in #medax_medial_umbrella_rims.
 *
 * \param medial The facets with what decides, or NULL.
 * \return n + 1 x 1: those of vertex v are the rows from entry v to before entry v + 1. Borrowed from `medial`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_view_u32 medax_medial_umbrella_offsets(const medax_medial *medial);

/**
 * The triangles of all umbrellas, one sample's after the other's.
 *
 * \param medial The facets with what decides, or NULL.
 * \return t x 2: the two other vertices of each triangle, which turns counterclockwise seen from the pole, or from where the given
 *         normal points. Where the umbrella is a disk they go round the sample, the least one first; otherwise they ascend.
 *         Borrowed from `medial`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_view_u32 medax_medial_umbrella_rims(const medax_medial *medial);

/**
 * Whether each sample's umbrella is a disk: its triangles make one ring round the sample. It may not be where the sample is on the hull.
 *
 * \param medial The facets with what decides, or NULL.
 * \return n x 1 flags, 0 or 1. Borrowed from `medial`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_view_u8 medax_medial_umbrella_is_disk(const medax_medial *medial);

/**
 * The number of samples whose umbrella is no disk.
 *
 * \param medial The facets with what decides; NULL has none.
 * \return The number of samples.
 *
 * O(n). Since 0.1.
 */
MEDAX_API size_t medax_medial_torn_count(const medax_medial *medial);

/**
 * Checks umbrellas and conditions by other means than those that made them: round each Voronoi facet, whose polygon a tangent
 * plane must cut twice or not at all, the triangles of the umbrellas are found again.
 *
 * \param medial The facets with what decides.
 * \param job NULL for a default job.
 * \param out_report Filled, its `struct_size` being set.
 * \return `MEDAX_STATUS_OK` whatever was found; `NULL_ARGUMENT`, `INVALID_ARGUMENT` for a report
 *         of no version, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * As #medax_medial_build. Since 0.1.
 */
MEDAX_API
medax_status medax_medial_validate(const medax_medial *medial,
                                   const medax_job *job,
                                   medax_validation *out_report);

/**
 * One more reference to facets with what decides.
 *
 * \param medial The facets, or NULL.
 * \return The same pointer; the caller frees it once more.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API const medax_medial *medax_medial_clone(const medax_medial *medial);

/**
 * Gives one reference to facets with what decides back; the last one frees them.
 *
 * \param medial The facets; NULL does nothing.
 *
 * Since 0.1.
 */
MEDAX_API void medax_medial_free(const medax_medial *medial);

/* ---- 19. Flow ---------------------------------------------------------------------------------
 *
 * The flow of the distance to a sample. From each point it runs away from the driver, the point nearest to it of the hull of its
 * nearest samples: in the direction in which the distance grows most. It stands still at the critical points, where a Delaunay
 * simplex holds its own centre and no other sample lies in its sphere. Some belong to the surface, and lie near it between its samples;
 * all others lie near the medial axis. A #medax_flow has the drivers of the faces of the Voronoi diagram and the critical points; it
 * answers where points flow, and what flows from some faces.
 * (Giesen, Ramos, Sadri 2010, Medial axis approximation and unstable flow complex.)
 */

/**
 * Where a critical point belongs.
 */
enum medax_critical_class
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
    /**
     * To the surface: near it, between its samples.
     */
    MEDAX_CRITICAL_CLASS_SURFACE = 0,
    /**
     * To the inner medial axis.
     */
    MEDAX_CRITICAL_CLASS_INNER = 1,
    /**
     * To the outer medial axis.
     */
    MEDAX_CRITICAL_CLASS_OUTER = 2,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum medax_critical_class medax_critical_class;
#else
typedef uint32_t medax_critical_class;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

/**
 * What is calculated.
 */
typedef struct {
    /**
     * The size of this struct in the caller's program.
     */
    size_t struct_size;
    /**
     * The slope above which a critical point belongs to the medial axis and not to the surface (#medax_flow_critical_slopes), between
     * 0 and 1; 0.5 by default.
     */
    double least_slope;
} medax_flow_options;

/**
 * A Delaunay simplex, or its dual, a face of the Voronoi diagram.
 */
typedef struct {
    /**
     * 0 for a sample, whose dual is a Voronoi cell; 1 for an edge, a Voronoi facet; 2 for a triangle, a Voronoi edge; 3 for a cell, a
     * Voronoi vertex.
     */
    uint32_t dimension;
    /**
     * Which one: a vertex of the points, a row of #medax_dual_facets, of #medax_flow_triangles, of #medax_triangulation_cells.
     */
    uint32_t number;
} medax_simplex;

/**
 * The flow at a point.
 */
typedef struct {
    /**
     * The simplex at whose centre the driver lies. The point lies in its Voronoi face, or on the rim of that, and flows through it.
     */
    medax_simplex simplex;
    /**
     * The driver: the point nearest to the query of the hull of its nearest samples.
     */
    double driver[3];
    /**
     * From the driver to the point, by the distance of the point from the samples: the flow. Its length is the speed at which the
     * distance grows, in [0, 1]; 0 at critical points.
     */
    double vector[3];
    /**
     * The distance of the point from the samples, in input units.
     */
    double distance;
    /**
     * The driving angle: between the directions from the point to the driver and to a nearest sample, in [0, pi/2] radians; pi/2 at
     * critical points but samples, 0 where one sample alone is nearest.
     */
    double angle;
} medax_flow_point;

/**
 * Sets flow options to their defaults.
 *
 * \param options The caller's struct, of `struct_size` bytes.
 * \param struct_size `sizeof *options`.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_status medax_flow_options_init(medax_flow_options *options, size_t struct_size);

/**
 * Calculates drivers and critical points of a sample from its Voronoi diagram.
 *
 * \param dual The dual of the Delaunay triangulation, with its facets (#medax_dual_options), which the result keeps alive.
 * \param labels Labels of the triangulation's cells, which tell the inner from the outer medial axis. The result keeps them alive.
 * \param options NULL for the defaults.
 * \param job NULL for a default job.
 * \param out_flow Receives the flow, which the caller frees with #medax_flow_free.
 * \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` for the dual of a regular triangulation, a dual without facets, and an option out
 *         of range; `MISMATCH` for labels of another triangulation; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(size of the dual). Since 0.1.
 */
MEDAX_API
medax_status medax_flow_build(const medax_dual *dual,
                              const medax_labels *labels,
                              const medax_flow_options *options,
                              const medax_job *job,
                              const medax_flow **out_flow);

/**
 * The Voronoi diagram.
 *
 * \param flow The flow.
 * \param out_dual Receives the dual, which the caller frees with #medax_dual_free.
 * \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_status medax_flow_dual(const medax_flow *flow, const medax_dual **out_dual);

/**
 * The labels that tell the inner from the outer medial axis.
 *
 * \param flow The flow.
 * \param out_labels Receives the labels, which the caller frees with #medax_labels_free.
 * \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_status medax_flow_labels(const medax_flow *flow, const medax_labels **out_labels);

/**
 * The number of critical points, samples included.
 *
 * \param flow The flow; NULL has none.
 * \return The number of rows of every array of critical points.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API size_t medax_flow_critical_count(const medax_flow *flow);

/**
 * The simplices whose centres the critical points are: samples, edges, triangles, cells. The dimension of the simplex is the index of
 * the critical point. Of index 0, 1, 2 and 3 there are so many that c0 - c1 + c2 - c3 = 1.
 *
 * \param flow The flow, or NULL.
 * \return c x 2, each row the two numbers of a #medax_simplex; rows ascend. Borrowed from `flow`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_view_u32 medax_flow_critical_simplices(const medax_flow *flow);

/**
 * Where the critical points lie.
 *
 * \param flow The flow, or NULL.
 * \return c x 3 coordinates. Borrowed from `flow`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_f64 medax_flow_critical_points(const medax_flow *flow);

/**
 * The distances of the critical points from the samples.
 *
 * \param flow The flow, or NULL.
 * \return c x 1, in input units; 0 for samples. Borrowed from `flow`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_f64 medax_flow_critical_distances(const medax_flow *flow);

/**
 * The samples nearest to each critical point: the vertices of its simplex.
 *
 * \param flow The flow, or NULL.
 * \return c x 4 vertices, one to four a row, then `MEDAX_NONE`. Borrowed from `flow`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_u32 medax_flow_critical_corners(const medax_flow *flow);

/**
 * What decides whether a critical point belongs to the surface: the mean, over its nearest samples, of the cosine of the angle between
 * the direction from the sample and the vector to the sample's pole, in absolute value.
 *
 * \param flow The flow, or NULL.
 * \return c x 1, in [0, 1]: nearly 0 at the surface, nearly 1 at the medial axis; 0 for samples. Borrowed from `flow`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_view_f64 medax_flow_critical_slopes(const medax_flow *flow);

/**
 * The distance of each critical point by that of the farthest Voronoi vertices of its nearest samples on its side of the surface, the
 * mean over these. It decides nothing.
 *
 * \param flow The flow, or NULL.
 * \return c x 1, in [0, 1]: nearly 0 at the surface; nearly 1 at the inner medial axis, as at the outer where the samples are not on
 *         the hull. Borrowed from `flow`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_view_f64 medax_flow_critical_shares(const medax_flow *flow);

/**
 * Where each critical point belongs.
 *
 * \param flow The flow, or NULL.
 * \return c x 1, each a #medax_critical_class. Borrowed from `flow`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_u32 medax_flow_critical_classes(const medax_flow *flow);

/**
 * The critical point of a simplex.
 *
 * \param flow The flow; NULL has none.
 * \param simplex The simplex.
 * \return Its row in the arrays of critical points; `MEDAX_NONE` if it has none, or is not there.
 *
 * O(log c) for c critical points. Since 0.1.
 */
MEDAX_API uint32_t medax_flow_critical_row(const medax_flow *flow, medax_simplex simplex);

/**
 * How clearly the slopes divide the critical points: the largest slope of those that belong to the surface, and the least of the others.
 *
 * \param flow The flow.
 * \param out_gap Receives the two slopes, the second 1 if there are no others; the wider apart, the clearer.
 * \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
 *
 * O(c) for c critical points. Since 0.1.
 */
MEDAX_API
medax_status medax_flow_gap(const medax_flow *flow,
                            double *out_gap);

/**
 * The critical points as vertices, samples left out, with the attributes `index`, `class` (a #medax_critical_class), `radius` (their distance
 * from the samples), `slope`, `share` and `samples` (the nearest ones, then `MEDAX_NONE`), for writing.
 *
 * \param flow The flow.
 * \param job NULL for a default job.
 * \param out_complex Receives the complex, which the caller frees with #medax_complex_free.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(c) for c critical points. Since 0.1.
 */
MEDAX_API
medax_status medax_flow_critical_complex(const medax_flow *flow,
                                         const medax_job *job,
                                         const medax_complex **out_complex);

/**
 * The triangles of the triangulation, each once.
 *
 * \param flow The flow, or NULL.
 * \return t x 2: the lesser of the triangle's cells, and the slot of the cell's vertex opposite; rows ascend. Borrowed from `flow`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_view_u32 medax_flow_triangles(const medax_flow *flow);

/**
 * The simplex at whose centre the driver of the points inside a Voronoi edge lies: the triangle, or if that is obtuse its longest edge.
 * The driver inside a Voronoi facet is always the middle of its dual edge.
 *
 * \param flow The flow.
 * \param triangle A row of #medax_flow_triangles.
 * \return The simplex; dimension 0 and number `MEDAX_NONE` for a triangle that is not there, and without a flow.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_simplex medax_flow_driver_of_triangle(const medax_flow *flow,
                                            uint32_t triangle);

/**
 * The simplex at whose centre the driver of a Voronoi vertex lies: the cell, one of its triangles, or one of its edges.
 *
 * \param flow The flow.
 * \param cell The cell.
 * \return The simplex; dimension 0 and number `MEDAX_NONE` for a cell that is not there, and without a flow.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_simplex medax_flow_driver_of_cell(const medax_flow *flow,
                                        uint32_t cell);

/**
 * The flow at each of some points.
 *
 * Which samples are nearest is decided exactly. Where several are, as on the faces of the Voronoi diagram, the driver is, of the centres
 * of all simplices of these samples that hold their own, that of the largest smallest sphere. Coordinates of less than 2^-160 count as 0.
 *
 * \param flow The flow.
 * \param query_xyz `query_count` x 3 coordinates; NULL only if `query_count` is 0.
 * \param query_count The number of points.
 * \param job NULL for a default job.
 * \param out_at Receives `query_count` answers; the caller's buffer, NULL only if `query_count` is 0.
 * \return `MEDAX_STATUS_OK`; `NON_FINITE`, or `COORDINATE_RANGE` beyond 2^200, with the row of a query;
 *         `NULL_ARGUMENT`, `INVALID_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(n) once a call, and for each point O(way from the one before to it, in samples). Since 0.1.
 */
MEDAX_API
medax_status medax_flow_at(const medax_flow *flow,
                           const double *query_xyz,
                           size_t query_count,
                           const medax_job *job,
                           medax_flow_point *out_at);

/**
 * The orbits of some points: each a polyline along the flow, from the point to the critical point where it ends, or to infinity.
 *
 * The complex has them as loose edges, one orbit's after the other's. Vertices carry `radius`, their distance from the samples; edges
 * `orbit`, the query, and `end`, as in `out_ends`. The first vertex of each orbit is the query; that of a query that does not flow is
 * its only one. The last one of an orbit that goes to infinity lies on its last ray, one diagonal of the samples' box from the one before.
 * The facet that an orbit comes to first, and where it leaves that, are decided exactly; where orbits cross Voronoi edges is rounded.
 *
 * \param flow The flow.
 * \param query_xyz `query_count` x 3 coordinates; NULL only if `query_count` is 0.
 * \param query_count The number of points.
 * \param job NULL for a default job.
 * \param out_ends Receives for each query the row of the critical point where its orbit ends, `MEDAX_NONE` at infinity; the caller's
 *        buffer of `query_count` entries, or NULL.
 * \param out_orbits Receives the complex, which the caller frees with #medax_complex_free.
 * \return `MEDAX_STATUS_OK`; `NON_FINITE`, or `COORDINATE_RANGE` beyond 2^200, with the row of a query; `LIMIT_EXCEEDED` past
 *         2^32 - 1 vertices; `NULL_ARGUMENT`, `INVALID_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * As #medax_flow_at, and O(size of the Voronoi facets that an orbit crosses). Since 0.1.
 */
MEDAX_API
medax_status medax_flow_orbits(const medax_flow *flow,
                               const double *query_xyz,
                               size_t query_count,
                               const medax_job *job,
                               uint32_t *out_ends,
                               const medax_complex **out_orbits);

/**
 * What flows from some Voronoi cells, facets, edges and vertices: these, and whatever can be reached from them.
 *
 * Of the simplex of a critical point that is its unstable manifold (section 5), hairs included; of a sample that of all facets of its Voronoi
 * cell. What is unbounded is left out. Attributes are those of #medax_flow_core.
 *
 * \param flow The flow.
 * \param simplices The simplices whose duals flow; NULL only if `simplex_count` is 0.
 * \param simplex_count The number of them.
 * \param job NULL for a default job.
 * \param out_complex Receives the complex, which the caller frees with #medax_complex_free.
 * \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` with the row of a simplex that is not there; `NULL_ARGUMENT`, `LIMIT_EXCEEDED`,
 *         `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(size of the dual), and O(size) of what is reached. Since 0.1.
 */
MEDAX_API
medax_status medax_flow_closure(const medax_flow *flow,
                                const medax_simplex *simplices,
                                size_t simplex_count,
                                const medax_job *job,
                                const medax_complex **out_complex);

/**
 * Checks drivers and critical points by other means than those that made them.
 *
 * \param flow The flow.
 * \param job NULL for a default job.
 * \param out_report Filled, its `struct_size` being set.
 * \return `MEDAX_STATUS_OK` whatever was found; `NULL_ARGUMENT`, `INVALID_ARGUMENT` for a report
 *         of no version, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(size of the dual). Since 0.1.
 */
MEDAX_API
medax_status medax_flow_validate(const medax_flow *flow,
                                 const medax_job *job,
                                 medax_validation *out_report);

/**
 * One more reference to a flow.
 *
 * \param flow The flow, or NULL.
 * \return The same pointer; the caller frees it once more.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API const medax_flow *medax_flow_clone(const medax_flow *flow);

/**
 * Gives one reference to a flow back; the last one frees it.
 *
 * \param flow The flow; NULL does nothing.
 *
 * Since 0.1.
 */
MEDAX_API void medax_flow_free(const medax_flow *flow);

/* ---- 20. Core ---------------------------------------------------------------------------------
 *
 * What flows from the critical points of the medial axis on one side of the surface: an axis, of faces and loose edges, with the homotopy type
 * of the solid where the sample is dense enough. Repaired, the inner core has that of the labelled solid, however sparse the sample is. A core can be
 * extended by Voronoi facets, such as those that a filter of a #medax_medial lets pass, which alone need not have it.
 * (Giesen, Ramos, Sadri 2010, Medial axis approximation and unstable flow complex.)
 */

/**
 * Which core.
 */
typedef struct {
    /**
     * The size of this struct in the caller's program.
     */
    size_t struct_size;
    /**
     * A #medax_side: of the critical points of which axis; `MEDAX_SIDE_INNER` by default.
     */
    uint32_t side;
    /**
     * 1, the default, to add as much of the flow of other critical points to the inner core as it takes for it to have the homotopy type
     * of the labelled solid, however sparse the sample is; 0 not to. Other cores are not repaired.
     */
    uint32_t repair;
} medax_core_options;

/**
 * What became of the facets by which a core was to be extended, each counted once. The caller sets `struct_size`, the library the rest.
 */
typedef struct {
    /**
     * The size of this struct in the caller's program.
     */
    size_t struct_size;
    /**
     * The number of those that extend it.
     */
    uint64_t taken;
    /**
     * The number of those that cross the surface, and so are left out: the dual edge is one of its edges.
     */
    uint64_t of_surface;
    /**
     * The number of those on the other side of the surface, which are left out.
     */
    uint64_t elsewhere;
    /**
     * The number of those whose flow comes to a critical point of the surface, or of the other side, and of those that stay open for a sample within the solid when the core is repaired; they are left out.
     */
    uint64_t leaving;
    /**
     * The number of faces and loose edges of the core itself that are left out, since they are unbounded.
     */
    uint64_t unbounded;
} medax_core_report;

/**
 * Sets core options to their defaults.
 *
 * \param options The caller's struct, of `struct_size` bytes.
 * \param struct_size `sizeof *options`.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_status medax_core_options_init(medax_core_options *options, size_t struct_size);

/**
 * The core of one side: what flows from the critical points of its medial axis, which has the homotopy type of the solid if the sample is
 * dense enough (theorem 3.16); extended by what flows from some Voronoi facets, but for those that cannot extend it (theorem 3.17).
 *
 * Vertices carry `radius` (their distance from the samples), `cell` (of which they are the Voronoi vertex, or `MEDAX_NONE`) and `critical`
 * (the row of the critical point that they are, or `MEDAX_NONE`). Faces carry `facet` (of which they are a part), `samples` (the two ends of
 * its dual edge) and `lambda` (half the length of that); edges, those of no face, `samples` (the corners of the triangle of whose Voronoi edge they
 * are a part; or the two samples of the facet through which they follow an orbit, then `MEDAX_NONE`).
 *
 * \param flow The flow.
 * \param facets `facet_count` rows of #medax_dual_facets, as #medax_medial_selected has them; NULL only if `facet_count` is 0.
 * \param facet_count The number of facets by which the core is to be extended.
 * \param options NULL for the defaults.
 * \param job NULL for a default job.
 * \param out_report Filled, its `struct_size` being set; or NULL.
 * \param out_core Receives the complex, which the caller frees with #medax_complex_free.
 * \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` with a facet that is not there, for an option out of range, and for a report of no
 *         version; `NULL_ARGUMENT`, `LIMIT_EXCEEDED`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(size of the dual), and O(size) of the part of the flow complex that is reached. Since 0.1.
 */
MEDAX_API
medax_status medax_flow_core(const medax_flow *flow,
                             const uint32_t *facets,
                             size_t facet_count,
                             const medax_core_options *options,
                             const medax_job *job,
                             medax_core_report *out_report,
                             const medax_complex **out_core);

/* ---- 21. Flow complex -------------------------------------------------------------------------
 *
 * The unstable flow complex of a sample: the Voronoi diagram, cut where the flow of one part runs into a part of another, so that every
 * element flows into whole elements. A vertex flows into one edge; the part of a Voronoi edge that the flow crosses into one face; every
 * other edge to its ends, and every face to its rim. These steps, and those from an element to its sides, are the flow DAG: what can be
 * reached by them from some elements is their flow closure.
 *
 * Its cells are those of the Voronoi diagram, one for each sample. Vertices are first the Voronoi vertices, one for each cell of the
 * triangulation, then points on Voronoi edges; edges first the parts of Voronoi edges, then cuts through Voronoi facets along orbits of
 * Voronoi vertices; faces the parts of Voronoi facets. Where samples are cospherical, vertices lie in one place, and edges and faces may have
 * no extent: they are told apart by the triangulation. The paper's complex is coarser: here two faces may be in the unstable manifolds of the
 * same critical points.
 *
 * On scans it has 40 to 120 faces for each sample, and takes 4 to 13 kB; for a core or a closure alone a #medax_flow is enough.
 * (Giesen, Ramos, Sadri 2010, Medial axis approximation and unstable flow complex.)
 */

/**
 * An element of a flow complex.
 */
typedef struct {
    /**
     * A #medax_element: `MEDAX_ELEMENT_VERTEX`, `MEDAX_ELEMENT_EDGE` or `MEDAX_ELEMENT_FACE`.
     */
    uint32_t kind;
    /**
     * Which one of its kind.
     */
    uint32_t number;
} medax_flow_element;

/**
 * Makes all of the flow complex.
 *
 * \param flow The flow, which the result keeps alive.
 * \param job NULL for a default job.
 * \param out_flow_complex Receives the flow complex, which the caller frees with #medax_flow_complex_free.
 * \return `MEDAX_STATUS_OK`; `LIMIT_EXCEEDED` past 2^32 - 1 sides of faces; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(size of the complex), besides sorting the points on each Voronoi edge. Since 0.1.
 */
MEDAX_API
medax_status medax_flow_complex_build(const medax_flow *flow,
                                      const medax_job *job,
                                      const medax_flow_complex **out_flow_complex);

/**
 * The flow.
 *
 * \param flow_complex The flow complex.
 * \param out_flow Receives the flow, which the caller frees with #medax_flow_free.
 * \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_status medax_flow_complex_flow(const medax_flow_complex *flow_complex,
                                     const medax_flow **out_flow);

/**
 * The number of vertices.
 *
 * \param flow_complex The flow complex; NULL has none.
 * \return m + k for m cells of the triangulation and k #medax_flow_complex_points.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API size_t medax_flow_complex_vertex_count(const medax_flow_complex *flow_complex);

/**
 * The points on Voronoi edges: the vertices that come after the Voronoi vertices, which lie where #medax_dual_centers has them.
 *
 * \param flow_complex The flow complex, or NULL.
 * \return k x 3 coordinates: where orbits hit Voronoi edges, then the critical points of index 2. Borrowed from `flow_complex`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_view_f64 medax_flow_complex_points(const medax_flow_complex *flow_complex);

/**
 * The triangle on whose Voronoi edge each of the points lies.
 *
 * \param flow_complex The flow complex, or NULL.
 * \return k x 1 rows of #medax_flow_triangles. Borrowed from `flow_complex`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_view_u32 medax_flow_complex_triangle_of_point(const medax_flow_complex *flow_complex);

/**
 * The two ends of each edge.
 *
 * \param flow_complex The flow complex, or NULL.
 * \return e x 2 vertices, `MEDAX_NONE` at infinity. Orbits run from the first to the second end of a cut. Borrowed from `flow_complex`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_view_u32 medax_flow_complex_edges(const medax_flow_complex *flow_complex);

/**
 * The triangle whose Voronoi edge each edge is a part of.
 *
 * \param flow_complex The flow complex, or NULL.
 * \return One row of #medax_flow_triangles for each of the first edges; those beyond are cuts. Borrowed from `flow_complex`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_view_u32 medax_flow_complex_triangle_of_edge(const medax_flow_complex *flow_complex);

/**
 * The vertices of each face.
 *
 * \param flow_complex The flow complex, or NULL.
 * \return f rows, counterclockwise seen from the second end of the facet's dual edge; `MEDAX_NONE` at infinity. Borrowed from `flow_complex`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_view_rows medax_flow_complex_faces(const medax_flow_complex *flow_complex);

/**
 * The edges of each face.
 *
 * \param flow_complex The flow complex, or NULL.
 * \return f rows, as long as those of #medax_flow_complex_faces: at the place of a vertex the edge that begins there. Borrowed from
 *         `flow_complex`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_view_rows medax_flow_complex_face_edges(const medax_flow_complex *flow_complex);

/**
 * Where the faces of each Voronoi facet begin.
 *
 * \param flow_complex The flow complex, or NULL.
 * \return One entry more than #medax_dual_facets has rows: the faces of facet i are those from entry i to before entry i + 1. Borrowed from
 *         `flow_complex`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_view_u32 medax_flow_complex_faces_of_facet(const medax_flow_complex *flow_complex);

/**
 * The edge into which each vertex flows.
 *
 * \param flow_complex The flow complex, or NULL.
 * \return One edge for each vertex; `MEDAX_NONE` for critical points. Borrowed from `flow_complex`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_u32 medax_flow_complex_edge_of_vertex(const medax_flow_complex *flow_complex);

/**
 * The face into which each edge flows.
 *
 * \param flow_complex The flow complex, or NULL.
 * \return One face for each edge; `MEDAX_NONE` for those that flow along themselves. Borrowed from `flow_complex`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_view_u32 medax_flow_complex_face_of_edge(const medax_flow_complex *flow_complex);

/**
 * The elements that a Voronoi facet, edge or vertex is made of: its faces, its parts, or the vertex; but no cuts through a facet.
 *
 * \param flow_complex The flow complex.
 * \param simplex The simplex whose dual is asked for.
 * \param capacity The number of elements for which `out_elements` has room.
 * \param out_elements Receives the first `capacity` of the elements, which ascend; the caller's buffer, NULL only if `capacity` is 0.
 * \param out_count Receives the number of elements, which may be more than `capacity`.
 * \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` for a simplex that is not there; `NULL_ARGUMENT`.
 *
 * O(size of the answer). Since 0.1.
 */
MEDAX_API
medax_status medax_flow_complex_elements_of(const medax_flow_complex *flow_complex,
                                            medax_simplex simplex,
                                            size_t capacity,
                                            medax_flow_element *out_elements,
                                            size_t *out_count);

/**
 * The flow closure of some elements: those that can be reached from them by the flow DAG, these included.
 *
 * \param flow_complex The flow complex.
 * \param elements The elements to begin with; NULL only if `element_count` is 0.
 * \param element_count The number of them.
 * \param job NULL for a default job.
 * \param capacity The number of elements for which `out_elements` has room.
 * \param out_elements Receives the first `capacity` of the elements of the closure: vertices, then edges, then faces, ascending; the caller's
 *        buffer, NULL only if `capacity` is 0.
 * \param out_count Receives the number of elements of the closure, which may be more than `capacity`.
 * \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` with the row of an element that is not there; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`,
 *         `OUT_OF_MEMORY`.
 *
 * O(size of the complex). Since 0.1.
 */
MEDAX_API
medax_status medax_flow_complex_closure(const medax_flow_complex *flow_complex,
                                        const medax_flow_element *elements,
                                        size_t element_count,
                                        const medax_job *job,
                                        size_t capacity,
                                        medax_flow_element *out_elements,
                                        size_t *out_count);

/**
 * The elements from which some elements can be reached by the flow DAG, these included: all that have a part of them in their closures.
 *
 * \param flow_complex The flow complex.
 * \param elements The elements to end with; NULL only if `element_count` is 0.
 * \param element_count The number of them.
 * \param job NULL for a default job.
 * \param capacity The number of elements for which `out_elements` has room.
 * \param out_elements Receives the first `capacity` of the elements upstream: vertices, then edges, then faces, ascending; the caller's
 *        buffer, NULL only if `capacity` is 0.
 * \param out_count Receives the number of elements upstream, which may be more than `capacity`.
 * \return As #medax_flow_complex_closure.
 *
 * O(size of the complex). Since 0.1.
 */
MEDAX_API
medax_status medax_flow_complex_upstream(const medax_flow_complex *flow_complex,
                                         const medax_flow_element *elements,
                                         size_t element_count,
                                         const medax_job *job,
                                         size_t capacity,
                                         medax_flow_element *out_elements,
                                         size_t *out_count);

/**
 * The critical points in whose unstable manifolds each of some elements lies: those whose flow closure has it.
 *
 * \param flow_complex The flow complex.
 * \param elements The elements; NULL only if `element_count` is 0.
 * \param element_count The number of them.
 * \param job NULL for a default job.
 * \param out_offsets Receives `element_count` + 1 positions: the set of element i is the rows from entry i to before entry i + 1, ascending.
 * \param capacity The number of rows for which `out_rows` has room.
 * \param out_rows Receives the first `capacity` rows of all sets, one set's after the other's, as #medax_flow_critical_points has them; the
 *        caller's buffer, NULL only if `capacity` is 0.
 * \param out_count Receives the number of rows of all sets, which may be more than `capacity`.
 * \return As #medax_flow_complex_closure; `LIMIT_EXCEEDED` past 2^32 - 1 rows.
 *
 * O(size of the complex), and for each element O(size) of what is upstream of it. Since 0.1.
 */
MEDAX_API
medax_status medax_flow_complex_critical_sets(const medax_flow_complex *flow_complex,
                                              const medax_flow_element *elements,
                                              size_t element_count,
                                              const medax_job *job,
                                              uint32_t *out_offsets,
                                              size_t capacity,
                                              uint32_t *out_rows,
                                              size_t *out_count);

/**
 * All of the flow complex that is bounded, with the attributes of #medax_flow_core.
 *
 * \param flow_complex The flow complex.
 * \param job NULL for a default job.
 * \param out_complex Receives the complex, which the caller frees with #medax_complex_free.
 * \return `MEDAX_STATUS_OK`; `NULL_ARGUMENT`, `LIMIT_EXCEEDED`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(size of the complex). Since 0.1.
 */
MEDAX_API
medax_status medax_flow_complex_complex(const medax_flow_complex *flow_complex,
                                        const medax_job *job,
                                        const medax_complex **out_complex);

/**
 * Checks a flow complex by other means than those that made it.
 *
 * \param flow_complex The flow complex.
 * \param job NULL for a default job.
 * \param out_report Filled, its `struct_size` being set.
 * \return `MEDAX_STATUS_OK` whatever was found; `NULL_ARGUMENT`, `INVALID_ARGUMENT` for a report
 *         of no version, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(size of the complex). Since 0.1.
 */
MEDAX_API
medax_status medax_flow_complex_validate(const medax_flow_complex *flow_complex,
                                         const medax_job *job,
                                         medax_validation *out_report);

/**
 * One more reference to a flow complex.
 *
 * \param flow_complex The flow complex, or NULL.
 * \return The same pointer; the caller frees it once more.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
const medax_flow_complex *medax_flow_complex_clone(const medax_flow_complex *flow_complex);

/**
 * Gives one reference to a flow complex back; the last one frees it.
 *
 * \param flow_complex The flow complex; NULL does nothing.
 *
 * Since 0.1.
 */
MEDAX_API void medax_flow_complex_free(const medax_flow_complex *flow_complex);

/* ---- 22. Pair-mesh ----------------------------------------------------------------------------
 *
 * A solid between an inner structure and its boundary, in pyramids and tetrahedra, each with some vertices on either. A node pairs a vertex of
 * the boundary with an inner one; an element is a ring of nodes. With each node so far on the way from its inner vertex (t = 0) to that of the boundary
 * (t = 1), nodes and rings are a closed surface for every t. (Shaham, Shamir, Cohen-Or 2004, Medial axis based solid representation.)
 */

/**
 * The kinds of elements. (Shaham, Shamir, Cohen-Or 2004, figure 1.)
 */
enum medax_pair_element
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
    /**
     * A pyramid with a vertex of the boundary over a face of the inner structure.
     */
    MEDAX_PAIR_ELEMENT_FACE_VERTEX = 1,
    /**
     * A tetrahedron between an edge of the inner structure and one of the boundary.
     */
    MEDAX_PAIR_ELEMENT_EDGE_EDGE = 2,
    /**
     * A tetrahedron with an inner vertex over a triangle of the boundary.
     */
    MEDAX_PAIR_ELEMENT_VERTEX_FACE = 3,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum medax_pair_element medax_pair_element;
#else
typedef uint32_t medax_pair_element;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

/**
 * The pair-mesh between the inner part of a Voronoi diagram and the surface between inner and outer cells.
 *
 * It always succeeds. Samples of which all cells are inner are removed, and the rest is triangulated anew. Voronoi vertices of cells that
 * share a sphere are one. Where an element would be turned inside out, inner vertices are moved, no farther than they must; a facet that is no longer
 * planar is divided into triangles round a vertex in its middle. The surface stays as it is.
 *
 * \param dual The Voronoi diagram of the samples, which must have its facets.
 * \param labels Which of its cells are inner: by Tight Cocone, a power crust, a mesh, or the caller.
 * \param job NULL for a default job.
 * \param out_pair Receives the pair-mesh, which the caller frees with #medax_pair_free.
 * \return `MEDAX_STATUS_OK`; `DEGENERATE` where no cell is inner; `INVALID_ARGUMENT` for a power diagram, or one without facets; `MISMATCH`
 *         for labels of another triangulation; `LIMIT_EXCEEDED` past 2^32 - 1 corners; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`,
 *         `OUT_OF_MEMORY`.
 *
 * O(size of the dual), besides what is mended. Since 0.1.
 */
MEDAX_API
medax_status medax_pair_voronoi(const medax_dual *dual,
                                const medax_labels *labels,
                                const medax_job *job,
                                const medax_pair **out_pair);

/**
 * The number of elements of a kind. Elements stand by kind: pyramids first, those over both sides of inner face `f` are `2 * f` and
 * `2 * f + 1`; then those between edges; then those over the triangles of the boundary.
 *
 * \param pair The pair-mesh; NULL has none.
 * \param kind A #medax_pair_element, or 0 for all.
 * \return The number of elements; 0 for a kind that is none.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
size_t medax_pair_element_count(const medax_pair *pair,
                                uint32_t kind);

/**
 * The vertices of the boundary.
 *
 * \param pair The pair-mesh, or NULL.
 * \return n x 3 coordinates. Borrowed from `pair`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_f64 medax_pair_boundary_vertices(const medax_pair *pair);

/**
 * The sample that each vertex of the boundary is; `MEDAX_NONE` for one by which triangles were divided (#medax_pair_onto).
 *
 * \param pair The pair-mesh, or NULL.
 * \return n x 1 vertices of the triangulation. Borrowed from `pair`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_view_u32 medax_pair_boundary_samples(const medax_pair *pair);

/**
 * The inner vertices.
 *
 * \param pair The pair-mesh, or NULL.
 * \return m x 3 coordinates. Borrowed from `pair`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_f64 medax_pair_inner_vertices(const medax_pair *pair);

/**
 * The cell of which each inner vertex is the Voronoi vertex, of several the least.
 *
 * \param pair The pair-mesh, or NULL.
 * \return m x 1 cells; `MEDAX_NONE` for a vertex in the middle of a facet, and throughout where samples were removed. Borrowed from `pair`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_view_u32 medax_pair_inner_cells(const medax_pair *pair);

/**
 * Where each inner vertex would be, had nothing been turned inside out.
 *
 * \param pair The pair-mesh, or NULL.
 * \return m x 3 coordinates. Borrowed from `pair`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_f64 medax_pair_voronoi_vertices(const medax_pair *pair);

/**
 * The faces of the inner structure.
 *
 * \param pair The pair-mesh, or NULL.
 * \return One row a face: inner vertices, counterclockwise seen from the apex of the second of its two pyramids. Borrowed from `pair`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_view_rows medax_pair_inner_faces(const medax_pair *pair);

/**
 * The nodes.
 *
 * \param pair The pair-mesh, or NULL.
 * \return k x 2: a vertex of the boundary, an inner vertex. Borrowed from `pair`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_u32 medax_pair_nodes(const medax_pair *pair);

/**
 * The elements, each as its nodes.
 *
 * \param pair The pair-mesh, or NULL.
 * \return One row an element, counterclockwise seen from the boundary: of a pyramid its apex with each corner of its base; of an element between two edges the ends of the boundary's with the first end of the inner one, then, the other way round, with the second; of one over a triangle its corners. Borrowed from `pair`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_view_rows medax_pair_rings(const medax_pair *pair);

/**
 * The samples inside the solid, which were removed.
 *
 * \param pair The pair-mesh, or NULL.
 * \return Vertices of the triangulation, ascending. Borrowed from `pair`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_u32 medax_pair_removed(const medax_pair *pair);

/**
 * The volume that the boundary encloses.
 *
 * \param pair The pair-mesh; NULL encloses nothing.
 * \return The volume, in cubed input units.
 *
 * O(triangles). Since 0.1.
 */
MEDAX_API double medax_pair_enclosed_volume(const medax_pair *pair);

/**
 * The volume of each element; less than 0 where one is turned inside out, or by rounding where it has next to none: #medax_pair_folded decides exactly.
 *
 * \param pair The pair-mesh.
 * \param job NULL for a default job.
 * \param out_volumes Receives a number for each element, in cubed input units; the caller's buffer.
 * \return `MEDAX_STATUS_OK`; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(size). Since 0.1.
 */
MEDAX_API
medax_status medax_pair_volumes(const medax_pair *pair,
                                const medax_job *job,
                                double *out_volumes);

/**
 * The centroid of each element; of one without volume the mean of its corners.
 *
 * \param pair The pair-mesh.
 * \param job NULL for a default job.
 * \param out_centroids Receives 3 coordinates for each element; the caller's buffer.
 * \return `MEDAX_STATUS_OK`; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(size). Since 0.1.
 */
MEDAX_API
medax_status medax_pair_centroids(const medax_pair *pair,
                                  const medax_job *job,
                                  double *out_centroids);

/**
 * The shell of each element: the closed surface that it is a face of for every t. Shells are numbered from 0 as they come.
 *
 * \param pair The pair-mesh.
 * \param job NULL for a default job.
 * \param out_shells Receives a number for each element; the caller's buffer.
 * \return `MEDAX_STATUS_OK`; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(size). Since 0.1.
 */
MEDAX_API
medax_status medax_pair_shells(const medax_pair *pair,
                               const medax_job *job,
                               uint32_t *out_shells);

/**
 * The elements that are turned inside out, in part or as a whole: some tetrahedron has a volume that is exactly less than 0. None of a pair-mesh as
 * it is built, but where rounding leaves no other place; those of one that was deformed may be many.
 *
 * \param pair The pair-mesh.
 * \param job NULL for a default job.
 * \param out_folded Receives these elements, ascending; the caller's buffer, with room for as many as there are elements. The rest is left as it is.
 * \param out_count Receives how many they are.
 * \return `MEDAX_STATUS_OK`; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(size). Since 0.1.
 */
MEDAX_API
medax_status medax_pair_folded(const medax_pair *pair,
                               const medax_job *job,
                               uint32_t *out_folded,
                               size_t *out_count);

/**
 * The surface on which each node is so far on the way from its inner vertex to its vertex of the boundary.
 *
 * For t below 1 its vertices are the nodes and its faces the rings, the same for every t; for t = 0 it wraps the inner structure, and its two sides
 * coincide. For t = 1 it is the boundary itself, vertex for vertex. Faces are convex, and planar but for rounding. Vertices carry `sample` and `inner_vertex`, faces
 * `element` and `kind`; those of the boundary `sample` and `element`.
 *
 * \param pair The pair-mesh.
 * \param t How far, in [0, 1].
 * \param job NULL for a default job.
 * \param out_complex Receives the complex, which the caller frees with #medax_complex_free.
 * \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` for another t; `LIMIT_EXCEEDED` past 2^32 - 2 elements; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`,
 *         `OUT_OF_MEMORY`.
 *
 * O(size). Since 0.1.
 */
MEDAX_API
medax_status medax_pair_iso_surface(const medax_pair *pair,
                                    double t,
                                    const medax_job *job,
                                    const medax_complex **out_complex);

/**
 * The solid as volume cells, an element each: tetrahedra, and pyramids over faces of more than three corners.
 *
 * Vertices are those of the boundary, then the inner ones, with `t` (1 on the boundary, 0 inside) and `sample`; cells carry `kind` and `volume`.
 *
 * \param pair The pair-mesh.
 * \param job NULL for a default job.
 * \param out_complex Receives the complex, which the caller frees with #medax_complex_free.
 * \return `MEDAX_STATUS_OK`; `LIMIT_EXCEEDED` past 2^32 - 2 elements; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(size). Since 0.1.
 */
MEDAX_API
medax_status medax_pair_solid(const medax_pair *pair,
                              const medax_job *job,
                              const medax_complex **out_complex);

/**
 * The boundary: triangles that point out of the solid. Vertices carry `sample`, faces `element`.
 *
 * \param pair The pair-mesh.
 * \param job NULL for a default job.
 * \param out_complex Receives the complex, which the caller frees with #medax_complex_free.
 * \return `MEDAX_STATUS_OK`; `LIMIT_EXCEEDED` past 2^32 - 2 elements; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(size). Since 0.1.
 */
MEDAX_API
medax_status medax_pair_boundary(const medax_pair *pair,
                                 const medax_job *job,
                                 const medax_complex **out_complex);

/**
 * The inner structure: its faces, and the edges that belong to none. Vertices carry `cell` and `moved`, how far they are from where they would be,
 * had nothing been turned inside out; faces `samples`, those of their two pyramids; loose edges `samples`, three of those round them; faces and edges `reason`, a #medax_pair_reason.
 *
 * \param pair The pair-mesh.
 * \param job NULL for a default job.
 * \param out_complex Receives the complex, which the caller frees with #medax_complex_free.
 * \return `MEDAX_STATUS_OK`; `LIMIT_EXCEEDED` past 2^32 - 2 elements; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(size). Since 0.1.
 */
MEDAX_API
medax_status medax_pair_inner(const medax_pair *pair,
                              const medax_job *job,
                              const medax_complex **out_complex);

/**
 * Checks that the elements are a partition of the solid: their sides meet in pairs, none is turned inside out but for rounding, and their volumes sum up to what the
 * boundary encloses.
 *
 * \param pair The pair-mesh.
 * \param job NULL for a default job.
 * \param out_report Filled, its `struct_size` being set.
 * \return `MEDAX_STATUS_OK`, whatever is found; `INVALID_ARGUMENT` for a report of no version; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(size). Since 0.1.
 */
MEDAX_API
medax_status medax_pair_validate(const medax_pair *pair,
                                 const medax_job *job,
                                 medax_validation *out_report);

/**
 * One more reference to a pair-mesh.
 *
 * \param pair The pair-mesh, or NULL.
 * \return The same pointer; the caller frees it once more.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API const medax_pair *medax_pair_clone(const medax_pair *pair);

/**
 * Gives one reference to a pair-mesh back; the last one frees it.
 *
 * \param pair The pair-mesh; NULL does nothing.
 *
 * Since 0.1.
 */
MEDAX_API void medax_pair_free(const medax_pair *pair);

/* ---- 23. Pair-mesh of a part ------------------------------------------------------------------
 *
 * A pair-mesh between the boundary of a solid and a part of its Voronoi diagram: a filtered medial axis, or a core. What is not
 * asked for is collapsed, as long as no element gets folded. (Shaham, Shamir, Cohen-Or 2004, section 4.)
 */

/**
 * Why a face or a loose edge of the inner structure is there.
 */
enum medax_pair_reason
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
    /**
     * It was asked for.
     */
    MEDAX_PAIR_REASON_ASKED = 0,
    /**
     * None of its edges, or ends, is free: it closes a hole of what was asked for, joins parts of it, or lies behind what stays.
     */
    MEDAX_PAIR_REASON_ENCLOSED = 1,
    /**
     * Something of it is free, but without it an element would be folded: some of the boundary would see nothing.
     */
    MEDAX_PAIR_REASON_UNSEEN = 2,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum medax_pair_reason medax_pair_reason;
#else
typedef uint32_t medax_pair_reason;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

/**
 * How a pair-mesh is brought onto a part of its inner structure.
 */
typedef struct {
    /**
     * The size of this struct in the caller's program.
     */
    size_t struct_size;
    /**
     * 1 to divide triangles of the boundary round their centroids, at the middles of their edges, where no more goes without; 0, the default,
     * not to. The boundary stays where it is, but has more vertices, of which the sample is `MEDAX_NONE`. Where it touches itself in an edge, the sheets there
     * may be divided at different vertices.
     */
    uint32_t subdivide;
    /**
     * 1 to fail where anything stays that was not asked for, or what was is not there; 0, the default, not to.
     */
    uint32_t exact;
} medax_pair_onto_options;

/**
 * Sets the options to their defaults.
 *
 * \param options The caller's struct, of `struct_size` bytes.
 * \param struct_size `sizeof *options`.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_status medax_pair_onto_options_init(medax_pair_onto_options *options,
                                          size_t struct_size);

/**
 * The pair-mesh of a part of the inner structure: of the Voronoi facets and edges in which a complex lies, such as the axis of a
 * #medax_medial, or a core, of the same samples. Of its faces and loose edges only the attribute `samples` counts; a complex without either
 * asks for nothing, and so for as little as can be.
 *
 * What is not asked for is collapsed, bit by bit, as long as no element gets folded. So it always succeeds: where no more can go, the rest
 * stays, and #medax_pair_reasons tells what stood in the way. The search is local, so that another order might leave less. Faces that stay unasked are
 * triangles, and their corners may have moved into others. What was asked for and is not there counts in #medax_pair_missing.
 *
 * \param pair A pair-mesh of #medax_pair_voronoi. It stays as it is.
 * \param part A complex of which the faces have an attribute `samples` of two indices, and the loose edges one of three.
 * \param options NULL for the defaults.
 * \param job NULL for a default job.
 * \param out_pair Receives the pair-mesh, which the caller frees with #medax_pair_free.
 * \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` for faces or loose edges without `samples`, an option out of range, or a pair-mesh that is a part
 *         already, or deformed; `DEGENERATE` where it was to be exact and something is missing, or stays unasked: then with the first such face; `LIMIT_EXCEEDED` past 2^32 - 2 sides; `NULL_ARGUMENT`, `CANCELLED`,
 *         `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(size log size) where few changes are refused. Since 0.1.
 */
MEDAX_API
medax_status medax_pair_onto(const medax_pair *pair,
                             const medax_complex *part,
                             const medax_pair_onto_options *options,
                             const medax_job *job,
                             const medax_pair **out_pair);

/**
 * The number of Voronoi facets and edges asked for that the inner structure does not have: they are of another diagram, outside, or of samples that
 * were removed.
 *
 * \param pair The pair-mesh; NULL lacks none.
 * \return A count, 0 for a pair-mesh of #medax_pair_voronoi.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
size_t medax_pair_missing(const medax_pair *pair);

/**
 * Why each face of the inner structure is there. The loose edges that were not asked for have theirs in the complex of #medax_pair_inner.
 *
 * \param pair The pair-mesh.
 * \param out_reasons Receives a #medax_pair_reason for each row of #medax_pair_inner_faces.
 * \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
 *
 * O(faces). Since 0.1.
 */
MEDAX_API
medax_status medax_pair_reasons(const medax_pair *pair,
                                uint32_t *out_reasons);

/* ---- 24. Place --------------------------------------------------------------------------------
 *
 * Coordinates in a pair-mesh: which element holds a point, and how far it is between the inner structure and the boundary; and deformations, in
 * which each node keeps its vector.
 */

/**
 * A point of a solid.
 */
typedef struct {
    /**
     * The element, or `MEDAX_NONE` for a point outside the solid.
     */
    uint32_t element;
    /**
     * The number of a tetrahedron of it, as #medax_pair_piece takes it.
     */
    uint32_t piece;
    /**
     * How much each corner of that weighs: barycentric coordinates, whose sum is 1. NaN outside.
     */
    double weights[4];
    /**
     * How far the point is on the way from the inner structure (0) to the boundary (1). NaN outside.
     */
    double t;
} medax_place;

/**
 * The place of each point; of several elements that share it the least. Which tetrahedron holds a point is decided exactly.
 *
 * \param pair The pair-mesh.
 * \param query_xyz `query_count` x 3 coordinates; NULL only if `query_count` is 0.
 * \param query_count The number of points.
 * \param job NULL for a default job.
 * \param out_places Receives `query_count` places; the caller's buffer, NULL only if `query_count` is 0.
 * \return `MEDAX_STATUS_OK`; `NON_FINITE`, or `COORDINATE_RANGE`, with the row of a query; `NULL_ARGUMENT`, `INVALID_ARGUMENT`, `CANCELLED`,
 *         `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(size log size), then about O(log size) a query: ask for many at once. Since 0.1.
 */
MEDAX_API
medax_status medax_pair_locate(const medax_pair *pair,
                               const double *query_xyz,
                               size_t query_count,
                               const medax_job *job,
                               medax_place *out_places);

/**
 * The points at some places: the weighted means of the corners, whatever the weights.
 *
 * \param pair The pair-mesh.
 * \param places `place_count` places, of which `t` counts for nothing; NULL only if `place_count` is 0.
 * \param place_count The number of places.
 * \param out_xyz Receives `place_count` x 3 coordinates; the caller's buffer, NULL only if `place_count` is 0.
 * \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` with the row of a place whose element or tetrahedron is not there; `NULL_ARGUMENT`.
 *
 * O(places). Since 0.1.
 */
MEDAX_API
medax_status medax_pair_positions(const medax_pair *pair,
                                  const medax_place *places,
                                  size_t place_count,
                                  double *out_xyz);

/**
 * The corners of a tetrahedron of an element, positively oriented. An element between two edges, or over a triangle, is one; a pyramid over k corners is k - 2,
 * its apex with a fan of its base, the same from both sides of a face.
 *
 * \param pair The pair-mesh.
 * \param element The element.
 * \param piece The number of the tetrahedron.
 * \param out_corners Receives four vertices: those of the boundary count first, then the inner ones.
 * \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` with an element that is not there, or that has no such tetrahedron; `NULL_ARGUMENT`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_status medax_pair_piece(const medax_pair *pair,
                              uint32_t element,
                              uint32_t piece,
                              uint32_t *out_corners);

/**
 * The mesh with the inner vertices at other places, and each vertex of the boundary moved by the mean of what the inner vertices of its nodes are moved by.
 * #medax_pair_folded tells which elements that turns inside out.
 *
 * \param pair The pair-mesh, which stays as it is.
 * \param inner_xyz `inner_count` x 3 coordinates, one row for each inner vertex.
 * \param inner_count How many.
 * \param job NULL for a default job.
 * \param out_pair Receives the pair-mesh, which the caller frees with #medax_pair_free.
 * \return `MEDAX_STATUS_OK`; `MISMATCH` for another number of vertices; `NON_FINITE` and `COORDINATE_RANGE` with the vertex; `NULL_ARGUMENT`,
 *         `INVALID_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(size). Since 0.1.
 */
MEDAX_API
medax_status medax_pair_with_inner(const medax_pair *pair,
                                   const double *inner_xyz,
                                   size_t inner_count,
                                   const medax_job *job,
                                   const medax_pair **out_pair);

/**
 * The mesh with the vertices of the boundary at other places, and each inner vertex moved by the mean of what the boundary vertices of its nodes are moved by.
 *
 * \param pair The pair-mesh, which stays as it is.
 * \param boundary_xyz `boundary_count` x 3 coordinates, one row for each vertex of the boundary.
 * \param boundary_count How many.
 * \param job NULL for a default job.
 * \param out_pair Receives the pair-mesh, which the caller frees with #medax_pair_free.
 * \return As #medax_pair_with_inner.
 *
 * O(size). Since 0.1.
 */
MEDAX_API
medax_status medax_pair_with_boundary(const medax_pair *pair,
                                      const double *boundary_xyz,
                                      size_t boundary_count,
                                      const medax_job *job,
                                      const medax_pair **out_pair);

/* ---- 25. Half-faces ---------------------------------------------------------------------------
 *
 * Every face of every element of a pair-mesh, seen from inside that element, with its edges: for walks through the solid, round edges at which any number of
 * elements meet, and over the inner structure and what wraps it. (Shaham, Shamir, Cohen-Or 2004, section 3.1.)
 *
 * An element's half-faces follow one another, a half-face's half-edges too, counterclockwise seen from outside the element. Those of a pyramid are its base, then its
 * sides; of an element over a triangle the triangle, then its sides; of one between two edges its four sides: sides in the order of the element's ring.
 */

/**
 * Makes the half-faces of a pair-mesh.
 *
 * \param pair The pair-mesh.
 * \param job NULL for a default job.
 * \param out_half_faces Receives the half-faces, which the caller frees with #medax_half_faces_free.
 * \return `MEDAX_STATUS_OK`; `LIMIT_EXCEEDED` past 2^32 - 2 half-edges; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(size). Since 0.1.
 */
MEDAX_API
medax_status medax_half_faces_build(const medax_pair *pair,
                                    const medax_job *job,
                                    const medax_half_faces **out_half_faces);

/**
 * Where the half-faces of each element begin.
 *
 * \param half_faces The half-faces, or NULL.
 * \return One more entry than elements. Borrowed from `half_faces`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_u32 medax_half_faces_of_element(const medax_half_faces *half_faces);

/**
 * Where the half-edges of each half-face begin.
 *
 * \param half_faces The half-faces, or NULL.
 * \return One more entry than half-faces. Borrowed from `half_faces`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_u32 medax_half_faces_offsets(const medax_half_faces *half_faces);

/**
 * The half-face on the other side of each, with the same corners the other way round.
 *
 * \param half_faces The half-faces, or NULL.
 * \return One entry a half-face; `MEDAX_NONE` on the boundary. Borrowed from `half_faces`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_u32 medax_half_faces_duals(const medax_half_faces *half_faces);

/**
 * The vertex at which each half-edge begins: those of the boundary count first, then the inner ones. It ends where the next one of its half-face begins.
 *
 * \param half_faces The half-faces, or NULL.
 * \return One entry a half-edge. Borrowed from `half_faces`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_view_u32 medax_half_faces_origins(const medax_half_faces *half_faces);

/**
 * The half-edge on the other side of each edge within the element. By turns with #medax_half_faces_partners it leads round an edge, from element to element.
 *
 * \param half_faces The half-faces, or NULL.
 * \return One entry a half-edge. Borrowed from `half_faces`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_view_u32 medax_half_faces_opposites(const medax_half_faces *half_faces);

/**
 * The half-edge of the same edge, the other way round, in the dual half-face.
 *
 * \param half_faces The half-faces, or NULL.
 * \return One entry a half-edge; `MEDAX_NONE` where there is no dual. Borrowed from `half_faces`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_u32 medax_half_faces_partners(const medax_half_faces *half_faces);

/**
 * One more reference to half-faces.
 *
 * \param half_faces The half-faces, or NULL.
 * \return The same pointer; the caller frees it once more.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API const medax_half_faces *medax_half_faces_clone(const medax_half_faces *half_faces);

/**
 * Gives one reference to half-faces back; the last one frees them.
 *
 * \param half_faces The half-faces; NULL does nothing.
 *
 * Since 0.1.
 */
MEDAX_API void medax_half_faces_free(const medax_half_faces *half_faces);

/* ---- 26. Complex ------------------------------------------------------------------------------
 *
 * The one output type: vertices; faces, which are polygons; loose edges, which are no side of a
 * face; volume cells; named attributes on each of them; and the faces cut into triangles.
 *
 * Faces of a solid's surface point out of the material, those of voids included. Elements are
 * told apart by their indices, never by where they lie.
 */

/**
 * The shape of a volume cell; its vertices are in VTK's order.
 */
enum medax_cell_type
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
    /**
     * Four vertices.
     */
    MEDAX_CELL_TYPE_TETRAHEDRON = 1,
    /**
     * A quadrilateral base, then the apex: five vertices.
     */
    MEDAX_CELL_TYPE_PYRAMID = 2,
    /**
     * A polygonal base of any size, then the apex.
     */
    MEDAX_CELL_TYPE_POLYGONAL_PYRAMID = 3,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum medax_cell_type medax_cell_type;
#else
typedef uint32_t medax_cell_type;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

/**
 * The arrays from which #medax_complex_create makes a complex. Each may be NULL if its count is
 * 0; the defaults are no element at all.
 */
typedef struct {
    /**
     * The size of this struct in the caller's program.
     */
    size_t struct_size;
    /**
     * `vertex_count` x 3 coordinates.
     */
    const double *vertices;
    /**
     * The number of vertices.
     */
    size_t vertex_count;
    /**
     * `face_count + 1` positions in `face_indices`, the first of them 0.
     */
    const uint32_t *face_offsets;
    /**
     * `face_offsets[face_count]` vertices: each face a ring.
     */
    const uint32_t *face_indices;
    /**
     * The number of faces.
     */
    size_t face_count;
    /**
     * `edge_count` x 2 vertices of edges that are no side of a face.
     */
    const uint32_t *edges;
    /**
     * The number of loose edges.
     */
    size_t edge_count;
    /**
     * `cell_count + 1` positions in `cell_indices`, the first of them 0.
     */
    const uint32_t *cell_offsets;
    /**
     * `cell_offsets[cell_count]` vertices.
     */
    const uint32_t *cell_indices;
    /**
     * `cell_count` times a #medax_cell_type.
     */
    const uint32_t *cell_types;
    /**
     * The number of volume cells.
     */
    size_t cell_count;
    /**
     * `attribute_count` attributes.
     */
    const medax_attribute *attributes;
    /**
     * The number of attributes.
     */
    size_t attribute_count;
    /**
     * 2 for plane results, whose z is 0 throughout, else 3; 0 stands for 3.
     */
    uint32_t dimension;
    /**
     * Must be 0.
     */
    uint32_t reserved;
} medax_complex_parts;

/**
 * Sets complex parts to none.
 *
 * \param parts The caller's struct, of `struct_size` bytes.
 * \param struct_size `sizeof *parts`.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_status medax_complex_parts_init(medax_complex_parts *parts, size_t struct_size);

/**
 * Makes a complex of the caller's arrays, which are checked and copied.
 *
 * \param parts The arrays.
 * \param out_complex Receives the complex, which the caller frees with #medax_complex_free.
 * \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` or `MISMATCH` with the face, edge or cell that has
 *         too few vertices or an unknown one; `NON_FINITE` with the vertex; `NULL_ARGUMENT`,
 *         `LIMIT_EXCEEDED` past 2^32 - 2 elements.
 *
 * O(n). Since 0.1.
 */
MEDAX_API
medax_status medax_complex_create(const medax_complex_parts *parts,
                                  const medax_complex **out_complex);

/**
 * 2 for plane results, whose z is 0 throughout, else 3.
 *
 * \param complex The complex; NULL has dimension 3.
 * \return 2 or 3.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API uint32_t medax_complex_dimension(const medax_complex *complex);

/**
 * The vertices of a complex.
 *
 * \param complex The complex, or NULL.
 * \return v x 3 coordinates, in input units. Borrowed from `complex`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_f64 medax_complex_vertices(const medax_complex *complex);

/**
 * The faces of a complex.
 *
 * \param complex The complex, or NULL.
 * \return One row a face: a ring of three vertices or more. Borrowed from `complex`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_rows medax_complex_faces(const medax_complex *complex);

/**
 * The loose edges of a complex: those that are no side of a face.
 *
 * \param complex The complex, or NULL.
 * \return e x 2 vertices. Borrowed from `complex`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_u32 medax_complex_edges(const medax_complex *complex);

/**
 * The volume cells of a complex.
 *
 * \param complex The complex, or NULL.
 * \return One row a cell: its vertices in VTK's order. Borrowed from `complex`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_rows medax_complex_cells(const medax_complex *complex);

/**
 * The type of each volume cell.
 *
 * \param complex The complex, or NULL.
 * \return One row a cell: a #medax_cell_type. Borrowed from `complex`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_u32 medax_complex_cell_types(const medax_complex *complex);

/**
 * The faces of a complex cut into triangles: a fan from each face's first vertex, with the
 * orientation of the face, in the order of the faces.
 *
 * \param complex The complex, or NULL.
 * \return t x 3 vertices. Borrowed from `complex`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_u32 medax_complex_triangles(const medax_complex *complex);

/**
 * The face that each triangle is part of.
 *
 * \param complex The complex, or NULL.
 * \return t x 1 faces, ascending. Borrowed from `complex`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_u32 medax_complex_face_of_triangle(const medax_complex *complex);

/**
 * The number of attributes of a complex.
 *
 * \param complex The complex; NULL has none.
 * \return The number of attributes, over all kinds of elements.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API size_t medax_complex_attribute_count(const medax_complex *complex);

/**
 * An attribute of a complex by its number.
 *
 * \param complex The complex.
 * \param index Which attribute, below #medax_complex_attribute_count.
 * \param out_attribute Receives the attribute, whose name and values are borrowed from `complex`.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` past the last attribute.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_status medax_complex_attribute_at(const medax_complex *complex,
                                        size_t index,
                                        medax_attribute *out_attribute);

/**
 * The attribute of a complex with the given name.
 *
 * \param complex The complex.
 * \param element A #medax_element: what carries the attribute.
 * \param name The name, such as `radius`; UTF-8.
 * \param out_attribute Receives the attribute, whose name and values are borrowed from `complex`.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` if there is none.
 *
 * O(attributes). Since 0.1.
 */
MEDAX_API
medax_status medax_complex_attribute(const medax_complex *complex,
                                     uint32_t element,
                                     const char *name,
                                     medax_attribute *out_attribute);

/**
 * One more reference to a complex.
 *
 * \param complex The complex, or NULL.
 * \return The same pointer; the caller frees it once more.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API const medax_complex *medax_complex_clone(const medax_complex *complex);

/**
 * Gives one reference to a complex back; the last one frees it.
 *
 * \param complex The complex; NULL does nothing.
 *
 * Since 0.1.
 */
MEDAX_API void medax_complex_free(const medax_complex *complex);

/* ---- 27. Figures ------------------------------------------------------------------------------
 *
 * Curves and points in the plane: polygons with holes, open polylines, points, circles.
 *
 * The chains of a figure are the rings of its polygons, the polylines, the points, in this order and each in the order in which
 * they were given; circles stand apart. Parts are numbered alike: the polygons, the polylines, the points, the circles. Outer
 * rings end up counterclockwise, holes clockwise. Whether curves cross is decided exactly. Coordinates must be 0 or have an absolute value
 * from 2^-160 to 2^200.
 */

/**
 * What a chain of a figure is.
 */
enum medax_chain_kind
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
    /**
     * The outer ring of a polygon: an edge from each vertex to the next, and from the last to the first.
     */
    MEDAX_CHAIN_KIND_OUTER = 0,
    /**
     * A hole of a polygon, a ring like the outer one.
     */
    MEDAX_CHAIN_KIND_HOLE = 1,
    /**
     * An open polyline: an edge from each vertex to the next.
     */
    MEDAX_CHAIN_KIND_POLYLINE = 2,
    /**
     * A single vertex.
     */
    MEDAX_CHAIN_KIND_POINT = 3,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum medax_chain_kind medax_chain_kind;
#else
typedef uint32_t medax_chain_kind;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

/**
 * What becomes of curves that cross or touch, and of polygons in the wrong place.
 */
enum medax_crossings
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
    /**
     * They are an error.
     */
    MEDAX_CROSSINGS_REFUSE = 0,
    /**
     * They are counted. What is inside is then where a ray crosses rings and circles an odd number of times.
     */
    MEDAX_CROSSINGS_ACCEPT = 1,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum medax_crossings medax_crossings;
#else
typedef uint32_t medax_crossings;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

/**
 * The arrays from which #medax_figure_create makes a figure. Each may be NULL if its count is 0; the defaults are nothing at all,
 * and crossings refused.
 */
typedef struct {
    /**
     * The size of this struct in the caller's program.
     */
    size_t struct_size;
    /**
     * `ring_vertex_count` x 2 coordinates: one ring after the other. A ring may end with its first vertex or not, and
     * turn either way.
     */
    const double *ring_vertices;
    /**
     * The number of vertices of all rings.
     */
    size_t ring_vertex_count;
    /**
     * `ring_count + 1` rows of `ring_vertices`: where each ring begins, the first at 0, and the end.
     */
    const uint32_t *ring_offsets;
    /**
     * The number of rings.
     */
    size_t ring_count;
    /**
     * `polygon_count + 1` rings: where the rings of each polygon begin, the outer ring first, then the holes; and the end.
     */
    const uint32_t *polygon_offsets;
    /**
     * The number of polygons.
     */
    size_t polygon_count;
    /**
     * `polyline_vertex_count` x 2 coordinates: one polyline after the other.
     */
    const double *polyline_vertices;
    /**
     * The number of vertices of all polylines.
     */
    size_t polyline_vertex_count;
    /**
     * `polyline_count + 1` rows of `polyline_vertices`: where each polyline begins, and the end.
     */
    const uint32_t *polyline_offsets;
    /**
     * The number of polylines.
     */
    size_t polyline_count;
    /**
     * `point_count` x 2 coordinates.
     */
    const double *points;
    /**
     * The number of points.
     */
    size_t point_count;
    /**
     * `circle_count` x 3: the centre's coordinates and the radius.
     */
    const double *circles;
    /**
     * The number of circles.
     */
    size_t circle_count;
    /**
     * A #medax_crossings.
     */
    uint32_t crossings;
    /**
     * Must be 0.
     */
    uint32_t reserved;
} medax_figure_parts;

/**
 * Which features of a file make up a figure, and what becomes of crossings.
 */
typedef struct {
    /**
     * The size of this struct in the caller's program.
     */
    size_t struct_size;
    /**
     * The features of which the `id`, or one of the properties `name`, `NAME`, `glyph` and `id`, is this text, or a number written so;
     * UTF-8. NULL, the default: any name.
     */
    const char *feature_name;
    /**
     * The number of a feature, from 0; `MEDAX_NONE`, the default, for any number. Not together with a name.
     */
    uint32_t feature_number;
    /**
     * A #medax_crossings.
     */
    uint32_t crossings;
} medax_figure_read_options;

/**
 * What was changed and accepted when a figure was made. The caller sets `struct_size`, the library the rest.
 */
typedef struct {
    /**
     * The size of this struct in the caller's program.
     */
    size_t struct_size;
    /**
     * Rings whose last vertex repeated the first one, and was dropped.
     */
    uint64_t closing_vertices;
    /**
     * Vertices at the place of the one before, which were dropped.
     */
    uint64_t repeated_vertices;
    /**
     * Rings that turned the wrong way, and were turned.
     */
    uint64_t turned_rings;
    /**
     * Pairs of edges or circles that cross or touch. 0 unless crossings were accepted.
     */
    uint64_t crossings;
    /**
     * Rings and circles in a place where `MEDAX_CROSSINGS_REFUSE` does not have them. 0 unless crossings were accepted, and 0
     * where anything crosses.
     */
    uint64_t misplaced;
} medax_normalised;

/**
 * Sets figure parts to nothing.
 *
 * \param parts The caller's struct, of `struct_size` bytes.
 * \param struct_size `sizeof *parts`.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_status medax_figure_parts_init(medax_figure_parts *parts, size_t struct_size);

/**
 * Makes a figure of the caller's arrays, which are copied.
 *
 * Vertices that repeat the one before are dropped, and so is the last one of a ring if it is the first again; rings are turned; -0
 * becomes 0. Collinear vertices stay. Edges, of rings and polylines alike, and circles may have no point in common but the vertex between two
 * edges of a chain and the ends that polylines share; holes must lie in their outer ring and in no other hole, and no polygon or disc in
 * another, though in its hole it may; unless `crossings` accepts all that. Points may lie anywhere.
 *
 * \param parts The arrays.
 * \param job NULL for a default job.
 * \param out_figure Receives the figure, which the caller frees with #medax_figure_free.
 * \return `MEDAX_STATUS_OK`; with the ring, counted over all polygons, the polyline, the row of the point, or the circle: `NON_FINITE`,
 *         `COORDINATE_RANGE`, `TOO_FEW_POINTS` for a ring of fewer than three distinct vertices or a polyline of fewer than
 *         two, `DEGENERATE` for a ring on a line, `INVALID_ARGUMENT` for what crosses, touches or lies in the wrong place, and for a
 *         radius that is not greater than 0; `TOO_FEW_POINTS` for a figure without anything; `MISMATCH` for offsets that
 *         do not end with their count, `INVALID_ARGUMENT` for others that make no sense; `LIMIT_EXCEEDED` past 2^32 - 2
 *         vertices and circles; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(n log n + b) with b pairs of edges whose boxes meet. Since 0.1.
 */
MEDAX_API
medax_status medax_figure_create(const medax_figure_parts *parts,
                                 const medax_job *job,
                                 const medax_figure **out_figure);

/**
 * Sets the options for reading figures to their defaults: all features, crossings refused.
 *
 * \param options The caller's struct, of `struct_size` bytes.
 * \param struct_size `sizeof *options`.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_status medax_figure_read_options_init(medax_figure_read_options *options,
                                            size_t struct_size);

/**
 * Reads a figure from a GeoJSON file: polygons, lines as open polylines, points, and points of a feature with a property `radius`
 * greater than 0 as circles.
 *
 * \param path_utf8 The path.
 * \param options NULL for the defaults.
 * \param job NULL for a default job.
 * \param out_figure Receives the figure, which the caller frees with #medax_figure_free.
 * \return `MEDAX_STATUS_OK`; `FORMAT` with the line where the file is malformed; `INVALID_ARGUMENT` where no feature has the name or
 *         number; `UNSUPPORTED` for another ending than `.geojson`; `IO`; and as #medax_figure_create, rings being
 *         counted over the chosen features.
 *
 * O(size of the file), and as #medax_figure_create. Since 0.1.
 */
MEDAX_API
medax_status medax_figure_read(const char *path_utf8,
                               const medax_figure_read_options *options,
                               const medax_job *job,
                               const medax_figure **out_figure);

/**
 * The vertices of a figure, chain by chain.
 *
 * \param figure The figure, or NULL.
 * \return v x 2 coordinates, in input units. Borrowed from `figure`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_f64 medax_figure_vertices(const medax_figure *figure);

/**
 * The chains of a figure.
 *
 * \param figure The figure, or NULL.
 * \return One row a chain: its vertices, numbers in succession. Borrowed from `figure`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_rows medax_figure_chains(const medax_figure *figure);

/**
 * What each chain of a figure is.
 *
 * \param figure The figure, or NULL.
 * \return One row a chain: a #medax_chain_kind. Borrowed from `figure`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_u32 medax_figure_kinds(const medax_figure *figure);

/**
 * The part of each chain of a figure: a polygon, a polyline or a point.
 *
 * \param figure The figure, or NULL.
 * \return One row a chain: a part, ascending. Borrowed from `figure`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_u32 medax_figure_parts_of_chains(const medax_figure *figure);

/**
 * The circles of a figure. Circle `i` of c is the part #medax_figure_part_count - c + i.
 *
 * \param figure The figure, or NULL.
 * \return c x 3: the centre's coordinates and the radius. Borrowed from `figure`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_f64 medax_figure_circles(const medax_figure *figure);

/**
 * The number of parts of a figure: polygons, polylines, points and circles.
 *
 * \param figure The figure; NULL has none.
 * \return The number of parts.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API size_t medax_figure_part_count(const medax_figure *figure);

/**
 * The smallest box round a figure, discs included; that of a disc is rounded outward.
 *
 * \param figure The figure.
 * \param out_min Receives the two least coordinates.
 * \param out_max Receives the two greatest coordinates.
 * \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_status medax_figure_bounds(const medax_figure *figure,
                                 double *out_min,
                                 double *out_max);

/**
 * Tells what was changed and accepted when a figure was made.
 *
 * \param figure The figure.
 * \param out_report Receives the counts; its `struct_size` must be set.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_status medax_figure_normalised(const medax_figure *figure,
                                     medax_normalised *out_report);

/**
 * Checks every invariant of a figure: its arrays, the turns of its rings, crossings, and where rings and circles lie.
 *
 * \param figure The figure.
 * \param job NULL for a default job.
 * \param out_report Receives the findings; its `struct_size` must be set.
 * \return `MEDAX_STATUS_OK`, also where a problem was found; `NULL_ARGUMENT`, `INVALID_ARGUMENT`, `CANCELLED`, `BUSY`,
 *         `OUT_OF_MEMORY`.
 *
 * O(n log n + b + r n) with b pairs of edges side by side and r rings and circles. Since 0.1.
 */
MEDAX_API
medax_status medax_figure_validate(const medax_figure *figure,
                                   const medax_job *job,
                                   medax_validation *out_report);

/**
 * One more reference to a figure.
 *
 * \param figure The figure, or NULL.
 * \return The same pointer; the caller frees it once more.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API const medax_figure *medax_figure_clone(const medax_figure *figure);

/**
 * Gives one reference to a figure back; the last one frees it.
 *
 * \param figure The figure; NULL does nothing.
 *
 * Since 0.1.
 */
MEDAX_API void medax_figure_free(const medax_figure *figure);

/* ---- 28. Topology -----------------------------------------------------------------------------
 *
 * What a complex is as a set of elements that share others, told from its indices alone: vertices
 * that merely lie at the same place are different vertices. And what its coordinates make of that: measures, triangles that intersect.
 */

/**
 * The topology of a complex. The caller sets `struct_size`, the library the rest.
 *
 * What is listed twice counts once. An edge is a pair of vertices: a side of a face, of a facet of a
 * volume cell, or a loose edge. Fields from `boundary_edges` to `oriented` tell about the
 * surface: the listed faces, without facets that belong to volume cells only.
 */
typedef struct {
    /**
     * The size of this struct in the caller's program.
     */
    size_t struct_size;
    /**
     * The number of vertices, isolated ones included.
     */
    uint64_t vertices;
    /**
     * The number of vertices that no face, edge or cell uses.
     */
    uint64_t isolated_vertices;
    /**
     * The number of distinct edges.
     */
    uint64_t edges;
    /**
     * The number of distinct faces, facets of volume cells included.
     */
    uint64_t faces;
    /**
     * The number of distinct volume cells.
     */
    uint64_t cells;
    /**
     * The number of connected components, isolated vertices included.
     */
    uint64_t components;
    /**
     * `vertices - edges + faces - cells`.
     */
    int64_t euler_characteristic;
    /**
     * The number of edges on exactly one side of a face.
     */
    uint64_t boundary_edges;
    /**
     * The number of curves that the boundary edges form.
     */
    uint64_t boundary_loops;
    /**
     * The number of edges on more than two sides of faces.
     */
    uint64_t nonmanifold_edges;
    /**
     * The number of vertices at which the faces are neither a disk nor a half disk.
     */
    uint64_t nonmanifold_vertices;
    /**
     * The genus, summed over the components; 0 unless `has_genus`.
     */
    uint64_t genus;
    /**
     * The Betti numbers b0, b1, b2 over Z/2 of all of the complex, cells included.
     */
    uint64_t betti[3];
    /**
     * 1 if the complex is an orientable manifold surface, so that it has a genus.
     */
    uint32_t has_genus;
    /**
     * 1 if there is a face, and every edge lies on an even number of sides.
     */
    uint32_t closed;
    /**
     * 1 if there is a face, and every edge but those of the boundary is run by its faces equally
     * often both ways.
     */
    uint32_t oriented;
    /**
     * 0.
     */
    uint32_t reserved;
} medax_topology;

/**
 * The topology of a complex.
 *
 * \param complex The complex.
 * \param job NULL for a default job.
 * \param out_report Filled, its `struct_size` being set.
 * \return `MEDAX_STATUS_OK`; `LIMIT_EXCEEDED` past 2^31 - 1 sides of faces and facets;
 *         `NULL_ARGUMENT`, `INVALID_ARGUMENT` for a report of no version, `CANCELLED`, `BUSY`,
 *         `OUT_OF_MEMORY`.
 *
 * Close to linear, unless many sheets of faces meet along seams. Since 0.1.
 */
MEDAX_API
medax_status medax_complex_topology(const medax_complex *complex,
                                    const medax_job *job,
                                    medax_topology *out_report);

/**
 * The area of the faces and the volume that they enclose.
 *
 * \param complex The complex.
 * \param job NULL for a default job.
 * \param out_area Receives the area in squared input units; or NULL.
 * \param out_volume Receives the volume in cubed input units: positive where faces point out, and with
 *        a meaning for closed, oriented surfaces only; or NULL.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(n). Since 0.1.
 */
MEDAX_API
medax_status medax_complex_measure(const medax_complex *complex,
                                   const medax_job *job,
                                   double *out_area,
                                   double *out_volume);

/**
 * The pairs of triangles of a complex that intersect, decided exactly.
 *
 * Two triangles of #medax_complex_triangles intersect if they have a point in common that is on no vertex and no edge that
 * they share, that is, that has the same vertex numbers. A triangle without area is a segment or a point.
 *
 * \param complex The complex.
 * \param job NULL for a default job.
 * \param out_intersections Receives the intersections, which the caller frees with #medax_intersections_free.
 * \return `MEDAX_STATUS_OK`, also where there are none; `COORDINATE_RANGE` with a triangle's vertex that has a coordinate outside
 *         2^-160 to 2^200; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(n log n + b) with b pairs of triangles whose boxes meet. Since 0.1.
 */
MEDAX_API
medax_status medax_complex_self_intersections(const medax_complex *complex,
                                              const medax_job *job,
                                              const medax_intersections **out_intersections);

/**
 * The pairs of triangles that intersect.
 *
 * \param intersections The intersections, or NULL.
 * \return i x 2 numbers of triangles, the less one first; pairs ascend. Borrowed from `intersections`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_view_u32 medax_intersections_pairs(const medax_intersections *intersections);

/**
 * One more reference to intersections.
 *
 * \param intersections The intersections, or NULL.
 * \return The same pointer; the caller frees it once more.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
const medax_intersections *medax_intersections_clone(const medax_intersections *intersections);

/**
 * Gives one reference to intersections back; the last one frees them.
 *
 * \param intersections The intersections; NULL does nothing.
 *
 * Since 0.1.
 */
MEDAX_API void medax_intersections_free(const medax_intersections *intersections);

/**
 * The same complex with its faces turned so that neighbours agree and solids are inside; shells
 * of voids point into the void. A turned face keeps its first vertex; attributes stay.
 *
 * \param complex The complex.
 * \param job NULL for a default job.
 * \param out_oriented Receives the new complex, which the caller frees with #medax_complex_free.
 * \return `MEDAX_STATUS_OK`; `LIMIT_EXCEEDED` past 2^31 - 1 sides of faces and facets;
 *         `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(n log n). Since 0.1.
 */
MEDAX_API
medax_status medax_complex_orient(const medax_complex *complex,
                                  const medax_job *job,
                                  const medax_complex **out_oriented);

/**
 * Checks a complex: indices, rings, finite coordinates, triangles, attributes.
 *
 * \param complex The complex.
 * \param job NULL for a default job.
 * \param out_report Filled, its `struct_size` being set.
 * \return `MEDAX_STATUS_OK` whatever was found; `NULL_ARGUMENT`, `INVALID_ARGUMENT` for a report
 *         of no version, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(n). Since 0.1.
 */
MEDAX_API
medax_status medax_complex_validate(const medax_complex *complex,
                                    const medax_job *job,
                                    medax_validation *out_report);

/* ---- 29. Winding numbers ----------------------------------------------------------------------
 *
 * How often the faces of a complex wind round a point: 1 inside a closed surface whose faces point out, 0 outside of it.
 * (Jacobson, Kavan, Sorkine-Hornung 2013, Robust inside-outside segmentation using generalized winding numbers.)
 */

/**
 * The generalised winding number of the faces round points: the solid angle of #medax_complex_triangles seen from there, by 4 pi.
 *
 * Inside a closed surface it is 1, outside 0; -1 inside one that is turned inside out, 0 in a void whose faces point into it, 2 where two shells
 * overlap. Near a hole or a seam it lies in between, and on a face it is the mean of both sides. Triangles that are far away count together: on
 * the meshes that were measured that is off by 0.002 at most.
 *
 * \param complex The complex.
 * \param query_xyz `query_count` x 3 coordinates; NULL only if `query_count` is 0.
 * \param query_count The number of points.
 * \param job NULL for a default job.
 * \param out_numbers Receives `query_count` winding numbers; the caller's buffer, NULL only if `query_count` is 0.
 * \return `MEDAX_STATUS_OK`; `NON_FINITE` with the row of a query; `INVALID_ARGUMENT` for a complex without faces;
 *         `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(n log n) for n triangles, and then about O(log n) a query. Since 0.1.
 */
MEDAX_API
medax_status medax_complex_winding_numbers(const medax_complex *complex,
                                           const double *query_xyz,
                                           size_t query_count,
                                           const medax_job *job,
                                           double *out_numbers);

/* ---- 30. Normals ------------------------------------------------------------------------------
 *
 * The normals of a surface at its vertices.
 */

/**
 * The normals of the surface at the vertices of a complex, those of its discrete mean curvature, turned as the faces turn: outward
 * if the faces point out. (Meyer, Desbrun, Schroeder, Barr 2003, Discrete differential-geometry operators for triangulated
 * 2-manifolds.)
 *
 * Where the surface is flat, so that it has no curvature, or the two differ by more than 60 degrees, the mean of the triangles'
 * normals weighted by their angles. What only the rounding of coordinates makes counts for next to nothing: a mesh that is rotated
 * about the origin has the rotated normals, but for about 10^-6.
 *
 * \param complex The complex.
 * \param job NULL for a default job.
 * \param vertex_count The number of vertices of the complex, for which `out_normals` has room.
 * \param out_normals Receives `vertex_count` x 3 coordinates: vectors of length 1, and of length 0 for a vertex without a face
 *        that has an area; the caller's buffer, NULL only if `vertex_count` is 0.
 * \return `MEDAX_STATUS_OK`; `MISMATCH` unless `vertex_count` is the number of vertices; `NULL_ARGUMENT`, `INVALID_ARGUMENT`,
 *         `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(n). Since 0.1.
 */
MEDAX_API
medax_status medax_complex_vertex_normals(const medax_complex *complex,
                                          const medax_job *job,
                                          size_t vertex_count,
                                          double *out_normals);

/* ---- 31. Comparison ---------------------------------------------------------------------------
 *
 * How far two complexes are apart as sets of points: their faces, loose edges and cells, which are
 * solid; or their vertices, where they have none of these.
 */

/**
 * The settings of a comparison.
 */
typedef struct {
    /**
     * The size of this struct in the caller's program.
     */
    size_t struct_size;
    /**
     * The number of samples on each side, 100000 by default. With 0 the vertices serve.
     */
    uint64_t samples;
    /**
     * Chooses the samples, 0 by default. The same seed gives the same samples everywhere.
     */
    uint64_t seed;
} medax_compare_options;

/**
 * Distances in input units. The caller sets `struct_size`, the library the rest.
 */
typedef struct {
    /**
     * The size of this struct in the caller's program.
     */
    size_t struct_size;
    /**
     * The largest distance from vertices and samples of `a` to `b`: the one-sided Hausdorff distance,
     * or a little less.
     */
    double a_to_b_max;
    /**
     * The mean distance from samples of `a` to `b`.
     */
    double a_to_b_mean;
    /**
     * The root of the mean squared distance from samples of `a` to `b`.
     */
    double a_to_b_rms;
    /**
     * As `a_to_b_max`, the other way.
     */
    double b_to_a_max;
    /**
     * As `a_to_b_mean`, the other way.
     */
    double b_to_a_mean;
    /**
     * As `a_to_b_rms`, the other way.
     */
    double b_to_a_rms;
    /**
     * The diagonal of the smallest axis-parallel box that holds both.
     */
    double diagonal;
} medax_comparison;

/**
 * Sets compare options to their defaults.
 *
 * \param options The caller's struct, of `struct_size` bytes.
 * \param struct_size `sizeof *options`.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_status medax_compare_options_init(medax_compare_options *options,
                                        size_t struct_size);

/**
 * The distances between two complexes.
 *
 * \param a The one complex.
 * \param b The other one, which may be the same.
 * \param options NULL for the defaults.
 * \param job NULL for a default job.
 * \param out_report Filled, its `struct_size` being set.
 * \return `MEDAX_STATUS_OK`; `TOO_FEW_POINTS` when a side has no vertex; `COORDINATE_RANGE` when a
 *         distance is past the range of a double; `NULL_ARGUMENT`, `INVALID_ARGUMENT`,
 *         `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O((n + samples) log n). Since 0.1.
 */
MEDAX_API
medax_status medax_complex_compare(const medax_complex *a,
                                   const medax_complex *b,
                                   const medax_compare_options *options,
                                   const medax_job *job,
                                   medax_comparison *out_report);

/* ---- 32. Decimation ---------------------------------------------------------------------------
 *
 * Fewer triangles for the same surface.
 */

/**
 * The settings of a decimation.
 */
typedef struct {
    /**
     * The size of this struct in the caller's program.
     */
    size_t struct_size;
    /**
     * The number of triangles to come down to; 0, the default: as few as can be.
     */
    uint64_t triangles;
    /**
     * The greatest distance, in input units, that the surface may come away from what it was; infinity, the
     * default: any. With it the aim may be missed.
     */
    double max_error;
} medax_decimate_options;

/**
 * Sets decimate options to their defaults.
 *
 * \param options The caller's struct, of `struct_size` bytes.
 * \param struct_size `sizeof *options`.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_status medax_decimate_options_init(medax_decimate_options *options,
                                         size_t struct_size);

/**
 * The same surface with fewer triangles: edges are contracted, the one of the least quadric error first.
 *
 * Components, genus, boundary loops and orientation stay. Vertices on loose edges, on cells, on edges of
 * more than two triangles, or of several fans stay as they are. Loose edges, cells and their attributes
 * stay; attributes of vertices and faces are left out.
 *
 * \param complex The complex; its faces become triangles first.
 * \param options NULL for the defaults.
 * \param job NULL for a default job.
 * \param out_decimated Receives the new complex, which the caller frees with #medax_complex_free.
 * \return `MEDAX_STATUS_OK`, also where the aim was missed; `INVALID_ARGUMENT` for a `max_error` that is
 *         negative or NaN; `NULL_ARGUMENT`, `LIMIT_EXCEEDED`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(n log n). Since 0.1.
 */
MEDAX_API
medax_status medax_complex_decimate(const medax_complex *complex,
                                    const medax_decimate_options *options,
                                    const medax_job *job,
                                    const medax_complex **out_decimated);

/* ---- 33. Flattening ---------------------------------------------------------------------------
 *
 * Power shapes have tetrahedra, most of them flat: these collapse to their triangles, and the homotopy type stays.
 */

/**
 * Which tetrahedra are flat.
 */
typedef struct {
    /**
     * The size of this struct in the caller's program.
     */
    size_t struct_size;
    /**
     * Those whose least altitude is at most this share of their longest edge, 0.1 by default: of a regular tetrahedron it is 0.816.
     * Infinity stands for all.
     */
    double flatness;
} medax_flatten_options;

/**
 * Sets flatten options to their defaults.
 *
 * \param options The caller's struct, of `struct_size` bytes.
 * \param struct_size `sizeof *options`.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_status medax_flatten_options_init(medax_flatten_options *options,
                                        size_t struct_size);

/**
 * Collapses flat tetrahedra to their triangles, without changing the homotopy type.
 *
 * A tetrahedron goes together with a triangle that bounds no other cell; its other three triangles stay, no edge and no vertex goes.
 * That is done as long as there is a flat tetrahedron with such a triangle. At each step no point that goes is farther from what stays than
 * the altitude over that triangle; the least altitude goes first. Attributes stay.
 *
 * \param complex The complex, such as a power shape.
 * \param options NULL for the defaults.
 * \param job NULL for a default job.
 * \param out_flattened Receives the result, which the caller frees with #medax_flattened_free.
 * \return `MEDAX_STATUS_OK`, also where flat tetrahedra are left; `INVALID_ARGUMENT` for a flatness that is negative or NaN;
 *         `NULL_ARGUMENT`, `LIMIT_EXCEEDED`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(n log n). Since 0.1.
 */
MEDAX_API
medax_status medax_complex_flatten(const medax_complex *complex,
                                   const medax_flatten_options *options,
                                   const medax_job *job,
                                   const medax_flattened **out_flattened);

/**
 * The complex that is left.
 *
 * \param flattened The result.
 * \param out_complex Receives the complex, which the caller frees with #medax_complex_free.
 * \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_status medax_flattened_complex(const medax_flattened *flattened,
                                     const medax_complex **out_complex);

/**
 * The tetrahedra that went, in order.
 *
 * \param flattened The result, or NULL.
 * \return Rows of two: a tetrahedron's number among the cells of the given complex, and its vertex opposite the triangle that went with it.
 *         Borrowed from `flattened`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_view_u32 medax_flattened_collapses(const medax_flattened *flattened);

/**
 * The number of flat tetrahedra that could not go, as each of their triangles bounds another cell.
 *
 * \param flattened The result; NULL has none.
 * \return The number of tetrahedra.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API size_t medax_flattened_left_count(const medax_flattened *flattened);

/**
 * One more reference to the result of a flattening.
 *
 * \param flattened The result, or NULL.
 * \return The same pointer; the caller frees it once more.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API const medax_flattened *medax_flattened_clone(const medax_flattened *flattened);

/**
 * Gives one reference to the result of a flattening back; the last one frees it.
 *
 * \param flattened The result; NULL does nothing.
 *
 * Since 0.1.
 */
MEDAX_API void medax_flattened_free(const medax_flattened *flattened);

/* ---- 34. Sites --------------------------------------------------------------------------------
 *
 * What distances are measured to: a boundary, as pieces that belong to sites. A #medax_sites holds points, segments, rays, lines, in the
 * plane circles, in space triangles and spheres; it is made of a plane figure, of a mesh or polygon soup, or of the pieces themselves, and
 * knows what is inside.
 *
 * In the plane, dimension 2, every z is 0. Pieces are numbered from 0, sites by the caller.
 */

/**
 * What a piece is.
 */
enum medax_piece_kind
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
    /**
     * A point: 3 numbers.
     */
    MEDAX_PIECE_KIND_POINT = 0,
    /**
     * The points between two ends, one point if these are equal: 2 x 3 numbers.
     */
    MEDAX_PIECE_KIND_SEGMENT = 1,
    /**
     * An origin, and the way into which all else lies, of any length but 0: 2 x 3 numbers.
     */
    MEDAX_PIECE_KIND_RAY = 2,
    /**
     * A point of it, and its direction, of any length but 0: 2 x 3 numbers.
     */
    MEDAX_PIECE_KIND_LINE = 3,
    /**
     * Three corners, in space only; one without area is its longest side: 3 x 3 numbers.
     */
    MEDAX_PIECE_KIND_TRIANGLE = 4,
    /**
     * The centre, and the radius, which is positive: 4 numbers. A circle in the plane. The surface alone, not the ball.
     */
    MEDAX_PIECE_KIND_SPHERE = 5,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum medax_piece_kind medax_piece_kind;
#else
typedef uint32_t medax_piece_kind;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

/**
 * A piece of a boundary, and the site to which it belongs.
 */
typedef struct {
    /**
     * A #medax_piece_kind.
     */
    uint32_t kind;
    /**
     * The number of its site, anything but `MEDAX_NONE`.
     */
    uint32_t site;
    /**
     * Coordinates, in input units, as the kind has them. Those behind them are not looked at, and come out as 0.
     */
    double numbers[9];
} medax_piece;

/**
 * Makes sites of the caller's pieces, which are copied.
 *
 * \param dimension 2 in the plane, 3 in space.
 * \param pieces `piece_count` pieces.
 * \param piece_count The number of pieces, at least 1.
 * \param is_closed In the plane `flag_count` flags, one for each piece: 1 for one of a closed curve, 0 for any other; a point is inside
 *        where a ray from it crosses these an odd number of times. NULL only if `flag_count` is 0. Copied.
 * \param flag_count The number of flags; 0 for none, so that all is outside.
 * \param job NULL for a default job.
 * \param out_sites Receives the sites, which the caller frees with #medax_sites_free.
 * \return `MEDAX_STATUS_OK`; with the row of a piece: `NON_FINITE`, `COORDINATE_RANGE` beyond 2^200, and `INVALID_ARGUMENT` for a kind, a
 *         site, a direction or a radius without meaning, for what does not lie in the plane, and for a flag that is neither 0 nor 1;
 *         `INVALID_ARGUMENT` for another dimension, no pieces, and flags in space; `MISMATCH` unless each piece has a flag;
 *         `LIMIT_EXCEEDED` past 2^31 - 1 pieces; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(n log n). Since 0.1.
 */
MEDAX_API
medax_status medax_sites_create(uint32_t dimension,
                                const medax_piece *pieces,
                                size_t piece_count,
                                const uint8_t *is_closed,
                                size_t flag_count,
                                const medax_job *job,
                                const medax_sites **out_sites);

/**
 * The curves and points of a plane figure. Each part is a site; rings and circles are closed, so that the inside is that of the figure.
 *
 * Pieces are the points and the edges, chain by chain, then the circles. Edges are segments.
 *
 * \param figure The figure.
 * \param job NULL for a default job.
 * \param out_sites Receives the sites, which the caller frees with #medax_sites_free.
 * \return `MEDAX_STATUS_OK`; `LIMIT_EXCEEDED` past 2^31 - 1 pieces; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(n log n). Since 0.1.
 */
MEDAX_API
medax_status medax_sites_of_figure(const medax_figure *figure,
                                   const medax_job *job,
                                   const medax_sites **out_sites);

/**
 * A mesh, open or closed, or polygon soup: one site, number 0.
 *
 * Pieces are the triangles of #medax_complex_triangles, then the loose edges as segments, then the vertices that neither uses as points.
 * With triangles the sites lie in space, and inside is where the faces wind round a point more than half a time; without, they have the
 * dimension of the complex.
 *
 * \param complex The complex, which the sites keep alive.
 * \param is_closed In the plane `flag_count` flags, one for each piece, as for #medax_sites_create; NULL only if `flag_count` is 0.
 *        Copied.
 * \param flag_count The number of flags; 0 for none.
 * \param job NULL for a default job.
 * \param out_sites Receives the sites, which the caller frees with #medax_sites_free.
 * \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` for a complex without vertices, for flags in space, and with its row for a flag that is
 *         neither 0 nor 1; `MISMATCH` unless each piece has a flag; `COORDINATE_RANGE` with the row of a piece; `LIMIT_EXCEEDED` past 2^31
 *         - 1 pieces; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(n log n). Since 0.1.
 */
MEDAX_API
medax_status medax_sites_of_complex(const medax_complex *complex,
                                    const uint8_t *is_closed,
                                    size_t flag_count,
                                    const medax_job *job,
                                    const medax_sites **out_sites);

/**
 * The pieces of a mesh or polygon soup as #medax_sites_of_complex has them, each connected component a site: what faces and edges join by
 * common vertices, whose coordinates count for nothing. Both shells of a hollow solid are sites.
 *
 * \param complex The complex, which the sites keep alive.
 * \param is_closed In the plane `flag_count` flags, one for each piece, as for #medax_sites_create; NULL only if `flag_count` is 0.
 *        Copied.
 * \param flag_count The number of flags; 0 for none.
 * \param job NULL for a default job.
 * \param out_sites Receives the sites, numbered by their least vertices, which the caller frees with #medax_sites_free.
 * \return As #medax_sites_of_complex.
 *
 * O(n log n). Since 0.1.
 */
MEDAX_API
medax_status medax_sites_of_components(const medax_complex *complex,
                                       const uint8_t *is_closed,
                                       size_t flag_count,
                                       const medax_job *job,
                                       const medax_sites **out_sites);

/**
 * The dimension of sites.
 *
 * \param sites The sites; NULL has 0.
 * \return 2 in the plane, else 3.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API uint32_t medax_sites_dimension(const medax_sites *sites);

/**
 * The number of pieces.
 *
 * \param sites The sites; NULL has none.
 * \return The number of pieces.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API size_t medax_sites_piece_count(const medax_sites *sites);

/**
 * Some pieces, as they were given or found.
 *
 * \param sites The sites.
 * \param first The first of them.
 * \param count How many.
 * \param out_pieces Receives `count` pieces; the caller's buffer, NULL only if `count` is 0.
 * \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` past the last piece; `NULL_ARGUMENT`.
 *
 * O(count). Since 0.1.
 */
MEDAX_API
medax_status medax_sites_pieces(const medax_sites *sites,
                                size_t first,
                                size_t count,
                                medax_piece *out_pieces);

/**
 * The site of each piece.
 *
 * \param sites The sites, or NULL.
 * \return One row a piece: a site. Borrowed from `sites`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_u32 medax_sites_site_of_piece(const medax_sites *sites);

/**
 * The number of sites: one more than the largest number.
 *
 * \param sites The sites; NULL has none.
 * \return The number of sites.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API size_t medax_sites_site_count(const medax_sites *sites);

/**
 * The smallest box round the bounded pieces.
 *
 * \param sites The sites.
 * \param out_min Receives the three least coordinates.
 * \param out_max Receives the three greatest coordinates.
 * \return `MEDAX_STATUS_OK`; `DEGENERATE` if all pieces are rays and lines; `NULL_ARGUMENT`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_status medax_sites_bounds(const medax_sites *sites,
                                double *out_min,
                                double *out_max);

/**
 * The diagonal of that box, of which defaults of densities and tolerances are shares.
 *
 * \param sites The sites; NULL has 0.
 * \return A length in input units, 1 where there is no box, or it is a point.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API double medax_sites_size(const medax_sites *sites);

/**
 * One more reference to sites.
 *
 * \param sites The sites, or NULL.
 * \return The same pointer; the caller frees it once more.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API const medax_sites *medax_sites_clone(const medax_sites *sites);

/**
 * Gives one reference to sites back; the last one frees them.
 *
 * \param sites The sites; NULL does nothing.
 *
 * Since 0.1.
 */
MEDAX_API void medax_sites_free(const medax_sites *sites);

/* ---- 35. Distance -----------------------------------------------------------------------------
 *
 * What of some sites is nearest to points, all that is as near, and whether points lie inside.
 */

/**
 * What is nearest to a point.
 */
typedef struct {
    /**
     * The nearest point of the boundary.
     */
    double point[3];
    /**
     * How far away it is, in input units.
     */
    double distance;
    /**
     * The way there, of length 1; 0 from a point of the boundary. The gradient of the negative distance, where it has one.
     */
    double direction[3];
    /**
     * The piece whose point it is, of several the least.
     */
    uint32_t piece;
    /**
     * The site of that piece.
     */
    uint32_t site;
} medax_nearest;

/**
 * What is nearest to each of some points.
 *
 * \param sites The sites.
 * \param query_xyz `query_count` x 3 coordinates, z in the plane as well; NULL only if `query_count` is 0.
 * \param query_count The number of points.
 * \param job NULL for a default job.
 * \param out_nearest Receives `query_count` answers; the caller's buffer, NULL only if `query_count` is 0.
 * \return `MEDAX_STATUS_OK`; `NON_FINITE`, or `COORDINATE_RANGE` beyond 2^200, with the row of a query;
 *         `NULL_ARGUMENT`, `INVALID_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * About O(log n) a query. Since 0.1.
 */
MEDAX_API
medax_status medax_sites_nearest(const medax_sites *sites,
                                 const double *query_xyz,
                                 size_t query_count,
                                 const medax_job *job,
                                 medax_nearest *out_nearest);

/**
 * Whether each of some points lies inside: in the plane where a ray from there crosses closed curves an odd number of times, decided
 * exactly; in space where the faces of the mesh wind round it more than half a time. Nothing lies inside of anything else.
 *
 * \param sites The sites.
 * \param query_xyz `query_count` x 3 coordinates, z in the plane as well; NULL only if `query_count` is 0.
 * \param query_count The number of points.
 * \param job NULL for a default job.
 * \param out_is_inside Receives `query_count` flags, 0 or 1; the caller's buffer, NULL only if `query_count` is 0.
 * \return `MEDAX_STATUS_OK`; `NON_FINITE`, or `COORDINATE_RANGE` beyond 2^200, with the row of a query;
 *         `NULL_ARGUMENT`, `INVALID_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * About O(log n) a query, and O(n log n) once a call for a mesh. Since 0.1.
 */
MEDAX_API
medax_status medax_sites_is_inside(const medax_sites *sites,
                                   const double *query_xyz,
                                   size_t query_count,
                                   const medax_job *job,
                                   uint8_t *out_is_inside);

/**
 * All nearest points of the boundary, for each of some points: those of all pieces that are no farther away than the nearest one is and a
 * tolerance.
 *
 * \param sites The sites.
 * \param query_xyz `query_count` x 3 coordinates, z in the plane as well; NULL only if `query_count` is 0.
 * \param query_count The number of points.
 * \param tolerance A length in input units, not negative.
 * \param job NULL for a default job.
 * \param out_all_nearest Receives the answers, which the caller frees with #medax_all_nearest_free.
 * \return `MEDAX_STATUS_OK`; `NON_FINITE`, or `COORDINATE_RANGE` beyond 2^200, with the row of a query; `INVALID_ARGUMENT` for a tolerance
 *         that is negative or NaN; `LIMIT_EXCEEDED` past 2^32 - 1 nearest points in all; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`,
 *         `OUT_OF_MEMORY`.
 *
 * About O(log n + size) a query. Since 0.1.
 */
MEDAX_API
medax_status medax_sites_all_nearest(const medax_sites *sites,
                                     const double *query_xyz,
                                     size_t query_count,
                                     double tolerance,
                                     const medax_job *job,
                                     const medax_all_nearest **out_all_nearest);

/**
 * The pieces whose points are nearest to each query.
 *
 * \param all_nearest The answers, or NULL.
 * \return One row a query: pieces, which ascend. All other arrays have a row for each of these, one query's after the other's. Borrowed
 *         from `all_nearest`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_view_rows medax_all_nearest_pieces(const medax_all_nearest *all_nearest);

/**
 * The sites of these pieces.
 *
 * \param all_nearest The answers, or NULL.
 * \return m x 1 sites. Borrowed from `all_nearest`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_u32 medax_all_nearest_sites(const medax_all_nearest *all_nearest);

/**
 * The nearest points.
 *
 * \param all_nearest The answers, or NULL.
 * \return m x 3 coordinates. Borrowed from `all_nearest`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_f64 medax_all_nearest_points(const medax_all_nearest *all_nearest);

/**
 * The distances of the nearest points.
 *
 * \param all_nearest The answers, or NULL.
 * \return m x 1, in input units. Borrowed from `all_nearest`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_f64 medax_all_nearest_distances(const medax_all_nearest *all_nearest);

/**
 * The ways to the nearest points.
 *
 * \param all_nearest The answers, or NULL.
 * \return m x 3 coordinates: vectors of length 1, and of length 0 from a point of the boundary. Borrowed from `all_nearest`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_view_f64 medax_all_nearest_directions(const medax_all_nearest *all_nearest);

/**
 * One more reference to answers.
 *
 * \param all_nearest The answers, or NULL.
 * \return The same pointer; the caller frees it once more.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API const medax_all_nearest *medax_all_nearest_clone(const medax_all_nearest *all_nearest);

/**
 * Gives one reference to answers back; the last one frees them.
 *
 * \param all_nearest The answers; NULL does nothing.
 *
 * Since 0.1.
 */
MEDAX_API void medax_all_nearest_free(const medax_all_nearest *all_nearest);

/* ---- 36. Decisions ----------------------------------------------------------------------------
 *
 * Does a circle or a sphere hold a point of the medial axis? The gradient of the distance points away from what is nearest. Where two
 * points of a circle or sphere that no part of the boundary enters have gradients that do not go together, the medial axis passes between
 * them; how much such tests may miss in the plane is known. (Stolpner, Whitesides 2009, Medial axis approximation with bounded error.)
 */

/**
 * Which test has found a medial point.
 */
enum medax_decide_test
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
    /**
     * None: no conclusion can be drawn.
     */
    MEDAX_DECIDE_TEST_NONE = 0,
    /**
     * The gradients at a point and at its opposite differ.
     */
    MEDAX_DECIDE_TEST_OPPOSITE = 1,
    /**
     * Those at two neighbours point to different sides of the line through them. In the plane only.
     */
    MEDAX_DECIDE_TEST_SIDES = 2,
    /**
     * Between the opposites of two neighbours there are other points. In the plane only.
     */
    MEDAX_DECIDE_TEST_BETWEEN = 3,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum medax_decide_test medax_decide_test;
#else
typedef uint32_t medax_decide_test;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

/**
 * How near is near, for the search of medial points.
 */
typedef struct {
    /**
     * The size of this struct in the caller's program.
     */
    size_t struct_size;
    /**
     * Two nearest points no farther apart than this are the same, in input units. 0, the default, asks for 1e-9 of #medax_sites_size.
     */
    double tolerance;
    /**
     * How far a point that is found may be from the medial axis, in input units. 0, the default, asks for 1e-6 of that size.
     */
    double epsilon;
} medax_decide_options;

/**
 * What is known of a circle or a sphere. The caller sets `struct_size`, the library the rest.
 */
typedef struct {
    /**
     * The size of this struct in the caller's program.
     */
    size_t struct_size;
    /**
     * A medial point in the circle or sphere, in input units; 0 unless a test has found one.
     */
    double center[3];
    /**
     * Its distance from the boundary; 0 unless a test has found one.
     */
    double radius;
    /**
     * The angle between the ways to its two nearest points, in radians; 0 unless a test has found one.
     */
    double object_angle;
    /**
     * The two nearest points; 0 unless a test has found one.
     */
    double feet[6];
    /**
     * In the plane the longest arc between two neighbours of Theta, in input units; 0 in space.
     */
    double gap;
    /**
     * The number of points of Theta.
     */
    uint64_t theta_count;
    /**
     * How often a test fired of which no point came: these do not count.
     */
    uint64_t unconfirmed;
    /**
     * The pieces that have the two nearest points; `MEDAX_NONE` unless a test has found one.
     */
    uint32_t pieces[2];
    /**
     * A #medax_decide_test.
     */
    uint32_t test;
    /**
     * 0.
     */
    uint32_t reserved;
} medax_decision;

/**
 * Sets the options of decisions to their defaults.
 *
 * \param options The caller's struct, of `struct_size` bytes.
 * \param struct_size `sizeof *options`.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_status medax_decide_options_init(medax_decide_options *options, size_t struct_size);

/**
 * Whether a circle of the plane, or a sphere in space, which no part of the boundary enters, holds a point of the medial axis: DECIDEMA2D
 * and DECIDEMA3D of the paper.
 *
 * The gradient is looked at in some points of the circle or sphere, Phi, and with each of them at its opposite, the other one on the line
 * to its nearest point: together these are Theta. What is not found may be there nonetheless: in the plane #medax_largest_missed_angle
 * says how much, in space nothing is known.
 *
 * \param sites The sites.
 * \param center_xyz The 3 coordinates of the centre; in the plane z is 0.
 * \param radius The radius in input units.
 * \param directions `direction_count` x 3 coordinates: the ways from the centre to the points of Phi, of any length but 0, in the plane
 *        with z 0; such as those of #medax_sites_even_directions. NULL only if `direction_count` is 0.
 * \param direction_count The number of directions, at most 2^16.
 * \param options NULL for the defaults.
 * \param job NULL for a default job.
 * \param theta_capacity The number of points for which `out_theta` has room; twice `direction_count` is always enough.
 * \param out_theta Receives the first `theta_capacity` points of Theta, 3 coordinates each; in the plane they go round counterclockwise.
 *        The caller's buffer, NULL only if `theta_capacity` is 0.
 * \param out_decision Filled, its `struct_size` being set.
 * \return `MEDAX_STATUS_OK` whether a medial point was found or not; `INVALID_ARGUMENT` for a radius that is not greater than 0, for a
 *         circle or sphere that the boundary enters, for options that are no lengths, and with its row for a direction without length or
 *         out of the plane; `NON_FINITE` for the centre; `LIMIT_EXCEEDED` for too many directions; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`,
 *         `OUT_OF_MEMORY`.
 *
 * One or two queries for each direction, and in the plane for each at most a look at all of Theta. Since 0.1.
 */
MEDAX_API
medax_status medax_sites_decide(const medax_sites *sites,
                                const double *center_xyz,
                                double radius,
                                const double *directions,
                                size_t direction_count,
                                const medax_decide_options *options,
                                const medax_job *job,
                                size_t theta_capacity,
                                double *out_theta,
                                medax_decision *out_decision);

/**
 * Directions spread evenly, for decisions.
 *
 * In the plane they go round counterclockwise from that of x; in space they lie on a spiral from pole to pole, each the golden angle
 * further.
 *
 * \param sites The sites, whose dimension counts.
 * \param count The number of directions.
 * \param out_directions Receives `count` x 3 coordinates: vectors of length 1; the caller's buffer, NULL only if `count` is 0.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a count that no memory holds.
 *
 * O(count). Since 0.1.
 */
MEDAX_API
medax_status medax_sites_even_directions(const medax_sites *sites,
                                         size_t count,
                                         double *out_directions);

/**
 * The largest object angle of a medial point that a circle of the plane can hold unnoticed: arcsin(L / 2R) + arcsin(L / d), theorem 10 of
 * the paper.
 *
 * It holds for a circle that the boundary does not enter and in which no test found anything, and for points in the convex hull of Theta
 * of which both ways to the nearest points leave the hull at L or more from the point, and at L or more from the nearest points.
 *
 * \param gap L, the longest arc between neighbours of Theta (#medax_decision).
 * \param radius R, that of the circle.
 * \param distance d, that of the point from the boundary; the least there is, if there are many.
 * \return An angle in radians; pi where there is no claim: where L >= 2R, d < 2L, or a number makes no sense.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
double medax_largest_missed_angle(double gap,
                                  double radius,
                                  double distance);

/* ---- 37. Field axis ---------------------------------------------------------------------------
 *
 * Points of the medial axis of sites, as dense as they are asked for, read off the gradient of the distance: APPROXMA2D in the plane,
 * APPROXMA3D in space. Circles or spheres cover what is looked at, and each is asked whether it holds a medial point
 * (#medax_sites_decide); in the plane each says what it may have missed. (Stolpner, Whitesides 2009, Medial axis approximation with
 * bounded error.)
 */

/**
 * Which points of the medial axis, how dense, and how near to it.
 */
typedef struct {
    /**
     * The size of this struct in the caller's program.
     */
    size_t struct_size;
    /**
     * Within this distance of what of the medial axis is found there is a point, in input units. 0, the default, asks for a hundredth of
     * #medax_sites_size.
     */
    double density;
    /**
     * The least object angle of a point, in radians in [0, pi]; 0 by default.
     */
    double object_angle;
    /**
     * The least distance of a point from the boundary, in input units. 0, the default, asks for a quarter of the density in the plane,
     * where it bounds how fine the cover gets; in space for nothing.
     */
    double min_distance;
    /**
     * In the plane the largest object angle that a point may have and be missed, in radians in (0, pi); pi / 9 by default.
     */
    double bound;
    /**
     * Two nearest points no farther apart than this are the same, in input units. 0, the default, asks for 1e-9 of #medax_sites_size.
     */
    double tolerance;
    /**
     * How far a point may be from the medial axis, in input units. 0, the default, asks for 1e-6 of that size.
     */
    double epsilon;
    /**
     * The least corner of a box that holds what is looked at, if `has_clip` is 1. No coordinate is beyond 2^200.
     */
    double clip_min[3];
    /**
     * The largest corner of that box.
     */
    double clip_max[3];
    /**
     * 1 for that box; 0, the default, for that of the sites, if the outside is asked for as well as much larger on each side as half its
     * diagonal is long.
     */
    uint32_t has_clip;
    /**
     * A #medax_side of the boundary; `MEDAX_SIDE_INNER` by default. Where there is no inside, as for open curves, all is outside.
     */
    uint32_t side;
    /**
     * The number of points at which each circle or sphere is looked at, from 12 to 2^20. 0, the default, asks for as many as the bound
     * takes in the plane, for 60 in space.
     */
    uint32_t samples;
    /**
     * 1 to keep only what has its nearest points on two sites; 0 by default.
     */
    uint32_t between_sites;
} medax_field_axis_options;

/**
 * A circle in the plane or a sphere in space that was looked at, for the square or the cube in its middle.
 */
typedef struct {
    /**
     * The centre.
     */
    double center[3];
    /**
     * The radius, in input units.
     */
    double radius;
    /**
     * Half the side of the square or cube.
     */
    double half;
    /**
     * In the plane the longest arc between points that were looked at; 0 in space.
     */
    double gap;
    /**
     * The distance of the centre from the boundary.
     */
    double distance;
    /**
     * The claim: the largest object angle of a point of the medial axis within the square that is at least `min_distance` from the
     * boundary and has no point of the result within the density, in radians; 0 where there is such a point. Pi stands for no claim: in
     * space, and where what was found did not pass the thresholds.
     */
    double missed_angle;
    /**
     * The number of points that it gave.
     */
    uint32_t found;
    /**
     * 0.
     */
    uint32_t reserved;
} medax_cover;

/**
 * Sets the options of field axes to their defaults.
 *
 * \param options The caller's struct, of `struct_size` bytes.
 * \param struct_size `sizeof *options`.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_status medax_field_axis_options_init(medax_field_axis_options *options,
                                           size_t struct_size);

/**
 * Finds points of the medial axis.
 *
 * \param sites The sites, which the result keeps alive.
 * \param options NULL for the defaults.
 * \param job NULL for a default job.
 * \param out_axis Receives the points, which the caller frees with #medax_field_axis_free.
 * \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` for options out of range, and without a box for sites that are all rays and lines;
 *         `LIMIT_EXCEEDED` for a density of less than 2^-20 of the box, and where the density or the least
 *         distance ask for more than 2^28 circles or spheres; `NULL_ARGUMENT`,
 *         `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * In the plane O(length / least distance + area / density^2) circles, in space O(area / density^2) spheres, each some queries for each
 * sample. Since 0.1.
 */
MEDAX_API
medax_status medax_field_axis_build(const medax_sites *sites,
                                    const medax_field_axis_options *options,
                                    const medax_job *job,
                                    const medax_field_axis **out_axis);

/**
 * Finds points of the medial axis that have their nearest points on one of some pairs of sites: pieces of the Voronoi diagram of the sites.
 * Others are not looked for.
 *
 * \param sites The sites, which the result keeps alive.
 * \param pairs `pair_count` x 2 sites, either first; a site with itself for the parts of the medial axis that belong to that site alone.
 *        NULL only if `pair_count` is 0.
 * \param pair_count The number of pairs; with 0 there are no points.
 * \param options NULL for the defaults.
 * \param job NULL for a default job.
 * \param out_axis Receives the points, which the caller frees with #medax_field_axis_free.
 * \return As #medax_field_axis_build; also `INVALID_ARGUMENT` with the row of a pair that names no site.
 *
 * As #medax_field_axis_build. Since 0.1.
 */
MEDAX_API
medax_status medax_field_axis_between(const medax_sites *sites,
                                      const uint32_t *pairs,
                                      size_t pair_count,
                                      const medax_field_axis_options *options,
                                      const medax_job *job,
                                      const medax_field_axis **out_axis);

/**
 * What distances were measured to.
 *
 * \param axis The field axis.
 * \param out_sites Receives the sites, which the caller frees with #medax_sites_free.
 * \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_status medax_field_axis_sites(const medax_field_axis *axis,
                                    const medax_sites **out_sites);

/**
 * What was asked for, with numbers in place of the defaults.
 *
 * \param axis The field axis.
 * \param out_options Filled, its `struct_size` being set.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_status medax_field_axis_resolved(const medax_field_axis *axis,
                                       medax_field_axis_options *out_options);

/**
 * Where the points lie.
 *
 * \param axis The field axis, or NULL.
 * \return m x 3 coordinates. Borrowed from `axis`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_f64 medax_field_axis_points(const medax_field_axis *axis);

/**
 * The distances of the points from the boundary: the radii of the medial balls.
 *
 * \param axis The field axis, or NULL.
 * \return m x 1, in input units. Borrowed from `axis`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_f64 medax_field_axis_radii(const medax_field_axis *axis);

/**
 * The angles between the ways from the points to their nearest points.
 *
 * \param axis The field axis, or NULL.
 * \return m x 1, in radians. Borrowed from `axis`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_f64 medax_field_axis_object_angles(const medax_field_axis *axis);

/**
 * Two nearest points of the boundary for each point.
 *
 * \param axis The field axis, or NULL.
 * \return m x 6 coordinates. Borrowed from `axis`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_f64 medax_field_axis_feet(const medax_field_axis *axis);

/**
 * The pieces that have these nearest points.
 *
 * \param axis The field axis, or NULL.
 * \return m x 2 pieces. Borrowed from `axis`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_u32 medax_field_axis_pieces(const medax_field_axis *axis);

/**
 * The sites of these pieces.
 *
 * \param axis The field axis, or NULL.
 * \return m x 2 sites. Borrowed from `axis`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_u32 medax_field_axis_sites_of_points(const medax_field_axis *axis);

/**
 * The circle or sphere in which each point was found.
 *
 * \param axis The field axis, or NULL.
 * \return m x 1 covers, which ascend. Borrowed from `axis`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_u32 medax_field_axis_cover_of_point(const medax_field_axis *axis);

/**
 * The number of covers: in the plane of all circles that were looked at in the end, in space of the spheres that gave a point.
 *
 * \param axis The field axis; NULL has none.
 * \return The number of covers.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
size_t medax_field_axis_cover_count(const medax_field_axis *axis);

/**
 * Some of these circles or spheres.
 *
 * \param axis The field axis.
 * \param first The first of them.
 * \param count How many.
 * \param out_covers Receives `count` covers; the caller's buffer, NULL only if `count` is 0.
 * \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` past the last cover; `NULL_ARGUMENT`.
 *
 * O(count). Since 0.1.
 */
MEDAX_API
medax_status medax_field_axis_covers(const medax_field_axis *axis,
                                     size_t first,
                                     size_t count,
                                     medax_cover *out_covers);

/**
 * What may have been missed in all.
 *
 * \param axis The field axis.
 * \param out_angle Receives the largest object angle that a point beyond the least distance may have and be missed, in radians, where
 *        there is a claim; or NULL.
 * \param out_unclaimed Receives the number of covers that make no claim, where it may be any: in space all; or NULL.
 * \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
 *
 * O(covers). Since 0.1.
 */
MEDAX_API
medax_status medax_field_axis_claim(const medax_field_axis *axis,
                                    double *out_angle,
                                    size_t *out_unclaimed);

/**
 * How often a test fired of which no point came, as may happen where it hangs on the last bits of rounding.
 *
 * \param axis The field axis; NULL has none.
 * \return How often.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
size_t medax_field_axis_unconfirmed(const medax_field_axis *axis);

/**
 * The points as vertices, with the attributes `radius`, `object_angle`, `feet` (the two nearest points), `pieces`, `sites` (of these) and
 * `missed_angle` (that of the cover), for writing.
 *
 * \param axis The field axis.
 * \param job NULL for a default job.
 * \param out_complex Receives the complex, which the caller frees with #medax_complex_free.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(points). Since 0.1.
 */
MEDAX_API
medax_status medax_field_axis_complex(const medax_field_axis *axis,
                                      const medax_job *job,
                                      const medax_complex **out_complex);

/**
 * The medial axis as a surface of polygons, in space, as fine as the density.
 *
 * A vertex stands for each cube of the finest lattice in which a point was found; an edge of the lattice that crosses the axis makes a
 * quadrilateral of the four cubes round it, and cubes among these that have no point get one. Where only the square between two cubes meets
 * the axis, as a curve does, a loose edge joins their vertices. Every vertex is a medial point. Nothing bounds what is missed.
 *
 * Vertices, faces and loose edges carry `radius`, `object_angle`, `feet` (the two nearest points), `pieces` and `sites` (of these): faces
 * and edges those of the point where the lattice crosses the axis. A face between two sites is oriented from the lesser to the larger.
 *
 * \param axis The field axis.
 * \param job NULL for a default job.
 * \param out_complex Receives the complex, which the caller frees with #medax_complex_free.
 * \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` in the plane, where #medax_medial_graph_build has the arcs; `LIMIT_EXCEEDED` past 2^32 - 1
 *         corners of faces; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * Some queries for each edge and square of the cubes that the axis passes. Since 0.1.
 */
MEDAX_API
medax_status medax_field_axis_surface(const medax_field_axis *axis,
                                      const medax_job *job,
                                      const medax_complex **out_complex);

/**
 * Checks a field axis: that nothing is nearer to a point than its radius, and its feet are as near; its angle, thresholds, side and sites;
 * and what covers hold and claim.
 *
 * \param axis The field axis.
 * \param job NULL for a default job.
 * \param out_report Filled, its `struct_size` being set.
 * \return `MEDAX_STATUS_OK` whatever was found; `NULL_ARGUMENT`, `INVALID_ARGUMENT` for a report of no version, `CANCELLED`, `BUSY`,
 *         `OUT_OF_MEMORY`.
 *
 * Some queries for each point and each circle. Since 0.1.
 */
MEDAX_API
medax_status medax_field_axis_validate(const medax_field_axis *axis,
                                       const medax_job *job,
                                       medax_validation *out_report);

/**
 * One more reference to a field axis.
 *
 * \param axis The field axis, or NULL.
 * \return The same pointer; the caller frees it once more.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API const medax_field_axis *medax_field_axis_clone(const medax_field_axis *axis);

/**
 * Gives one reference to a field axis back; the last one frees it.
 *
 * \param axis The field axis; NULL does nothing.
 *
 * Since 0.1.
 */
MEDAX_API void medax_field_axis_free(const medax_field_axis *axis);

/* ---- 38. Medial graph -------------------------------------------------------------------------
 *
 * The medial axis of segments, points and circles in the plane, as a graph: nodes, where arcs meet or end, and arcs. It is followed along
 * the boundary, to the precision of rounding; without thresholds it has the Betti numbers of the region.
 */

/**
 * Which part of the axis, and how finely.
 */
typedef struct {
    /**
     * The size of this struct in the caller's program.
     */
    size_t struct_size;
    /**
     * The longest edge of an arc, in input units. 0, the default, asks for a hundredth of #medax_sites_size.
     */
    double spacing;
    /**
     * The least object angle, in radians in [0, pi]; 0 by default.
     */
    double object_angle;
    /**
     * The least distance from the boundary, in input units; 0 by default.
     */
    double min_distance;
    /**
     * The least corner of a box that holds what is looked at, if `has_clip` is 1; z does not count. No coordinate is beyond 2^200.
     */
    double clip_min[3];
    /**
     * The largest corner of that box.
     */
    double clip_max[3];
    /**
     * 1 for that box; 0, the default, for that of the sites, if the outside is asked for as well as much larger on each side as half its
     * diagonal is long.
     */
    uint32_t has_clip;
    /**
     * A #medax_side of closed curves; `MEDAX_SIDE_INNER` by default. Without these all is outside.
     */
    uint32_t side;
    /**
     * 1 to keep only what has its nearest points on two sites; 0 by default.
     */
    uint32_t between_sites;
    /**
     * Must be 0.
     */
    uint32_t reserved;
} medax_medial_graph_options;

/**
 * Sets the options of medial graphs to their defaults.
 *
 * \param options The caller's struct, of `struct_size` bytes.
 * \param struct_size `sizeof *options`.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_status medax_medial_graph_options_init(medax_medial_graph_options *options,
                                             size_t struct_size);

/**
 * Follows the medial axis of sites in the plane. Segments must meet in common ends only, and touch no circle, as those of a figure do.
 *
 * \param sites The sites, which the result keeps alive.
 * \param options NULL for the defaults.
 * \param job NULL for a default job.
 * \param out_graph Receives the graph, which the caller frees with #medax_medial_graph_free.
 * \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` for sites in space and options out of range; `UNSUPPORTED` with its row for a line or a
 *         ray; `LIMIT_EXCEEDED` for a spacing of less than 2^-20 of the box; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`,
 *         `OUT_OF_MEMORY`.
 *
 * O((n + size) log n). Since 0.1.
 */
MEDAX_API
medax_status medax_medial_graph_build(const medax_sites *sites,
                                      const medax_medial_graph_options *options,
                                      const medax_job *job,
                                      const medax_medial_graph **out_graph);

/**
 * Follows the medial axis of sites in the plane, of which only what has its nearest points on one of some pairs of sites is kept.
 *
 * \param sites The sites, which the result keeps alive.
 * \param pairs `pair_count` x 2 sites, either first; a site with itself for the parts of the medial axis that belong to that site alone.
 *        NULL only if `pair_count` is 0.
 * \param pair_count The number of pairs; with 0 there are no arcs.
 * \param options NULL for the defaults.
 * \param job NULL for a default job.
 * \param out_graph Receives the graph, which the caller frees with #medax_medial_graph_free.
 * \return As #medax_medial_graph_build; also `INVALID_ARGUMENT` with the row of a pair that names no site.
 *
 * As #medax_medial_graph_build. Since 0.1.
 */
MEDAX_API
medax_status medax_medial_graph_between(const medax_sites *sites,
                                        const uint32_t *pairs,
                                        size_t pair_count,
                                        const medax_medial_graph_options *options,
                                        const medax_job *job,
                                        const medax_medial_graph **out_graph);

/**
 * What the boundary was.
 *
 * \param graph The graph.
 * \param out_sites Receives the sites, which the caller frees with #medax_sites_free.
 * \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_status medax_medial_graph_sites(const medax_medial_graph *graph,
                                      const medax_sites **out_sites);

/**
 * The number of nodes, which are the first of the points.
 *
 * \param graph The graph; NULL has none.
 * \return The number of nodes.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API size_t medax_medial_graph_node_count(const medax_medial_graph *graph);

/**
 * The arcs.
 *
 * \param graph The graph, or NULL.
 * \return One row an arc: its points in order, nodes at both ends included. Where a threshold or the box cuts an arc it ends in a point
 *         that is no node; a loop without nodes has its first point at its end again. Borrowed from `graph`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_view_rows medax_medial_graph_arcs(const medax_medial_graph *graph);

/**
 * How many sides of arcs have no other side that agrees with them: 0 but for figures with parts that are apart by less than a millionth of their
 * size, or with vertices that are nearly straight.
 *
 * \param graph The graph; NULL has none.
 * \return How many.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
size_t medax_medial_graph_torn(const medax_medial_graph *graph);

/**
 * Where the points lie: the nodes, then those between.
 *
 * \param graph The graph, or NULL.
 * \return m x 3 coordinates, z being 0. Borrowed from `graph`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_f64 medax_medial_graph_points(const medax_medial_graph *graph);

/**
 * The distances of the points from the boundary: the radii of the medial balls.
 *
 * \param graph The graph, or NULL.
 * \return m x 1, in input units. Borrowed from `graph`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_f64 medax_medial_graph_radii(const medax_medial_graph *graph);

/**
 * The angles between the ways from the points to their nearest points; of a node the largest of those of its arcs there.
 *
 * \param graph The graph, or NULL.
 * \return m x 1, in radians. Borrowed from `graph`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_view_f64 medax_medial_graph_object_angles(const medax_medial_graph *graph);

/**
 * Two nearest points of the boundary for each point.
 *
 * \param graph The graph, or NULL.
 * \return m x 6 coordinates. Borrowed from `graph`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_f64 medax_medial_graph_feet(const medax_medial_graph *graph);

/**
 * The pieces that have these nearest points.
 *
 * \param graph The graph, or NULL.
 * \return m x 2 pieces. Borrowed from `graph`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_u32 medax_medial_graph_pieces(const medax_medial_graph *graph);

/**
 * The sites of these pieces.
 *
 * \param graph The graph, or NULL.
 * \return m x 2 sites. Borrowed from `graph`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_u32 medax_medial_graph_sites_of_points(const medax_medial_graph *graph);

/**
 * The arcs as loose edges. Vertices are the points, with the attributes `radius`, `object_angle`, `feet` (the two nearest points),
 * `pieces`, `sites` (of these) and `is_node`; edges carry `arc`.
 *
 * \param graph The graph.
 * \param job NULL for a default job.
 * \param out_complex Receives the complex, which the caller frees with #medax_complex_free.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(points). Since 0.1.
 */
MEDAX_API
medax_status medax_medial_graph_complex(const medax_medial_graph *graph,
                                        const medax_job *job,
                                        const medax_complex **out_complex);

/**
 * Checks a medial graph: that nothing is nearer to a point than its radius; that its feet are as near, and seen under its angle; and which
 * points arcs have, and where.
 *
 * \param graph The graph.
 * \param job NULL for a default job.
 * \param out_report Filled, its `struct_size` being set.
 * \return `MEDAX_STATUS_OK` whatever was found; `NULL_ARGUMENT`, `INVALID_ARGUMENT` for a report of no version, `CANCELLED`, `BUSY`,
 *         `OUT_OF_MEMORY`.
 *
 * Some queries for each point. Since 0.1.
 */
MEDAX_API
medax_status medax_medial_graph_validate(const medax_medial_graph *graph,
                                         const medax_job *job,
                                         medax_validation *out_report);

/**
 * One more reference to a medial graph.
 *
 * \param graph The graph, or NULL.
 * \return The same pointer; the caller frees it once more.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API const medax_medial_graph *medax_medial_graph_clone(const medax_medial_graph *graph);

/**
 * Gives one reference to a medial graph back; the last one frees it.
 *
 * \param graph The graph; NULL does nothing.
 *
 * Since 0.1.
 */
MEDAX_API void medax_medial_graph_free(const medax_medial_graph *graph);

/* ---- 39. Balls --------------------------------------------------------------------------------
 *
 * Unions of balls, such as those of a medial axis, which are the solid again: how far points are from one, and its boundary as a mesh.
 * (Edelsbrunner 1995, The union of balls and its dual shape.)
 */

/**
 * How fine the boundary of a union of balls is.
 */
typedef struct {
    /**
     * The size of this struct in the caller's program.
     */
    size_t struct_size;
    /**
     * No point of the boundary is farther than this from a sample, in input units. 0, the default, asks for a hundredth of the diagonal of
     * #medax_balls_bounds. On smaller balls it is halved until it is no more than the radius.
     */
    double spacing;
} medax_boundary_options;

/**
 * Makes balls of the caller's centres and radii, which are copied. They may overlap, lie in each other and repeat each other.
 *
 * \param center_xyz `center_count` x 3 coordinates, up to 2^194 in absolute value.
 * \param center_count The number of balls, from 1 to 2^28 - 8.
 * \param radii `radius_count` radii in input units, from 2^-160 to 2^194.
 * \param radius_count As many.
 * \param job NULL for a default job.
 * \param out_balls Receives the balls, which the caller frees with #medax_balls_free.
 * \return `MEDAX_STATUS_OK`; with the row of a ball: `NON_FINITE`, `COORDINATE_RANGE`, and `INVALID_ARGUMENT` for a radius that is not
 *         positive; `MISMATCH` unless each centre has a radius; `TOO_FEW_POINTS` without any; `LIMIT_EXCEEDED` for too many;
 *         `NULL_ARGUMENT`, `INVALID_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(n log n). Since 0.1.
 */
MEDAX_API
medax_status medax_balls_create(const double *center_xyz,
                                size_t center_count,
                                const double *radii,
                                size_t radius_count,
                                const medax_job *job,
                                const medax_balls **out_balls);

/**
 * Balls round the vertices of a complex, which carry `radius`, as those of any medial axis do. Faces and edges count for nothing.
 *
 * \param complex The complex, of which a copy is made.
 * \param job NULL for a default job.
 * \param out_balls Receives the balls, which the caller frees with #medax_balls_free.
 * \return `MEDAX_STATUS_OK`; `MISMATCH` where vertices carry no `radius`; with a vertex for the row what #medax_balls_create returns.
 *
 * O(n log n). Since 0.1.
 */
MEDAX_API
medax_status medax_balls_of_complex(const medax_complex *complex,
                                    const medax_job *job,
                                    const medax_balls **out_balls);

/**
 * The number of balls.
 *
 * \param balls The balls; NULL has none.
 * \return The number of balls.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API size_t medax_balls_count(const medax_balls *balls);

/**
 * The centres.
 *
 * \param balls The balls, or NULL.
 * \return n x 3 coordinates. Borrowed from `balls`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_f64 medax_balls_centers(const medax_balls *balls);

/**
 * The radii.
 *
 * \param balls The balls, or NULL.
 * \return n x 1, in input units. Borrowed from `balls`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_f64 medax_balls_radii(const medax_balls *balls);

/**
 * The smallest box that holds all balls.
 *
 * \param balls The balls.
 * \param out_min Receives the three least coordinates.
 * \param out_max Receives the three greatest coordinates.
 * \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
 *
 * O(n). Since 0.1.
 */
MEDAX_API
medax_status medax_balls_bounds(const medax_balls *balls,
                                double *out_min,
                                double *out_max);

/**
 * For each of some points x the least of |x - c| - r over all balls: negative inside the union, 0 on its boundary, outside the distance to
 * it. Inside it is no distance, but how deep the point is in the ball in which it is deepest, which is at most that.
 *
 * \param balls The balls.
 * \param query_xyz `query_count` x 3 coordinates; NULL only if `query_count` is 0.
 * \param query_count The number of points.
 * \param job NULL for a default job.
 * \param out_distances Receives `query_count` numbers in input units; the caller's buffer, NULL only if `query_count` is 0.
 * \return `MEDAX_STATUS_OK`; `NON_FINITE`, or `COORDINATE_RANGE` beyond 2^200, with the row of a query; `NULL_ARGUMENT`,
 *         `INVALID_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * About O(log n) a query where the radii of neighbours are alike. Since 0.1.
 */
MEDAX_API
medax_status medax_balls_distances(const medax_balls *balls,
                                   const double *query_xyz,
                                   size_t query_count,
                                   const medax_job *job,
                                   double *out_distances);

/**
 * Sets the options of boundaries to their defaults.
 *
 * \param options The caller's struct, of `struct_size` bytes.
 * \param struct_size `sizeof *options`.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_status medax_boundary_options_init(medax_boundary_options *options,
                                         size_t struct_size);

/**
 * The boundary of the union as a mesh of triangles that points out of it.
 *
 * The mesh is closed; each edge has two triangles, four where the mesh touches itself. Every vertex lies on the sphere of the ball that
 * its attribute `ball` names, and in no ball, up to rounding; every point of the mesh is within the spacing of the boundary. What is thinner
 * than the spacing, be it of the solid or of what lies between its parts, may be closed or cut. Balls with a radius of less than 2^-40 of
 * the largest coordinate are left out.
 *
 * \param balls The balls.
 * \param options NULL for the defaults.
 * \param job NULL for a default job.
 * \param out_complex Receives the mesh, which the caller frees with #medax_complex_free.
 * \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` for a spacing that is no length; `COORDINATE_RANGE` where all balls are left out;
 *         `LIMIT_EXCEEDED` for more than 2^28 samples; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * O(n log n + m log m) for m samples in practice; where all balls meet, O(n^2). Since 0.1.
 */
MEDAX_API
medax_status medax_balls_boundary(const medax_balls *balls,
                                  const medax_boundary_options *options,
                                  const medax_job *job,
                                  const medax_complex **out_complex);

/**
 * One more reference to balls.
 *
 * \param balls The balls, or NULL.
 * \return The same pointer; the caller frees it once more.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API const medax_balls *medax_balls_clone(const medax_balls *balls);

/**
 * Gives one reference to balls back; the last one frees them.
 *
 * \param balls The balls; NULL does nothing.
 *
 * Since 0.1.
 */
MEDAX_API void medax_balls_free(const medax_balls *balls);

/* ---- 40. File contents ------------------------------------------------------------------------
 *
 * What a file holds, before points or a complex are made of it. Reading trusts nothing, and an error
 * names the line of a text or the byte of a binary file. The ending of a path names the format:
 * PLY (text, binary), OFF, OBJ, STL (text, binary), XYZ, PTS, TXT and CSV (a row a line), PWN, MA
 * (medial meshes). Plane figures are read by #medax_figure_read. Paths are UTF-8.
 */

/**
 * Reads the contents of a file, of which points or a complex can then be made.
 *
 * \param path_utf8 The path.
 * \param job NULL for a default job.
 * \param out_file Receives the contents, which the caller frees with #medax_file_free.
 * \return `MEDAX_STATUS_OK`; `FORMAT` with the line or byte where the file is malformed or ends too
 *         early; `UNSUPPORTED` for a kind of file that is not read; `IO`; `LIMIT_EXCEEDED` past
 *         2^32 - 2 rows; `NULL_ARGUMENT`, `INVALID_ARGUMENT`, `CANCELLED`, `BUSY`,
 *         `OUT_OF_MEMORY`.
 *
 * O(size of the file). Since 0.1.
 */
MEDAX_API
medax_status medax_file_read(const char *path_utf8,
                             const medax_job *job,
                             const medax_file **out_file);

/**
 * Whether a file has a face or an edge; one without either is a set of points.
 *
 * \param file The contents; NULL has none.
 * \return True for a mesh.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API bool medax_file_is_mesh(const medax_file *file);

/**
 * The rows of a file's vertex table, as they are: they may be NaN.
 *
 * \param file The contents, or NULL.
 * \return v x 3 coordinates. Borrowed from `file`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_f64 medax_file_vertices(const medax_file *file);

/**
 * The faces of a file.
 *
 * \param file The contents, or NULL.
 * \return One row a face: a ring of three vertices or more. Borrowed from `file`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_rows medax_file_faces(const medax_file *file);

/**
 * The edges that a file lists, sides of faces among them.
 *
 * \param file The contents, or NULL.
 * \return e x 2 vertices. Borrowed from `file`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_u32 medax_file_edges(const medax_file *file);

/**
 * The number of attributes of a file.
 *
 * \param file The contents; NULL has none.
 * \return The number of attributes, over all kinds of elements.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API size_t medax_file_attribute_count(const medax_file *file);

/**
 * An attribute of a file by its number.
 *
 * \param file The contents.
 * \param index Which attribute, below #medax_file_attribute_count.
 * \param out_attribute Receives the attribute, whose name and values are borrowed from `file`.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` past the last attribute.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_status medax_file_attribute_at(const medax_file *file,
                                     size_t index,
                                     medax_attribute *out_attribute);

/**
 * The attribute of a file with the given name.
 *
 * \param file The contents.
 * \param element A #medax_element: what carries the attribute.
 * \param name The name, such as `weight`; UTF-8.
 * \param out_attribute Receives the attribute, whose name and values are borrowed from `file`.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` if there is none.
 *
 * O(attributes). Since 0.1.
 */
MEDAX_API
medax_status medax_file_attribute(const medax_file *file,
                                  uint32_t element,
                                  const char *name,
                                  medax_attribute *out_attribute);

/**
 * What was left out in reading a file.
 *
 * \param file The contents.
 * \param out_warnings Receives the warnings, which the caller frees with #medax_warnings_free.
 * \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
 *
 * O(warnings). Since 0.1.
 */
MEDAX_API
medax_status medax_file_warnings(const medax_file *file,
                                 const medax_warnings **out_warnings);

/**
 * Makes points of a file: of a mesh the vertices that a face or an edge uses, else all. Rows are
 * those of the file; an unused vertex maps to `MEDAX_NONE`.
 *
 * \param file The contents.
 * \param options NULL for the defaults.
 * \param job NULL for a default job.
 * \param out_points Receives the points, which the caller frees with #medax_points_free.
 * \return As #medax_points_create_f64.
 *
 * O(n log n). Since 0.1.
 */
MEDAX_API
medax_status medax_file_points(const medax_file *file,
                               const medax_points_options *options,
                               const medax_job *job,
                               const medax_points **out_points);

/**
 * Makes a complex of a file: all vertices, the faces, the edges that are no side of a face, the
 * attributes.
 *
 * \param file The contents.
 * \param job NULL for a default job.
 * \param out_complex Receives the complex, which the caller frees with #medax_complex_free.
 * \return `MEDAX_STATUS_OK`; `NON_FINITE` with the row of a vertex; `FORMAT` with the face or edge
 *         that repeats a vertex in succession; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`,
 *         `OUT_OF_MEMORY`.
 *
 * O(n log n). Since 0.1.
 */
MEDAX_API
medax_status medax_file_complex(const medax_file *file,
                                const medax_job *job,
                                const medax_complex **out_complex);

/**
 * One more reference to a file's contents.
 *
 * \param file The contents, or NULL.
 * \return The same pointer; the caller frees it once more.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API const medax_file *medax_file_clone(const medax_file *file);

/**
 * Gives one reference to a file's contents back; the last one frees them.
 *
 * \param file The contents; NULL does nothing.
 *
 * Since 0.1.
 */
MEDAX_API void medax_file_free(const medax_file *file);

/* ---- 41. Reading and writing ------------------------------------------------------------------
 *
 * Written are PLY, OFF, OBJ, STL, XYZ, PTS, TXT, CSV, MA, VTU, and GeoJSON for plane complexes, by the ending of the path, to a
 * file beside the given name, which is moved into place when it is complete: after an error, a file
 * that was there before is as it was.
 */

/**
 * How to write a file.
 */
typedef struct {
    /**
     * The size of this struct in the caller's program.
     */
    size_t struct_size;
    /**
     * 1 writes PLY as text; 0, the default: binary, little endian.
     */
    uint32_t text;
    /**
     * Must be 0.
     */
    uint32_t reserved;
} medax_write_options;

/**
 * Reads points: #medax_file_read and #medax_file_points in one.
 *
 * \param path_utf8 The path.
 * \param options NULL for the defaults.
 * \param job NULL for a default job.
 * \param out_points Receives the points, which the caller frees with #medax_points_free.
 * \return As #medax_file_read and #medax_points_create_f64.
 *
 * O(n log n). Since 0.1.
 */
MEDAX_API
medax_status medax_points_read(const char *path_utf8,
                               const medax_points_options *options,
                               const medax_job *job,
                               const medax_points **out_points);

/**
 * Reads a complex: #medax_file_read and #medax_file_complex in one.
 *
 * \param path_utf8 The path.
 * \param job NULL for a default job.
 * \param out_complex Receives the complex, which the caller frees with #medax_complex_free.
 * \return As #medax_file_read and #medax_file_complex.
 *
 * O(n log n). Since 0.1.
 */
MEDAX_API
medax_status medax_complex_read(const char *path_utf8,
                                const medax_job *job,
                                const medax_complex **out_complex);

/**
 * Sets write options to their defaults.
 *
 * \param options The caller's struct, of `struct_size` bytes.
 * \param struct_size `sizeof *options`.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_status medax_write_options_init(medax_write_options *options, size_t struct_size);

/**
 * Writes a complex. Numbers are written so that they read back to the same bits, save for STL, which
 * has single precision.
 *
 * \param complex The complex.
 * \param path_utf8 The path.
 * \param options NULL for the defaults.
 * \param job NULL for a default job.
 * \param out_warnings Receives a sentence for each thing that the format cannot hold, which the
 *        caller frees with #medax_warnings_free; or NULL.
 * \return `MEDAX_STATUS_OK`; `UNSUPPORTED` for an unknown ending, a format that is not written, or
 *         one that can hold nothing of the complex; `COORDINATE_RANGE` with the vertex where single
 *         precision is too small; `IO`; `NULL_ARGUMENT`, `INVALID_ARGUMENT`, `CANCELLED`, `BUSY`,
 *         `OUT_OF_MEMORY`.
 *
 * O(n). Since 0.1.
 */
MEDAX_API
medax_status medax_complex_write(const medax_complex *complex,
                                 const char *path_utf8,
                                 const medax_write_options *options,
                                 const medax_job *job,
                                 const medax_warnings **out_warnings);

/**
 * Writes the distinct points in the order of their vertices.
 *
 * \param points The points.
 * \param path_utf8 The path.
 * \param options NULL for the defaults.
 * \param job NULL for a default job.
 * \param out_warnings As for #medax_complex_write.
 * \return As #medax_complex_write.
 *
 * O(n). Since 0.1.
 */
MEDAX_API
medax_status medax_points_write(const medax_points *points,
                                const char *path_utf8,
                                const medax_write_options *options,
                                const medax_job *job,
                                const medax_warnings **out_warnings);

/**
 * The number of warnings.
 *
 * \param warnings The warnings; NULL has none.
 * \return The number of sentences.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API size_t medax_warnings_count(const medax_warnings *warnings);

/**
 * A warning.
 *
 * \param warnings The warnings, or NULL.
 * \param index Which one, below #medax_warnings_count.
 * \return A sentence in UTF-8, borrowed from `warnings`; empty past the last one; never NULL.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API const char *medax_warnings_text(const medax_warnings *warnings, size_t index);

/**
 * One more reference to warnings.
 *
 * \param warnings The warnings, or NULL.
 * \return The same pointer; the caller frees it once more.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API const medax_warnings *medax_warnings_clone(const medax_warnings *warnings);

/**
 * Gives one reference to warnings back; the last one frees them.
 *
 * \param warnings The warnings; NULL does nothing.
 *
 * Since 0.1.
 */
MEDAX_API void medax_warnings_free(const medax_warnings *warnings);

/* ---- 42. Samples ------------------------------------------------------------------------------
 *
 * Points of the surfaces of built-in shapes and of meshes, evenly spread: no two are nearer than
 * the spacing. The same options give the same points on every machine.
 */

/**
 * A solid of known form.
 */
enum medax_shape
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
    /**
     * A torus about the z axis: core circle of radius 1, tube of radius 0.4.
     */
    MEDAX_SHAPE_TORUS = 0,
    /**
     * A box of sides 2, 1.5 and 1 about the origin.
     */
    MEDAX_SHAPE_BOX = 1,
    /**
     * All points within 0.5 of the segment from (-1, 0, 0) to (1, 0, 0).
     */
    MEDAX_SHAPE_CAPSULE = 2,
    /**
     * An ellipsoid with half axes 1.4, 1 and 0.7 along x, y and z.
     */
    MEDAX_SHAPE_ELLIPSOID = 3,
    /**
     * A tube of radius 0.3 about the trefoil knot.
     */
    MEDAX_SHAPE_TREFOIL = 4,
    /**
     * Three tori in a row, blended into one smooth surface.
     */
    MEDAX_SHAPE_GENUS3 = 5,
    /**
     * A bracket: two plates at a right angle, two holes through one, one through the other.
     */
    MEDAX_SHAPE_BRACKET = 6,
    /**
     * The unit ball.
     */
    MEDAX_SHAPE_SPHERE = 7,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum medax_shape medax_shape;
#else
typedef uint32_t medax_shape;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

/**
 * What is known of a shape. The caller sets `struct_size`, the library the rest.
 */
typedef struct {
    /**
     * The size of this struct in the caller's program.
     */
    size_t struct_size;
    /**
     * The least coordinates of a box that holds the shape.
     */
    double min[3];
    /**
     * The greatest coordinates of that box.
     */
    double max[3];
    /**
     * The spacing that samples have by default: a quarter of the least local feature size of a
     * smooth shape, about a sixth of the thinnest part of a sharp one.
     */
    double spacing;
    /**
     * The genus of the surface.
     */
    uint32_t genus;
    /**
     * The number of pieces of the surface.
     */
    uint32_t components;
    /**
     * 1 if the surface has a tangent plane everywhere.
     */
    uint32_t smooth;
    /**
     * 0.
     */
    uint32_t reserved;
} medax_shape_facts;

/**
 * How densely to sample, and how much noise to add.
 */
typedef struct {
    /**
     * The size of this struct in the caller's program.
     */
    size_t struct_size;
    /**
     * No two samples are nearer than this, before noise; in input units. 0, the default: that of the
     * shape, or a hundredth of the diagonal of a mesh's bounding box.
     */
    double spacing;
    /**
     * Instead of the spacing: about how many samples a unit of area gets. 0, the default: the
     * spacing says it.
     */
    double density;
    /**
     * The standard deviation of Gaussian noise along the normal, in input units; 0 by default, and at
     * most a million times the diagonal of the surface's bounding box.
     */
    double noise;
    /**
     * Which of the many samples, 0 by default: the same seed gives the same points.
     */
    uint64_t seed;
} medax_sample_options;

/**
 * The name of a shape, such as `torus`.
 *
 * \param shape A #medax_shape; shapes are numbered from 0 without a gap.
 * \return A static string; empty for a number that is no shape; never NULL.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API const char *medax_shape_name(uint32_t shape);

/**
 * What is known of a shape.
 *
 * \param shape A #medax_shape.
 * \param out_facts Filled, its `struct_size` being set.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a number that is no shape or
 *         facts of no version.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API
medax_status medax_shape_describe(uint32_t shape,
                                  medax_shape_facts *out_facts);

/**
 * Sets sample options to their defaults.
 *
 * \param options The caller's struct, of `struct_size` bytes.
 * \param struct_size `sizeof *options`.
 * \return `MEDAX_STATUS_OK`, `NULL_ARGUMENT`, or `INVALID_ARGUMENT` for a size of no version.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_status medax_sample_options_init(medax_sample_options *options, size_t struct_size);

/**
 * Samples the surface of a built-in shape.
 *
 * \param shape A #medax_shape.
 * \param options NULL for the defaults.
 * \param job NULL for a default job.
 * \param out_samples Receives the samples, which the caller frees with #medax_samples_free.
 * \return `MEDAX_STATUS_OK`; `INVALID_ARGUMENT` for a number that is no shape, an option that is
 *         negative or not finite, both a spacing and a density, or more noise than is allowed;
 *         `LIMIT_EXCEEDED` past 2^27 samples; `NULL_ARGUMENT`, `CANCELLED`, `BUSY`, `OUT_OF_MEMORY`.
 *
 * About 100 evaluations of the shape for each of 64 candidates a square of the spacing. Since 0.1.
 */
MEDAX_API
medax_status medax_samples_build(uint32_t shape,
                                 const medax_sample_options *options,
                                 const medax_job *job,
                                 const medax_samples **out_samples);

/**
 * Samples the faces of a mesh.
 *
 * \param mesh The mesh.
 * \param options NULL for the defaults.
 * \param job NULL for a default job.
 * \param out_samples Receives the samples, which the caller frees with #medax_samples_free.
 * \return As #medax_samples_build; also `DEGENERATE` if no face has an area, `COORDINATE_RANGE` if
 *         the area or the diagonal overflows.
 *
 * O(log triangles) for each of 64 candidates a square of the spacing. Since 0.1.
 */
MEDAX_API
medax_status medax_samples_build_from_mesh(const medax_complex *mesh,
                                           const medax_sample_options *options,
                                           const medax_job *job,
                                           const medax_samples **out_samples);

/**
 * The samples, noise included.
 *
 * \param samples The samples, or NULL.
 * \return n x 3 coordinates, in input units. Borrowed from `samples`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_f64 medax_samples_coords(const medax_samples *samples);

/**
 * The outward unit normals of the surface where samples were taken; on an edge that of one of its
 * sides.
 *
 * \param samples The samples, or NULL.
 * \return n x 3. Borrowed from `samples`.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API medax_view_f64 medax_samples_normals(const medax_samples *samples);

/**
 * The least distance between two samples, before noise.
 *
 * \param samples The samples; NULL has 0.
 * \return A length in input units.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API double medax_samples_spacing(const medax_samples *samples);

/**
 * The area of the surface as the number of candidates tells it, to about a per cent.
 *
 * \param samples The samples; NULL has 0.
 * \return An area in squared input units.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API double medax_samples_area(const medax_samples *samples);

/**
 * The samples as vertices with the attribute `normal`, for writing to a file.
 *
 * \param samples The samples.
 * \param out_complex Receives the complex, which the caller frees with #medax_complex_free.
 * \return `MEDAX_STATUS_OK` or `NULL_ARGUMENT`.
 *
 * O(n). Since 0.1.
 */
MEDAX_API
medax_status medax_samples_complex(const medax_samples *samples,
                                   const medax_complex **out_complex);

/**
 * One more reference to samples.
 *
 * \param samples The samples, or NULL.
 * \return The same pointer; the caller frees it once more.
 *
 * Constant time. Since 0.1.
 */
MEDAX_API const medax_samples *medax_samples_clone(const medax_samples *samples);

/**
 * Gives one reference to samples back; the last one frees them.
 *
 * \param samples The samples; NULL does nothing.
 *
 * Since 0.1.
 */
MEDAX_API void medax_samples_free(const medax_samples *samples);

#ifdef __cplusplus
}
#endif

#endif /* MEDAX_H */
