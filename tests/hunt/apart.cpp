#include "hunt/apart.h"

#include <cmath>
#include <csignal>
#include <cstdio>
#include <optional>
#include <sstream>
#include <stdexcept>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace hunt {

namespace {

constexpr rlim_t most_memory = 3'000'000'000;  // bytes
constexpr double most_measured = 1e300;        // what is more, or no number, could not be read back

std::string text_of(Verdict const& verdict) {
    std::ostringstream text;
    text.precision(17);
    text << verdict.events << ' ' << verdict.busiest << ' ' << verdict.seconds << ' ' << verdict.worst_row << ' '
         << verdict.end << '\n';
    for (Finding const& finding : verdict.findings)
        text << static_cast<int>(finding.wrong) << ' ' << std::fmin(finding.measured, most_measured) << ' '
             << finding.time << '|' << finding.words << '\n';
    text << "done\n";
    return text.str();
}

// Nothing where the text is cut short.
std::optional<Verdict> verdict_in(std::string const& text) {
    if (!text.ends_with("done\n")) return std::nullopt;
    std::istringstream in(text);
    Verdict verdict;
    in >> verdict.events >> verdict.busiest >> verdict.seconds >> verdict.worst_row >> verdict.end;
    Finding finding;
    for (int wrong = 0; in >> wrong >> finding.measured >> finding.time;) {
        finding.wrong = static_cast<Wrong>(wrong);
        in.ignore();
        std::getline(in, finding.words);
        verdict.findings.push_back(finding);
    }
    return verdict;
}

void limit(int resource, rlim_t most) {
    rlimit const limits{most, most};
    setrlimit(resource, &limits);
}

[[noreturn]] void work_and_end(std::function<Verdict()> const& work, int end) {
    limit(RLIMIT_CPU, longest_verdict);
    limit(RLIMIT_AS, most_memory);
    limit(RLIMIT_CORE, 0);
    int status = 1;
    try {
        std::string const text = text_of(work());
        status = write(end, text.data(), text.size()) == static_cast<ssize_t>(text.size()) ? 0 : 1;
    } catch (std::exception const& error) {
        std::fprintf(stderr, "hunter: %s\n", error.what());
    }
    _exit(status);
}

}  // namespace

Errand::Errand(std::function<Verdict()> const& work) {
    int ends[2];
    std::fflush(nullptr);
    if (pipe(ends) != 0) throw std::runtime_error("no pipe");
    child_ = fork();
    if (child_ < 0) throw std::runtime_error("no process");
    if (child_ == 0) {
        close(ends[0]);
        work_and_end(work, ends[1]);
    }
    close(ends[1]);
    end_ = ends[0];
}

Verdict Errand::finish() {
    std::string text;
    char part[4096];
    for (ssize_t got = 0; (got = read(end_, part, sizeof part)) > 0;) text.append(part, static_cast<std::size_t>(got));
    close(end_);
    int status = 0;
    waitpid(child_, &status, 0);
    if (auto const verdict = verdict_in(text)) return *verdict;
    Verdict broken;
    bool const timed_out = WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL);
    broken.findings.push_back({Wrong::no_end, timed_out ? longest_verdict : 0.0, 0, timed_out ? "" : "crashed"});
    return broken;
}

}  // namespace hunt
