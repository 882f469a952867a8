// Verdicts reached in a process of their own, so that a case that hangs or crashes is a finding as well.
#pragma once

#include <functional>

#include <sys/types.h>

#include "hunt/judge.h"

namespace hunt {

inline constexpr unsigned longest_verdict = 30;  // s of processor time

// A child that is at work on a verdict. To be finished exactly once.
class Errand {
public:
    explicit Errand(std::function<Verdict()> const& work);
    Verdict finish();

private:
    pid_t child_ = -1;
    int end_ = -1;  // of the pipe
};

}  // namespace hunt
