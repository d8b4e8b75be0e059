// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "python/running.hpp"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <list>
#include <mutex>
#include <optional>
#include <thread>

#include <pybind11/pybind11.h>
#include <unistd.h>

#include "python/diagnostics.hpp"

namespace balcony::python {

namespace py = pybind11;

namespace {

// How long a signal may wait.
constexpr std::chrono::milliseconds patience{50};

// All work of this process. Never destroyed, since threads may outlive the module.
struct Running {
    std::mutex mutex;
    std::condition_variable ended;
    std::list<std::stop_source> works;
    std::size_t returning = 0;              // Threads that are about to take the lock of Python.
    std::optional<std::thread::id> last{};  // The only one that may take it from now on.
    pid_t process = 0;                      // In which the first one ran.
};
Running& running() {
    static auto* const all = new Running;
    return *all;
}

bool is_forked() {
    const std::lock_guard lock(running().mutex);
    pid_t& process = running().process;
    process = process == 0 ? getpid() : process;
    return process != getpid();
}

// One piece of work, on its thread.
class Work {
public:
    explicit Work(const std::function<void(const std::stop_token&)>& work) {
        Running& all = running();
        const std::lock_guard lock(all.mutex);
        place_ = all.works.emplace(all.works.end());
        thread_ = std::thread([this, &work, stop = place_->get_token()] {
            try {
                work(stop);
            } catch (...) {
                failure_ = std::current_exception();
            }
            end();
        });
    }
    Work(const Work&) = delete;
    Work& operator=(const Work&) = delete;
    ~Work() { thread_.join(); }

    void stop() {
        const std::lock_guard lock(running().mutex);
        if (!has_ended_) {
            place_->request_stop();
        }
    }
    bool wait(std::chrono::milliseconds longest) {
        std::unique_lock lock(running().mutex);
        return running().ended.wait_for(lock, longest, [this] { return has_ended_; });
    }
    void rethrow() const {
        if (failure_) {
            std::rethrow_exception(failure_);
        }
    }

private:
    void end() {
        Running& all = running();
        const std::lock_guard lock(all.mutex);
        all.works.erase(place_);
        has_ended_ = true;
        all.ended.notify_all();
    }

    std::list<std::stop_source>::iterator place_;
    std::exception_ptr failure_;
    bool has_ended_ = false;
    std::thread thread_;
};

// Waits without the lock of Python. When the interpreter ends, a thread that takes its lock is
// ended in the middle of C++, which ends the process: such a thread waits for that end instead.
bool wait_unlocked(Work& work) {
    Running& all = running();
    bool has_ended = false;
    {
        const py::gil_scoped_release released;
        has_ended = work.wait(patience);
        std::unique_lock lock(all.mutex);
        all.ended.wait(lock, [&] { return !all.last || *all.last == std::this_thread::get_id(); });
        ++all.returning;
    }
    const std::lock_guard lock(all.mutex);
    --all.returning;
    all.ended.notify_all();
    return has_ended;
}

// The exception that is to be raised after the work, if one came meanwhile.
std::exception_ptr trouble_of(const std::function<void()>& meanwhile) {
    try {
        if (PyErr_CheckSignals() != 0) {
            throw py::error_already_set();
        }
        if (meanwhile) {
            meanwhile();
        }
    } catch (const py::error_already_set&) {
        return std::current_exception();
    }
    return nullptr;
}

}  // namespace

void run(const std::function<void(const std::stop_token&)>& work,
         const std::function<void()>& meanwhile) {
    if (is_forked()) {
        tell({error(Kind::usage, "this process was forked from one that had used Balcony",
                    "start processes by the method 'spawn' or 'forkserver' of multiprocessing, or "
                    "use Balcony in the new process alone")});
    }
    std::exception_ptr trouble;
    {
        Work one(work);
        while (!wait_unlocked(one)) {
            if (!trouble && (trouble = trouble_of(meanwhile))) {
                one.stop();
            }
        }
        one.rethrow();
    }
    if (trouble) {
        std::rethrow_exception(trouble);
    }
}

void stop_all() {
    const py::gil_scoped_release released;
    Running& all = running();
    std::unique_lock lock(all.mutex);
    if (all.process != 0 && all.process != getpid()) {
        return;
    }
    for (std::stop_source& one : all.works) {
        one.request_stop();
    }
    all.last = std::this_thread::get_id();
    all.ended.wait(lock, [&] { return all.works.empty() && all.returning == 0; });
}

}  // namespace balcony::python
