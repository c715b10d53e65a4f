# shellcheck shell=bash
# Steps that take a while: one line each, the rest in a log; and the build. Sourced by tools/demo and tools/test,
# which set `top` to the checkout's folder.
# shellcheck disable=SC2154

cmake_settings=()

# At a terminal: shows the last line of the log behind the label, once a second, as long as this script lives.
follow_log() {
  local label=$1 log=$2
  while sleep 1 && kill -0 $$ 2>/dev/null; do
    printf '\r\e[K%s ... %.*s' "$label" "$((${COLUMNS:-80} - ${#label} - 6))" "$(tail -n 1 -- "$log" | tr -dc '[:print:]')"
  done
}

# step LABEL LOG COMMAND...: runs COMMAND, its output in LOG. Where it fails, shows the end of LOG and returns its status.
step() {
  local label=$1 log=$2 started=$SECONDS code=0 follower=
  shift 2
  mkdir -p "$(dirname "$log")"
  : >"$log"
  printf '%s ... ' "$label"
  if [[ -t 1 ]]; then
    follow_log "$label" "$log" &
    follower=$!
  fi
  "$@" >"$log" 2>&1 </dev/null || code=$?
  if [[ -n $follower ]]; then
    kill "$follower" 2>/dev/null || true
    wait "$follower" 2>/dev/null || true
    printf '\r\e[K%s ... ' "$label"
  fi
  if [[ $code == 0 ]]; then
    printf '%d s\n' "$((SECONDS - started))"
    return
  fi
  printf 'failed (%d) after %d s; the end of its log:\n' "$code" "$((SECONDS - started))"
  tail -n 30 -- "$log" | sed 's/^/  /'
  printf 'the whole log: %s\n' "$log"
  return "$code"
}

# configure PRESET FOLDER: a build folder that is there already keeps its generator and build type. What the includer
# has in the array cmake_settings goes to cmake.
configure() {
  local preset=$1 folder=$2 launcher=()
  if [[ -e $folder/CMakeCache.txt ]]; then
    cmake -S "$top" -B "$folder" -DCRSH_ONLY= "${cmake_settings[@]}"
    return
  fi
  if command -v ccache >/dev/null; then launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi
  cmake -S "$top" -B "$folder" --preset "$preset" "${launcher[@]}" "${cmake_settings[@]}"
}

# build PRESET FOLDER TARGET...: configures and builds; without a target, everything.
build() {
  local preset=$1 folder=$2 targets=()
  shift 2
  if [[ $# -gt 0 ]]; then targets=(--target "$@"); fi
  step "configure ${folder##*/}" "$folder/logs/configure.log" configure "$preset" "$folder" &&
    step "build ${folder##*/}${*:+ ($*)}" "$folder/logs/build.log" \
      cmake --build "$folder" --parallel "$(nproc)" "${targets[@]}"
}
