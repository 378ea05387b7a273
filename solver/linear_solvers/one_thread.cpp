#include "solver/linear_solvers/one_thread.hpp"

#include <omp.h>

#include <cstddef>
#include <mutex>
#include <new>
#include <set>
#include <shared_mutex>
#include <vector>

#include "base/room.hpp"

extern "C" {
void openblas_set_num_threads(int count);
void* blas_memory_alloc(int position);
void blas_memory_free(void* space);
}

namespace crawford {

namespace {

constexpr std::size_t work_space = std::size_t{32} << 22;  // BUFFER_SIZE of OpenBLAS on x86_64

/// Work spaces that a thread holds for a moment.
class Taken {
public:
    Taken() = default;
    ~Taken() {
        for (void* space : spaces_) blas_memory_free(space);
    }
    Taken(const Taken&) = delete;
    Taken(Taken&&) = delete;
    Taken& operator=(const Taken&) = delete;
    Taken& operator=(Taken&&) = delete;

    /// One more, which OpenBLAS maps if none that it has is free.
    void* one() {
        look_for_room(work_space);
        return spaces_.emplace_back(blas_memory_alloc(0));
    }

private:
    std::vector<void*> spaces_;
};

/// OpenBLAS maps a work space when none that it has is free, tries for ever where it cannot, and
/// never gives one back. So there are as many as threads that call it, before they do; and none
/// calls it while one more is mapped, when all that there are may be taken.
class WorkSpaces {
public:
    /// \throws std::bad_alloc
    void add_thread() {
        const std::lock_guard no_more_calls(gate_);
        const std::lock_guard lock(calls_);
        Taken taken;
        while (mapped_.size() <= threads_) mapped_.insert(taken.one());
        ++threads_;
    }
    void end_thread() {
        const std::lock_guard no_more_calls(gate_);
        --threads_;
    }
    Calls call() {
        const std::lock_guard in_turn(gate_);
        return Calls(calls_);
    }

private:
    std::mutex gate_;  ///< a thread that is added need not wait for calls that come after it
    std::shared_mutex calls_;
    std::set<void*> mapped_;
    std::size_t threads_ = 0;
};

WorkSpaces& work_spaces() {
    static WorkSpaces spaces;
    return spaces;
}

/// As long as it is there, its thread has a work space.
class Caller {
public:
    Caller() { work_spaces().add_thread(); }
    ~Caller() { work_spaces().end_thread(); }
    Caller(const Caller&) = delete;
    Caller(Caller&&) = delete;
    Caller& operator=(const Caller&) = delete;
    Caller& operator=(Caller&&) = delete;
};

}  // namespace

Calls use_one_thread() {
    thread_local const Caller caller;
    static_cast<void>(caller);
    // No level of parallel regions may be active: a num_threads clause, as CHOLMOD's, overrides any
    // other setting.
    omp_set_max_active_levels(0);
    openblas_set_num_threads(1);
    return work_spaces().call();
}

}  // namespace crawford
