# What the commands need from Debian 12, in one place, and how it gets there. Sourced by tools/run, test and charts.

packages_to_play=(
    g++ cmake ninja-build pkg-config python3-glad
    libsdl2-dev libosmesa6-dev libeigen3-dev libstb-dev libcli11-dev libpugixml-dev nlohmann-json3-dev libdeflate-dev
    ffmpeg fonts-dejavu-core
)
packages_to_test=(
    "${packages_to_play[@]}"
    doctest-dev libbenchmark-dev clang lld libclang-rt-dev libc++-dev libc++abi-dev python3 xvfb xdotool libgl1-mesa-dri
)
packages_to_bench=(
    "${packages_to_play[@]}"
    libbenchmark-dev libbox2d-dev libchipmunk-dev gnuplot-nox valgrind
)

say() { printf '%s\n' "$*" >&2; }
give_up() {
    say "$@"
    exit 1
}

# The same needs by the names they answer to, for systems on which dpkg cannot be asked. doctest and stb are headers.
commands_to_play=(c++ cmake ninja pkg-config glad ffmpeg)
modules_to_play=(sdl2 osmesa eigen3 stb CLI11 pugixml nlohmann_json libdeflate)
commands_to_test=("${commands_to_play[@]}" clang++ python3 Xvfb xdotool)
commands_to_bench=("${commands_to_play[@]}" gnuplot valgrind)

lacks_by_name() {
    local -n commands=commands_to_$1
    local name
    for name in "${commands[@]}"; do command -v "$name" >/dev/null || printf '%s ' "$name"; done
    command -v pkg-config >/dev/null || return 0
    for name in "${modules_to_play[@]}"; do pkg-config --exists "$name" || printf '%s ' "$name"; done
}

# Installs what is missing of the packages named by `play`, `test` or `bench`. Says nothing when nothing is.
install_what_is_missing_to() {
    local -n packages=packages_to_$1
    local missing
    if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
        missing=$(lacks_by_name "$1")
        [ -z "$missing" ] || give_up "missing here: $missing- on Debian 12 the packages are: ${packages[*]}"
        return 0
    fi
    missing=$(comm -23 <(printf '%s\n' "${packages[@]}" | sort -u) \
        <(dpkg-query -W -f '${db:Status-Status} ${Package}\n' "${packages[@]}" 2>/dev/null |
            sed -n 's/^installed //p' | sort -u))
    [ -n "$missing" ] || return 0
    missing=${missing//$'\n'/ }
    local as_root=()
    if [ "$(id -u)" -ne 0 ]; then
        command -v sudo >/dev/null || give_up "needs root or sudo for: apt-get install $missing"
        as_root=(sudo)
    fi
    say "installing $missing"
    local log
    log=$(mktemp)
    # shellcheck disable=SC2086  # names of packages, one word each
    if ! { "${as_root[@]}" apt-get -qq update &&
        "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -y --no-install-recommends install $missing; } \
        >"$log" 2>&1 </dev/null; then
        cat "$log" >&2
        rm -f "$log"
        give_up "could not install $missing"
    fi
    rm -f "$log"
}

# Compilers take memory in large pieces, keep it, and have it in large pages: a tenth of their time. (Of any of the first three
# set, glibc wants all.)
export COMPILERS_MALLOC=glibc.malloc.mmap_threshold=1073741824:glibc.malloc.trim_threshold=1073741824:glibc.malloc.top_pad=67108864
COMPILERS_MALLOC+=:glibc.malloc.hugetlb=1

# Configures and builds a preset from the top of the checkout, or the targets named after it; all it says goes to stderr,
# and nothing when all is built.
build_preset() {
    local preset=$1 folder=build/$1 targets=("${@:2}") log
    if [ ! -e "$folder/build.ninja" ]; then
        say "building $preset in $folder"
        mkdir -p "$folder"
        log=$folder/configure.log
        cmake --preset "$preset" >"$log" 2>&1 || {
            cat "$log" >&2
            give_up "could not configure $preset"
        }
    fi
    # What ninja and cmake say of themselves is left out; steps and errors come as they happen.
    GLIBC_TUNABLES=$COMPILERS_MALLOC ninja -C "$folder" "${targets[@]}" | { grep --line-buffered -vE '^(ninja: (Entering|no work)|-- |\[.*Re-(checking|running))' || true; } >&2 ||
        give_up "could not build $preset"
}
