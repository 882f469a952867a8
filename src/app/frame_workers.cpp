#include "app/frame_workers.h"

#include <chrono>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>

#include "app/interrupt.h"
#include "screen/heap.h"
#include "screen/offscreen.h"

namespace app {

namespace {

// How long Ctrl-C may go unheard while waiting.
constexpr auto idle_wait = std::chrono::milliseconds(50);

}  // namespace

FrameWorkers::FrameWorkers(view::Stage const& stage, view::Overlays const& overlays, FrameJob const& job, int workers)
    : stage_(stage), job_(job), room_(static_cast<std::size_t>(workers) + 1) {
    dressing_.overlays = overlays;
    workers_.reserve(static_cast<std::size_t>(workers));
    try {
        while (workers_.size() < static_cast<std::size_t>(workers)) workers_.emplace_back([this] { work(); });
    } catch (std::system_error const& error) {
        stop();
        throw std::runtime_error("--jobs " + std::to_string(workers) + ": thread " +
                                 std::to_string(workers_.size() + 1) + " cannot be started: " + error.code().message());
    } catch (...) {
        stop();
        throw;
    }
}

FrameWorkers::~FrameWorkers() { stop(); }

void FrameWorkers::stop() {
    {
        std::lock_guard const lock(mutex_);
        stopped_ = true;
    }
    changed_.notify_all();
    for (std::thread& worker : workers_) worker.join();
}

void FrameWorkers::rethrow() {
    if (failure_) std::rethrow_exception(failure_);
    stop_if_interrupted();
}

void FrameWorkers::take(FrameOrder order) {
    std::unique_lock lock(mutex_);
    rethrow();
    while (!changed_.wait_for(lock, idle_wait, [this] { return failure_ || orders_.size() < room_; })) rethrow();
    rethrow();
    orders_.push_back(std::move(order));
    lock.unlock();
    changed_.notify_all();
}

void FrameWorkers::close() {
    {
        std::lock_guard const lock(mutex_);
        closed_ = true;
    }
    changed_.notify_all();
}

void FrameWorkers::wait_a_little() {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, idle_wait);
    rethrow();
}

long long FrameWorkers::finished() {
    std::lock_guard const lock(mutex_);
    return delivered_;
}

std::optional<FrameOrder> FrameWorkers::next_order() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return stopped_ || closed_ || !orders_.empty(); });
    if (stopped_ || orders_.empty()) return std::nullopt;
    FrameOrder order = std::move(orders_.front());
    orders_.pop_front();
    lock.unlock();
    changed_.notify_all();
    return order;
}

void FrameWorkers::hand_in(long long frame, std::vector<std::uint8_t> product) {
    std::unique_lock lock(mutex_);
    if (job_.deliver) {
        changed_.wait(lock, [&] { return stopped_ || delivered_ == frame; });
        if (stopped_) return;
        // Nobody else delivers until the count goes on, so the lock need not be held meanwhile.
        lock.unlock();
        job_.deliver(std::move(product));
        lock.lock();
    }
    ++delivered_;
    lock.unlock();
    changed_.notify_all();
}

void FrameWorkers::paint_orders() {
    // Not before there is something to paint: by then every thread has been started, or none paints.
    std::optional<screen::Offscreen> offscreen;
    while (auto const order = next_order()) {
        if (!offscreen) offscreen.emplace();
        screen::Pixels const& pixels =
            offscreen->paint(view::picture_of(stage_, order->moment, order->camera, dressing_));
        hand_in(order->frame, job_.make(order->frame, pixels));
    }
}

void FrameWorkers::work() {
    leave_interrupts_to_the_main_thread();
    screen::prepare_heap_of_thread();
    try {
        paint_orders();
    } catch (...) {
        {
            std::lock_guard const lock(mutex_);
            if (!failure_) failure_ = std::current_exception();
            stopped_ = true;
        }
        changed_.notify_all();
    }
}

}  // namespace app
