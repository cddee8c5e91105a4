# Sourced by the scripts beside it: what a bare Debian 12 with Rust lacks for them.

# Names what begins, and the seconds since the script did.
step() { printf '\n== %s (%d s)\n' "$*" "$SECONDS"; }

as_root() { if [ "$(id -u)" -eq 0 ]; then "$@"; else sudo "$@"; fi; }

# A C compiler to link with, a software Vulkan driver in place of a GPU, a display for the window, and Python
# for tools.
packages=(gcc libc6-dev python3-venv mesa-vulkan-drivers xvfb libxcursor1 libxi6 libxkbcommon-x11-0)

# Installs those of them, and of the further ones named, that are missing.
install_packages() {
    local missing=() package
    for package in "${packages[@]}" "$@"; do
        dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
    done
    [ "${#missing[@]}" -eq 0 ] && return
    step "install ${missing[*]}"
    as_root apt-get update -qq
    as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}"
}

# What judges the libraries. It runs for seconds: optimised, it would be built for minutes.
install_cargo_deny() {
    command -v cargo-deny >/dev/null || cargo install --quiet --debug --locked cargo-deny@0.20.2
}
