// A trace: balls at times, or events, as CSV or JSON on standard output (docs/runs-and-traces.md).
#pragma once

#include <string_view>

#include "app/output.h"
#include "game/session.h"

namespace app {

class Trace {
public:
    enum class Format { csv, json };
    enum class Rows { times, events };

    explicit Trace(Format format) : format_(format) {}

    void header(Rows rows);
    void add_balls(game::Session const& session, double time);
    void add_event(game::Session const& session, physics::Event const& event);
    void flush();

private:
    void begin();
    void end();
    void name(char const* field);
    void field(char const* name, double value);
    void field(char const* name, int value);
    void field(char const* name, std::string_view text);
    void empty_field(char const* name);

    Format format_;
    Output output_;
    bool is_first_ = true;
};

}  // namespace app
