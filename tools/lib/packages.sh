# shellcheck shell=bash
# The Debian packages that crsh needs, and how they are installed. Sourced by tools/demo and tools/test.

# shellcheck disable=SC2034  # the lists are for the includers

# What `cmake -S . -B build && cmake --build build` needs, and a Vulkan driver that needs no GPU.
build_packages=(
  g++ cmake ninja-build ccache
  libvulkan-dev glslang-tools spirv-headers mesa-vulkan-drivers
  libopenexr-dev libzip-dev libstb-dev libglm-dev libfmt-dev libcli11-dev nlohmann-json3-dev libtinygltf-dev
  libpng-dev libjpeg-dev libwebp-dev libavif-dev
  libdraco-dev libmeshoptimizer-dev
  doctest-dev
)

# What crsh-view needs besides.
window_packages=(libglfw3-dev libimgui-dev)

# What the tests want besides: the validation layers, an independent ray tracer and image comparison, a display,
# clang-format, SwiftShader (chromium-common has it), and those who read completions, the manual page and makefiles.
test_packages=(
  vulkan-validationlayers libembree-dev python3-numpy openimageio-tools xvfb xauth openbox
  clang-format zsh fish groff-base make chromium-common
)

# Prints those of the packages that are not installed.
missing_packages() {
  local -A installed=()
  local state package
  while read -r state package; do
    [[ $state == ?i ]] && installed[$package]=yes
  done < <(dpkg-query -W -f '${db:Status-Abbrev} ${Package}\n' "$@" 2>/dev/null)
  for package in "$@"; do
    [[ -n ${installed[$package]-} ]] || printf '%s\n' "$package"
  done
}

# Whether a window's packages are here. Where there is no Debian to ask, CMake will say.
has_window_packages() {
  ! command -v dpkg-query >/dev/null || [[ -z $(missing_packages "${window_packages[@]}") ]]
}

# Sets `as_root` to the words that run a command as root. Fails where nothing does, or where sudo would have to ask
# for a password and there is no terminal to ask at.
find_root() {
  as_root=()
  [[ $EUID == 0 ]] && return
  as_root=(sudo)
  command -v sudo >/dev/null || return 1
  sudo -n true 2>/dev/null || { [[ -t 0 && -t 2 ]] && sudo -v; }
}

apt_install() {
  "${as_root[@]}" apt-get -q update || echo "apt-get update failed: going on with the lists at hand"
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=300 \
    install -y --no-install-recommends "$@"
}

# Prints the line that a person pastes where we may not install.
apt_line() {
  local line="apt-get update && apt-get install -y --no-install-recommends $*"
  if command -v sudo >/dev/null; then
    echo "sudo sh -c '$line'"
  else
    echo "su - -c '$line'"
  fi
}

# Installs what is missing of the packages; does nothing, and asks no network, where nothing is. Log: "$1".
install_packages() {
  local log=$1 missing
  shift
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    echo "no Debian here: nothing is installed; what is missing, cmake will name"
    return
  fi
  mapfile -t missing < <(missing_packages "$@")
  [[ ${#missing[@]} -gt 0 ]] || return 0
  if ! find_root; then
    printf 'These packages are missing, and this user may not install them. Paste this, then run %s again:\n\n  %s\n' \
      "${0##*/}" "$(apt_line "${missing[@]}")" >&2
    return 1
  fi
  step "install ${#missing[@]} packages" "$log" apt_install "${missing[@]}"
}
