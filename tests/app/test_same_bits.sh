#!/usr/bin/env bash
# T20: the same runs come to the same bits whatever compiled the program: builds what moves the balls with other compilers and
# flags, in folders that are kept beside the build, and compares with what the build under test prints. A sanitized build
# is compared with what the plain one's folders last printed, as long as that is not out of date.
set -euo pipefail
tree=$(cd "$(dirname "$1")" && pwd)
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
cd "$top"

builds=(
    "g++ -O0"
    "g++ -O3 -march=native"
    "clang++ -O2"
)
levels=(assets/lab/*.svg assets/levels/*.svg)
expected=$("$tree/tests/bits" "${levels[@]}")
[ "$(wc -l <<<"$expected")" -ge 60 ] || { echo "too few runs to compare"; exit 1; }

build() {  # FOLDER COMPILER FLAGS
    cmake -S . -B "$1" -G Ninja -DSMB2D_TESTS=ON -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_COMPILER="$2" \
        -DCMAKE_CXX_FLAGS="$3" -DCMAKE_PROJECT_smb2d_INCLUDE="$top/tests/bits/precompiled.cmake" &&
        cmake --build "$1" --target bits
}

compare_with() {  # FILE NAME
    diff <(echo "$expected") "$1" >"$1.diff" && return 0
    echo "$2: other bits (<: the build under test)"
    cat "$1.diff"
    return 1
}

status=0
if grep -q '^SMB2D_SANITIZE:BOOL=ON' "$tree/CMakeCache.txt"; then
    for printed in "$tree"/../test/same_bits/*.txt; do
        [ -e "$printed" ] || continue
        [ -z "$(find src tests/bits assets/lab assets/levels -newer "$printed" -print -quit)" ] || continue
        compare_with "$printed" "$(basename "$printed" .txt)" || status=1
    done
    exit $status
fi
mkdir -p "$tree/same_bits"
for flags in "${builds[@]}"; do
    folder="$tree/same_bits/${flags// /}"
    build "$folder" "${flags%% *}" "${flags#* }" >"$folder.log" 2>&1 || { cat "$folder.log"; exit 1; }
    "$folder/tests/bits" "${levels[@]}" >"$folder.txt"
    compare_with "$folder.txt" "$flags" || status=1
done
exit $status
