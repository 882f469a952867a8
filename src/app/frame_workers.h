// Threads that paint frames: orders come in, in order; each thread has an off-screen painter of its own.
#pragma once

#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "app/sequence.h"
#include "view/scene_picture.h"

namespace app {

struct FrameOrder {
    long long frame = 0;
    view::Moment moment;
    view::Camera camera;
};

class FrameWorkers {
public:
    // All that is passed must outlive the workers. Throws std::runtime_error where a thread cannot be started.
    FrameWorkers(view::Stage const& stage, view::Overlays const& overlays, FrameJob const& job, int workers);
    // Frames that are being painted are finished, orders that wait are dropped.
    ~FrameWorkers();
    FrameWorkers(FrameWorkers const&) = delete;
    FrameWorkers& operator=(FrameWorkers const&) = delete;

    // Waits while there are enough orders already. This and the next two throw what a worker threw, and Interrupted.
    void take(FrameOrder order);
    void wait_a_little();
    void close();  // no more orders will come

    long long finished();  // frames

private:
    void stop();
    void work();
    void paint_orders();
    std::optional<FrameOrder> next_order();
    void hand_in(long long frame, std::vector<std::uint8_t> product);
    void rethrow();

    view::Stage const& stage_;
    view::Dressing dressing_;
    FrameJob const& job_;
    std::size_t room_;  // orders that may wait

    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<FrameOrder> orders_;
    long long delivered_ = 0;  // frames handed in
    bool closed_ = false;
    bool stopped_ = false;
    std::exception_ptr failure_;
    std::vector<std::thread> workers_;
};

}  // namespace app
