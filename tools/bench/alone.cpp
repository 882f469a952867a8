// A loop that can do one scene and nothing else: a disc in free flight, printed byte for byte as `smb2d simulate`
// prints it. What the whole program may cost where a scene needs no more is measured against it (tools/bench/needless).
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace {

// The scene of tools/bench/flight.svg.
constexpr double x = 2, y = 1, vx = 3, vy = 4, spin = 5, g = 9.81;
constexpr std::size_t block_size = 1u << 16;  // bytes

void add(std::string& block, double number) {
    char digits[40];
    auto const [end, error] = std::to_chars(digits, digits + sizeof digits, number, std::chars_format::general, 17);
    block.append(digits, end);
    block += ',';
}

void flush(std::string& block) {
    std::fwrite(block.data(), 1, block.size(), stdout);
    block.clear();
}

}  // namespace

int main(int argc, char** argv) {
    double const to = argc > 1 ? std::atof(argv[1]) : 10;  // s
    std::string block = "t,ball,x,y,angle,vx,vy,spin,phase,surface\n";
    for (long long i = 0; static_cast<double>(i) / 60 <= to; ++i) {
        double const t = static_cast<double>(i) / 60;
        add(block, t);
        block += "0,";
        for (double const number : {x + t * vx, y + t * (vy - 0.5 * t * g), t * spin, vx, vy - t * g, spin})
            add(block, number);
        block += "flight,\n";
        if (block.size() >= block_size) flush(block);
    }
    flush(block);
}
