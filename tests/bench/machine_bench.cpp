// What this machine can do at best, measured beside our own: bandwidth by a triad, arithmetic by dgemm. Ratios to
// these carry over to another machine.
#include <benchmark/benchmark.h>
#include <cblas.h>

#include <vector>

namespace crawford {

namespace {

/// a = b + s c of arrays that no cache holds [bytes a second].
void triad(benchmark::State& state) {
    constexpr std::size_t size = 1U << 23U;
    std::vector<double> a(size, 0.0);
    const std::vector<double> b(size, 1.0), c(size, 2.0);
    for ([[maybe_unused]] auto iteration : state) {
        for (std::size_t k = 0; k < size; ++k) a[k] = b[k] + 3.0 * c[k];
        benchmark::DoNotOptimize(a.data());
        benchmark::ClobberMemory();
    }
    state.SetBytesProcessed(state.iterations() * std::int64_t(3 * sizeof(double) * size));
}

/// C = A B on one thread [operations a second].
void dgemm(benchmark::State& state) {
    constexpr int n = 768;
    openblas_set_num_threads(1);
    const std::vector<double> a(std::size_t(n) * n, 1.0), b(std::size_t(n) * n, 2.0);
    std::vector<double> c(std::size_t(n) * n, 0.0);
    for ([[maybe_unused]] auto iteration : state) {
        cblas_dgemm(CblasColMajor, CblasNoTrans, CblasNoTrans, n, n, n, 1.0, a.data(), n, b.data(),
                    n, 0.0, c.data(), n);
        benchmark::DoNotOptimize(c.data());
    }
    state.counters["flops"] =
        benchmark::Counter(2.0 * n * n * n, benchmark::Counter::kIsIterationInvariantRate);
}

}  // namespace

BENCHMARK(triad)->Unit(benchmark::kMillisecond);
BENCHMARK(dgemm)->Unit(benchmark::kMillisecond);

}  // namespace crawford
